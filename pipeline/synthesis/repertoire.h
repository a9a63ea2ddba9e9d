#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "motion/skeleton/example.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/ratings/feature_parameters.h"
#include "pipeline/ratings/impressions.h"
#include "pipeline/ratings/scales.h"

namespace mien::pipeline {

/// What a study has to make motions from: its examples and what people think of them.
struct Repertoire {
  motion::ExampleSet examples;
  motion::ExampleSet settled;       ///< the same with their feet locked (settled_feet.h)
  std::vector<RatedExample> names;  ///< aligned with the examples
  ScaleSet scales;
  std::optional<Impressions> impressions;
  ParameterTable parameters;  ///< empty without ratings
  FeatureParameters features;
  bool simulated_ratings = false;
  std::vector<std::string> warnings;  ///< plain sentences
};

/// Files that the repertoire is made of: they determine every clip that is made from it.
std::vector<std::filesystem::path> repertoire_files(const Manifest& manifest);

/// Names of the examples, found without reading a motion. Throws Error.
std::vector<std::string> example_names(const Manifest& manifest);

/// The examples as answers may name them, found without reading a motion. Throws Error.
std::vector<RatedExample> rated_examples(const Manifest& manifest);

/// What simulated raters say about the examples on the manifest's scales, whatever ratings it
/// names. Throws Error.
Answers simulated_answers(const Manifest& manifest);

/// Reads, maps, cuts and aligns the examples, and averages their ratings. Throws Error.
Repertoire load_repertoire(const Manifest& manifest);

}  // namespace mien::pipeline
