#include "pipeline/checks/vocabulary.h"

#include <algorithm>
#include <set>
#include <string>

#include "pipeline/manifest/example_files.h"
#include "pipeline/ratings/answers.h"
#include "pipeline/ratings/feature_parameters.h"
#include "pipeline/ratings/scales.h"

namespace mien::pipeline {

namespace {

std::set<std::string> rated_scales(const Manifest& manifest, const ScaleSet& scales) {
  std::set<std::string> rated;
  if (manifest.ratings.source == Ratings::Source::file) {
    for (const Answer& answer : read_answers(manifest.ratings.file, scales).answers) {
      rated.insert(answer.scale);
    }
  } else if (manifest.ratings.source != Ratings::Source::none) {
    for (const Scale& scale : scales.scales) rated.insert(scale.id);
  }
  return rated;
}

std::vector<std::string> rated_parameters(const Manifest& manifest) {
  const ScaleSet scales = scales_of(manifest.scales);
  const std::set<std::string> rated = rated_scales(manifest, scales);
  const auto is_rated = [&](const std::string& scale) { return rated.contains(scale); };
  std::vector<std::string> parameters;
  for (const ScaleGroup& group : scales.groups) {
    if (std::any_of(group.scales.begin(), group.scales.end(), is_rated)) {
      parameters.push_back(group.id);
    }
  }
  for (const Scale& scale : scales.scales) {
    if (is_rated(scale.id)) parameters.push_back(scale.id);
  }
  return parameters;
}

}  // namespace

Vocabulary vocabulary_of(const Manifest& manifest) {
  return {rated_parameters(manifest), feature_parameter_names(), example_names(manifest)};
}

}  // namespace mien::pipeline
