#include "pipeline/study/matching/target_manifest.h"

#include <fmt/format.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/reading/manifest_yaml.h"

namespace mien::pipeline {

namespace {

Stimulus stimulus_of(const SampledTarget& target, const TargetSet& set, const Manifest& manifest) {
  Stimulus stimulus = plain_stimulus(manifest);
  stimulus.id = target.id;
  stimulus.role = Role::target;
  NamedValues& values = set.are_features ? stimulus.features : stimulus.adjectives;
  for (std::size_t d = 0; d < set.parameters.size(); ++d)
    values.emplace_back(set.parameters[d], target.place[static_cast<Eigen::Index>(d)]);
  return stimulus;
}

/// With adjectives where the examples are rated: targets that are places of features may be of such
/// that are not.
Matching matching_of(const TargetSet& set) {
  Matching matching;
  matching.participants = 12;
  if (set.are_features) matching.interfaces = {"features", "weights"};
  for (const SampledTarget& target : set.targets)
    (target.practice ? matching.practice : matching.targets).push_back(target.id);
  if (!set.are_features) matching.primary = set.parameters;
  return matching;
}

}  // namespace

Manifest target_manifest(const Manifest& source, const TargetSet& set) {
  Manifest manifest;
  manifest.study = "targets";
  manifest.seed = source.seed;
  manifest.examples = source.examples;
  manifest.ratings = source.ratings;
  manifest.ratings.expected.clear();
  manifest.scales = source.scales;
  for (const SampledTarget& target : set.targets)
    manifest.stimuli.push_back(stimulus_of(target, set, manifest));
  manifest.matching = matching_of(set);
  return manifest;
}

std::string target_manifest_yaml(const Manifest& targets, const TargetSet& set,
                                 const std::filesystem::path& folder) {
  return fmt::format(
             "# Targets of a matching experiment, sampled by mien study targets with seed {}.\n",
             set.seed) +
         manifest_yaml(targets, folder);
}

std::string targets_csv(const TargetSet& set, const std::vector<std::string>& examples,
                        const std::string& ratings) {
  CsvWriter table({"target", "kind", "parameter", "asked", "reached", "source", "ratings",
                   "nearest_example", "distance", "seed"});
  for (const SampledTarget& target : set.targets) {
    for (std::size_t d = 0; d < set.parameters.size(); ++d) {
      table.row({target.id, target.practice ? "practice" : "target", set.parameters[d],
                 shortest(target.place[static_cast<Eigen::Index>(d)]),
                 shortest(target.reached[static_cast<Eigen::Index>(d)]),
                 set.are_features ? "features" : "adjectives", ratings,
                 examples[static_cast<std::size_t>(target.nearest_example)],
                 shortest(target.distance), std::to_string(set.seed)});
    }
  }
  return table.text();
}

}  // namespace mien::pipeline
