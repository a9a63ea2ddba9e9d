#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/examples/example_set.h"
#include "motion/skeleton/example.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/manifest/ratings/scales/feature_parameters.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// What a study has to make motions from: its examples and what people think of them.
struct Repertoire {
  motion::ExampleSet examples;
  motion::ExampleSet settled;                  ///< the same with their feet locked (settled_feet.h)
  std::vector<RatedExample> names;             ///< aligned with the examples
  std::vector<motion::ExampleOrigin> origins;  ///< aligned with the examples; none of built-in ones
  ScaleSet scales;
  Answers answers;  ///< that the impressions are means of
  std::optional<Impressions> impressions;
  ParameterTable parameters;  ///< empty without ratings
  FeatureParameters features;
  bool simulated_ratings = false;
  std::vector<std::string> warnings;  ///< plain sentences
};

/// What simulated raters say about the examples on the manifest's scales, whatever ratings it
/// names. Throws Error.
Answers simulated_answers(const Manifest& manifest);

/// Reads, maps, cuts and aligns the examples, and averages their ratings. Throws Error.
Repertoire load_repertoire(const Manifest& manifest);

}  // namespace mien::pipeline
