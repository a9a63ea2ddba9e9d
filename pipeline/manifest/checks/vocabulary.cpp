#include "pipeline/manifest/checks/vocabulary.h"

#include <algorithm>
#include <set>

#include "pipeline/manifest/example_files.h"
#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/manifest/ratings/scales/feature_parameters.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

namespace {

/// Scales that every example has answers on. Throws Error where some example has none.
std::vector<std::string> answered_scales(const Manifest& manifest, const ScaleSet& scales) {
  const Answers answers = given_answers(manifest);
  const std::vector<RatedExample> examples = rated_examples(manifest);
  try {
    return impressions_of(answers, scales, examples).scales;
  } catch (const Error& error) {
    const std::string path = "examples.ratings";
    throw Faults(std::vector<Fault>{{place_of(manifest.places, path), path, error.what(), ""}});
  }
}

std::set<std::string> rated_scales(const Manifest& manifest, const ScaleSet& scales) {
  std::set<std::string> rated;
  if (manifest.ratings.source == Ratings::Source::file) {
    for (const std::string& scale : answered_scales(manifest, scales)) rated.insert(scale);
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

/// Whether no other names of examples are valid; a missing folder may have any.
bool knows_all(const std::vector<std::string>& examples, const Manifest& manifest) {
  return !examples.empty() || !manifest.places.values.contains("examples");
}

}  // namespace

Vocabulary vocabulary_of(const Manifest& manifest) {
  Vocabulary vocabulary{rated_parameters(manifest), feature_parameter_names(), {}};
  vocabulary.examples = example_names(manifest);
  vocabulary.file_stems = stems_in_folder(manifest.examples);
  vocabulary.knows_examples = knows_all(vocabulary.examples, manifest);
  return vocabulary;
}

Vocabulary certain_vocabulary(const Manifest& manifest) {
  Vocabulary vocabulary{{}, feature_parameter_names(), {}};
  try {
    vocabulary.examples = example_names(manifest);
  } catch (const Error&) {
    // Reported by vocabulary_of.
  }
  vocabulary.knows_examples = knows_all(vocabulary.examples, manifest);
  return vocabulary;
}

}  // namespace mien::pipeline
