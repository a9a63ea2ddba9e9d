#include "motion/interpolation/parameter_table.h"

#include <algorithm>

#include "motion/error.h"

namespace mien::motion {

int ParameterTable::find(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

Eigen::Index parameter_row(const std::string& name, const ParameterTable& table) {
  const int row = table.find(name);
  if (row >= 0) return row;
  throw Error("the examples have no parameter \"" + name + "\"",
              "name a scale that was rated, or a feature that all examples have");
}

Eigen::MatrixXd places_of_examples(std::span<const std::string> parameters,
                                   const ParameterTable& table) {
  Eigen::MatrixXd places(table.values.cols(), static_cast<Eigen::Index>(parameters.size()));
  for (Eigen::Index i = 0; i < places.cols(); ++i) {
    const std::string& name = parameters[static_cast<std::size_t>(i)];
    places.col(i) = table.values.row(parameter_row(name, table)).transpose();
  }
  return places;
}

}  // namespace mien::motion
