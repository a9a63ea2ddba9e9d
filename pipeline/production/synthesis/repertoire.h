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

/// The repertoire of a study: its examples and their ratings.
struct Repertoire {
  motion::ExampleSet examples;
  motion::ExampleSet settled;                  ///< the examples with locked feet (settled_feet.h)
  std::vector<RatedExample> names;             ///< one per example
  std::vector<motion::ExampleOrigin> origins;  ///< one per example; empty for built-in ones
  ScaleSet scales;
  Answers answers;  ///< the answers from which the impressions are averaged
  std::optional<Impressions> impressions;
  ParameterTable parameters;  ///< empty without ratings
  FeatureParameters features;
  bool simulated_ratings = false;
  std::vector<std::string> warnings;  ///< plain sentences
};

/// Returns the answers of simulated raters about the examples on the manifest's scales, whatever
/// ratings it names. Throws Error.
Answers simulated_answers(const Manifest& manifest);

/// Reads, retargets, trims and time-aligns the examples, or makes the built-in ones, and averages
/// their ratings. Throws Error.
Repertoire load_repertoire(const Manifest& manifest);

}  // namespace mien::pipeline
