#include "pipeline/matching/target_manifest.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pipeline/documents/csv.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// JSON strings are YAML; "${" would begin a variable.
std::string as_yaml(std::string text) {
  for (std::size_t at = text.find("${"); at != std::string::npos; at = text.find("${", at + 3)) {
    text.insert(at, "$");
  }
  return nlohmann::json(text).dump();
}

std::string path_from(const fs::path& folder, const fs::path& path) {
  return as_yaml(fs::proximate(fs::absolute(path), fs::absolute(folder)).generic_string());
}

std::string labels_of(const Examples& examples) {
  if (examples.given_labels.empty()) {
    return examples.labels == Examples::Labels::from_name ? "from-name" : "file-name";
  }
  std::string map;
  for (const auto& [stem, label] : examples.given_labels) {
    map += fmt::format("{}{}: {}", map.empty() ? "" : ", ", as_yaml(stem), as_yaml(label));
  }
  return "{" + map + "}";
}

std::string set_of(const Examples& examples, const fs::path& folder) {
  if (!examples.builtin.empty()) return "  set: builtin:" + examples.builtin + "\n";
  std::string text = "  set:\n    folder: " + path_from(folder, examples.folder) +
                     "\n    include: " + as_yaml(examples.include) + "\n";
  if (!examples.exclude.empty()) text += "    exclude: " + as_yaml(examples.exclude) + "\n";
  const bool whole = examples.cycle == Examples::Cycle::whole;
  return text + "    cycle: " + (whole ? "whole" : "auto") +
         "\n    labels: " + labels_of(examples) + "\n";
}

std::string ratings_of(const Manifest& source, const fs::path& folder) {
  switch (source.ratings.source) {
    case Ratings::Source::none:
      return "  ratings: none\n";
    case Ratings::Source::builtin:
      return "  ratings: builtin\n";
    case Ratings::Source::simulated:
      return fmt::format("  ratings: simulated\n  raters: {}\n", source.ratings.raters);
    case Ratings::Source::file:
      break;
  }
  return "  ratings: " + path_from(folder, source.ratings.file) + "\n";
}

std::string stimulus_of(const SampledTarget& target, const TargetSet& set) {
  std::string values;
  for (std::size_t d = 0; d < set.parameters.size(); ++d) {
    values += fmt::format("{}{}: {}", d == 0 ? "" : ", ", set.parameters[d],
                          shortest(target.place[static_cast<Eigen::Index>(d)]));
  }
  return fmt::format("  - {{id: {}, role: target, {}: {{{}}}}}\n", target.id,
                     set.are_features ? "features" : "adjectives", values);
}

}  // namespace

std::string target_manifest(const Manifest& source, const TargetSet& set, const fs::path& folder) {
  std::string text = fmt::format(
      "# Targets of a matching experiment, sampled by mien study targets with seed {}.\n"
      "mien: 1\nstudy: targets\nseed: {}\n\nexamples:\n",
      set.seed, source.seed);
  text += set_of(source.examples, folder) + ratings_of(source, folder);
  if (!source.scales.file.empty()) {
    text += "  scales: " + path_from(folder, source.scales.file) + "\n";
  }
  text += "\nstimuli:\n";
  for (const SampledTarget& target : set.targets) text += stimulus_of(target, set);
  return text;
}

std::string targets_csv(const TargetSet& set, const std::vector<std::string>& examples,
                        const std::string& ratings) {
  CsvWriter table({"target", "kind", "parameter", "value", "source", "ratings", "nearest_example",
                   "distance", "seed"});
  for (const SampledTarget& target : set.targets) {
    for (std::size_t d = 0; d < set.parameters.size(); ++d) {
      table.row({target.id, target.practice ? "practice" : "target", set.parameters[d],
                 shortest(target.place[static_cast<Eigen::Index>(d)]),
                 set.are_features ? "features" : "adjectives", ratings,
                 examples[static_cast<std::size_t>(target.nearest_example)],
                 shortest(target.distance), std::to_string(set.seed)});
    }
  }
  return table.text();
}

}  // namespace mien::pipeline
