#include "pipeline/study/matching/target_manifest.h"

#include <fmt/format.h>

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

struct TargetParameter {
  const TargetSet& set;
  const SampledTarget& target;
  std::size_t parameter;
  std::string ratings;
  std::string nearest;

  double at(const Eigen::RowVectorXd& place) const {
    return place[static_cast<Eigen::Index>(parameter)];
  }
};

constexpr auto targets_columns = table_of<TargetParameter>(
    "targets.csv", "target and parameter",
    {{"target", "", "id of the target", [](auto& r) { return r.target.id; }},
     {"kind", "", "target or practice",
      [](auto& r) { return r.target.practice ? "practice" : "target"; }},
     {"parameter", "", "adjective or motion feature",
      [](auto& r) { return r.set.parameters[r.parameter]; }},
     {"requested", "0–1", "value at which the target was sampled",
      [](auto& r) { return r.at(r.target.place); }},
     {"reached", "0–1", "value of the blend", [](auto& r) { return r.at(r.target.reached); }},
     {"source", "", "adjectives or features",
      [](auto& r) { return r.set.are_features ? "features" : "adjectives"; }},
     {"ratings", "", "given (by people), simulated or none", [](auto& r) { return r.ratings; }},
     {"nearest_example", "", "label of the example nearest to it",
      [](auto& r) { return r.nearest; }},
     {"distance", "", "distance from that example in the space of the parameters",
      [](auto& r) { return r.target.distance; }},
     {"seed", "", "seed of the sampling", [](auto& r) { return r.set.seed; }}});

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

WrittenTable targets_table(const TargetSet& set, const std::vector<std::string>& examples,
                           const std::string& ratings) {
  std::vector<TargetParameter> rows;
  for (const SampledTarget& target : set.targets)
    for (std::size_t d = 0; d < set.parameters.size(); ++d)
      rows.push_back(
          {set, target, d, ratings, examples[static_cast<std::size_t>(target.nearest_example)]});
  return targets_columns.of(rows);
}

}  // namespace mien::pipeline
