#include "pipeline/manifest/adaptive_plan.h"

#include "motion/error.h"
#include "pipeline/manifest/example_files.h"
#include "pipeline/manifest/ratings/scales/feature_parameters.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

namespace {

using Names = std::vector<std::string>;

Names example_names_if_known(const Manifest& manifest) {
  try {
    return example_names(manifest);
  } catch (const Error&) {
    return {};  // the checks of examples report it
  }
}

}  // namespace

Names known_dimensions(const Manifest& manifest, MotionSpace::Kind kind) {
  Names names;
  switch (kind) {
    case MotionSpace::Kind::groups:
      for (const ScaleGroup& group : scales_of(manifest.scales).groups) names.push_back(group.id);
      break;
    case MotionSpace::Kind::scales:
      for (const Scale& scale : scales_of(manifest.scales).scales) names.push_back(scale.id);
      break;
    case MotionSpace::Kind::features:
      names = feature_parameter_names();
      break;
    case MotionSpace::Kind::weights:
      names = example_names_if_known(manifest);
      break;
    case MotionSpace::Kind::components:
    case MotionSpace::Kind::recipe:
      break;
  }
  return names;
}

Names dimension_names(const Manifest& manifest) {
  const MotionSpace& space = manifest.adaptive->space;
  if (space.kind == MotionSpace::Kind::components) {
    Names names;
    for (int i = 1; i <= space.components; ++i) names.push_back("component-" + std::to_string(i));
    return names;
  }
  if (space.kind == MotionSpace::Kind::recipe) {
    Names names;
    for (const auto& [name, limits] : dimensions_of(space.recipe)) names.push_back(name);
    return names;
  }
  if (!space.names.empty()) return space.names;
  return space.kind == MotionSpace::Kind::features ? feature_group_names()
                                                   : known_dimensions(manifest, space.kind);
}

std::size_t dimension_count(const Manifest& manifest) { return dimension_names(manifest).size(); }

double chain_steps(const Manifest& manifest) {
  const Adaptive& adaptive = *manifest.adaptive;
  const double each =
      adaptive.method == ChainMethod::gibbs ? static_cast<double>(dimension_count(manifest)) : 1.0;
  return each * (adaptive.until ? adaptive.until->at_most : adaptive.iterations);
}

}  // namespace mien::pipeline
