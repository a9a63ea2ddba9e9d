#include "pipeline/study/matching/primary_parameters.h"

namespace mien::pipeline {

std::vector<std::string> primary_adjectives(const Repertoire& repertoire) {
  std::vector<std::string> groups;
  for (const ScaleGroup& group : repertoire.scales.groups)
    if (repertoire.parameters.find(group.id) >= 0) groups.push_back(group.id);
  return groups.empty() ? repertoire.parameters.names : groups;
}

std::vector<std::string> primary_features() {
  std::vector<std::string> names = feature_parameter_names();
  names.resize(motion::feature_group_count);
  return names;
}

}  // namespace mien::pipeline
