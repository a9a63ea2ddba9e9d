#include "pipeline/commands/motion/change.h"

#include <filesystem>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "pipeline/manifest/checks/manifest_reader.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// An equivalent manifest of one stimulus, which is checked in place of the options. File names are
/// variables in it, so that special characters are not interpreted by YAML.
std::string manifest_of(const Change& options) {
  std::string change = options.change;
  if (!change.starts_with('{') && !change.starts_with('['))
    change =
        change.find(':') == std::string::npos ? "{emotion: " + change + "}" : "{" + change + "}";
  // Any motion serves as a placeholder for a stream.
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

/// A fault worded for the command line instead of a manifest.
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
