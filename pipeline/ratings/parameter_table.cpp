#include "pipeline/ratings/parameter_table.h"

#include <algorithm>

namespace mien::pipeline {

int ParameterTable::find(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

}  // namespace mien::pipeline
