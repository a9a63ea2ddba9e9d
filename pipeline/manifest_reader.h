#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/fault.h"
#include "pipeline/manifest.h"

namespace mien::pipeline {

/// Looks up an environment variable.
using Environment = std::function<std::optional<std::string>(const std::string&)>;

/// The environment of this process.
Environment process_environment();

/// A manifest and what is wrong with it. Values that are at fault keep their defaults, so that
/// checks of meaning can go on and all faults come in one list.
struct ManifestReading {
  Manifest manifest;
  std::vector<Fault> faults;
};

/// Reads YAML, expands ${NAME} and ${NAME:-default} in its strings, validates it against the JSON
/// Schema and checks what can be checked without knowing the examples: ids, sizes, files, sheets.
/// Relative paths are taken from the folder of `file`. Never throws for what the text says.
ManifestReading parse_manifest(std::string_view text, const std::filesystem::path& file,
                               const Environment& environment);

/// As above from a file; a file that cannot be read is a fault too.
ManifestReading read_manifest(const std::filesystem::path& file, const Environment& environment);

/// Names that a manifest's values may refer to.
struct Vocabulary {
  std::vector<std::string> parameters;  ///< groups and scales
  std::vector<std::string> examples;
};

/// Adjectives, weights and sheets that name what does not exist.
std::vector<Fault> check_names(const Manifest& manifest, const Vocabulary& vocabulary);

}  // namespace mien::pipeline
