#include "pipeline/repertoire.h"

#include <fmt/format.h>

#include "motion/builtin_sets.h"
#include "motion/example_set.h"
#include "motion/settled_feet.h"
#include "pipeline/measured_profiles.h"
#include "pipeline/simulated_raters.h"

namespace mien::pipeline {

namespace {

motion::CycleChoice cycle_choice(Examples::Cycle cycle) {
  switch (cycle) {
    case Examples::Cycle::automatic:
      return motion::CycleChoice::automatic;
    case Examples::Cycle::whole:
      return motion::CycleChoice::whole;
    case Examples::Cycle::start_peak_end:
      break;
  }
  return motion::CycleChoice::start_peak_end;
}

motion::ExampleFolder example_folder(const Examples& examples) {
  motion::ExampleFolder folder;
  folder.path = examples.folder;
  folder.include = examples.include;
  folder.exclude = examples.exclude;
  folder.cycle = cycle_choice(examples.cycle);
  folder.keytimes = examples.keytimes;
  folder.shorten_names = examples.labels == Examples::Labels::from_name;
  folder.names = examples.given_labels;
  return folder;
}

void load_examples(const Manifest& manifest, Repertoire& repertoire) {
  const Examples& examples = manifest.examples;
  if (!examples.builtin.empty()) {
    repertoire.examples = motion::builtin_examples(examples.builtin);
    for (const motion::Example& example : repertoire.examples.examples) {
      repertoire.names.push_back({example.name, ""});
    }
    return;
  }
  motion::LoadedExamples loaded = motion::load_examples(example_folder(examples));
  repertoire.examples = std::move(loaded.set);
  repertoire.warnings = std::move(loaded.warnings);
  for (size_t i = 0; i < loaded.file_stems.size(); ++i) {
    repertoire.names.push_back({repertoire.examples.examples[i].name, loaded.file_stems[i]});
  }
}

/// What simulated raters see: the parameters of the styles, or measures of the motions.
std::vector<StyledStimulus> profiles_of(const Manifest& manifest, const Repertoire& repertoire) {
  if (manifest.examples.builtin.empty()) return measured_profiles(repertoire.examples);
  const auto profiles = motion::builtin_profiles(manifest.examples.builtin);
  std::vector<StyledStimulus> stimuli;
  for (size_t i = 0; i < profiles.size(); ++i) {
    stimuli.push_back({repertoire.names[i].name, profiles[i]});
  }
  return stimuli;
}

/// Scales and examples, without ratings.
Repertoire unrated_repertoire(const Manifest& manifest) {
  Repertoire repertoire;
  repertoire.scales =
      manifest.scales.file.empty() ? builtin_scales() : read_scales(manifest.scales.file);
  if (manifest.examples.builtin.empty() && manifest.examples.folder.empty()) return repertoire;
  load_examples(manifest, repertoire);
  repertoire.settled = motion::with_settled_feet(repertoire.examples);
  repertoire.features = feature_parameters(repertoire.settled);
  return repertoire;
}

Answers simulated_answers(const Manifest& manifest, const Repertoire& repertoire) {
  return simulate_answers(profiles_of(manifest, repertoire), repertoire.scales,
                          {.count = manifest.ratings.raters, .seed = manifest.seed});
}

}  // namespace

std::vector<std::filesystem::path> repertoire_files(const Manifest& manifest) {
  std::vector<std::filesystem::path> files;
  if (manifest.examples.builtin.empty() && !manifest.examples.folder.empty()) {
    files = motion::example_files(example_folder(manifest.examples));
  }
  if (!manifest.scales.file.empty()) files.push_back(manifest.scales.file);
  if (manifest.ratings.source == Ratings::Source::file) files.push_back(manifest.ratings.file);
  return files;
}

std::vector<std::string> example_names(const Manifest& manifest) {
  const Examples& examples = manifest.examples;
  if (!examples.builtin.empty()) {
    std::vector<std::string> names;
    for (const auto& [name, style] : motion::builtin_styles(examples.builtin))
      names.push_back(name);
    return names;
  }
  if (examples.folder.empty()) return {};
  return motion::example_names(example_folder(examples));
}

Answers simulated_answers(const Manifest& manifest) {
  return simulated_answers(manifest, unrated_repertoire(manifest));
}

Repertoire load_repertoire(const Manifest& manifest) {
  Repertoire repertoire = unrated_repertoire(manifest);
  if (repertoire.names.empty() || manifest.ratings.source == Ratings::Source::none) {
    return repertoire;
  }
  const Answers answers = manifest.ratings.source == Ratings::Source::file
                              ? read_answers(manifest.ratings.file, repertoire.scales)
                              : simulated_answers(manifest, repertoire);
  repertoire.impressions = impressions_of(answers, repertoire.scales, repertoire.names);
  repertoire.parameters = parameter_table(*repertoire.impressions, repertoire.scales);
  repertoire.simulated_ratings = answers.simulated;
  return repertoire;
}

}  // namespace mien::pipeline
