#include "pipeline/commands/motion/change.h"

#include <filesystem>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "pipeline/manifest/checks/manifest_reader.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// A manifest of one stimulus says the same, so it is what is checked and made. Names of files are
/// variables in it: whatever stands in them, YAML does not see it.
std::string manifest_of(const Change& options) {
  std::string change = options.change;
  if (!change.starts_with('{') && !change.starts_with('['))
    change =
        change.find(':') == std::string::npos ? "{emotion: " + change + "}" : "{" + change + "}";
  // A motion that is still to come is stood in for by any.
  const std::string motion =
      options.in.empty() ? "weights: {woman-walk-neutral: 1}" : "clip: '${MIEN_MOTION}'";
  return fmt::format(
      "mien: 1\nstudy: modify\nrecipes: '${{MIEN_RECIPES}}'\non_fault: {}\n{}"
      "stimuli:\n- id: motion\n  {}\n  modify: {}\n",
      options.on_fault, options.in.empty() ? "examples: {set: builtin:actors}\n" : "", motion,
      change);
}

Environment environment_of(const Change& options) {
  return [&options](const std::string& name) -> std::optional<std::string> {
    if (name == "MIEN_MOTION") return options.in;
    if (name == "MIEN_RECIPES") return options.recipes;
    return process_environment()(name);
  };
}

/// As somebody reads it who has written no manifest.
Fault without_manifest(Fault fault, const fs::path& manifest) {
  constexpr std::string_view stimulus = "stimuli[0].";
  if (fault.place.file == manifest.string()) fault.place = {};
  if (fault.path.starts_with(stimulus)) fault.path.erase(0, stimulus.size());
  return fault;
}

}  // namespace

Stimulus stimulus_of(const Change& change) {
  const fs::path here = fs::current_path() / "command line";
  ManifestReading reading = parse_manifest(manifest_of(change), here, environment_of(change));
  if (!reading.faults.empty()) {
    for (Fault& fault : reading.faults) fault = without_manifest(std::move(fault), here);
    throw Faults(std::move(reading.faults));
  }
  return std::move(reading.manifest.stimuli.front());
}

}  // namespace mien::pipeline
