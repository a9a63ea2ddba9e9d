#include "pipeline/production/synthesis/repertoire.h"

#include <fmt/format.h>

#include "motion/examples/settled_feet.h"
#include "motion/procedural/builtin_sets.h"
#include "pipeline/manifest/example_files.h"
#include "pipeline/manifest/ratings/simulated_raters/simulated_raters.h"
#include "pipeline/tasks/parallel.h"

namespace mien::pipeline {

namespace {

motion::ExampleSet made_examples(const std::string& builtin) {
  const std::vector<motion::ExampleMaker> makers = motion::builtin_example_makers(builtin);
  motion::ExampleSet set = motion::empty_example_set(builtin);
  set.examples.resize(makers.size());
  on_all_processors(makers.size(), [&](std::size_t i) { set.examples[i] = makers[i].make(); });
  return set;
}

motion::ExampleSet settled_examples(motion::ExampleSet set) {
  on_all_processors(set.examples.size(), [&](std::size_t i) {
    set.examples[i].clip = motion::with_settled_feet(set.examples[i].clip);
  });
  return set;
}

void load_examples(const Manifest& manifest, Repertoire& repertoire) {
  const Examples& examples = manifest.examples;
  if (!examples.builtin.empty()) {
    repertoire.examples = made_examples(examples.builtin);
    for (const motion::Example& example : repertoire.examples.examples) {
      repertoire.names.push_back({example.name, ""});
    }
    return;
  }
  motion::LoadedExamples loaded = motion::load_examples(example_folder(examples));
  repertoire.examples = std::move(loaded.set);
  repertoire.warnings = std::move(loaded.warnings);
  repertoire.origins = std::move(loaded.origins);
  for (size_t i = 0; i < loaded.file_stems.size(); ++i) {
    repertoire.names.push_back({repertoire.examples.examples[i].name, loaded.file_stems[i]});
  }
}

/// Scales and examples, without ratings.
Repertoire unrated_repertoire(const Manifest& manifest) {
  Repertoire repertoire;
  repertoire.scales = scales_of(manifest.scales);
  if (manifest.examples.builtin.empty() && manifest.examples.folder.empty()) return repertoire;
  load_examples(manifest, repertoire);
  repertoire.settled = settled_examples(repertoire.examples);
  repertoire.features = feature_parameters(repertoire.settled);
  return repertoire;
}

Answers simulated_answers(const Manifest& manifest, const Repertoire& repertoire) {
  return simulate_answers(measured_profiles(repertoire.examples), repertoire.scales,
                          {.count = manifest.ratings.raters, .seed = manifest.seed});
}

}  // namespace

Answers simulated_answers(const Manifest& manifest) {
  return simulated_answers(manifest, unrated_repertoire(manifest));
}

Repertoire load_repertoire(const Manifest& manifest) {
  Repertoire repertoire = unrated_repertoire(manifest);
  if (repertoire.names.empty() || manifest.ratings.source == Ratings::Source::none) {
    return repertoire;
  }
  repertoire.answers = manifest.ratings.source == Ratings::Source::file
                           ? given_answers(manifest)
                           : simulated_answers(manifest, repertoire);
  const Answers& answers = repertoire.answers;
  repertoire.impressions = impressions_of(answers, repertoire.scales, repertoire.names);
  repertoire.parameters = parameter_table(*repertoire.impressions, repertoire.scales);
  repertoire.simulated_ratings = answers.simulated;
  repertoire.warnings.insert(repertoire.warnings.end(), answers.warnings.begin(),
                             answers.warnings.end());
  return repertoire;
}

}  // namespace mien::pipeline
