#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/documents/environment.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A manifest and what is wrong with it. Values at fault keep their defaults, so that checks of
/// meaning can go on and all faults come in one list.
struct ManifestReading {
  Manifest manifest;
  std::vector<Fault> faults;  ///< in reading order
};

/// Reads YAML, expands ${NAME} and ${NAME:-default}, validates against the JSON Schema and checks
/// what can be checked without knowing the examples (check_meaning). Relative paths are taken from
/// the folder of `file`. Never throws for what the text says.
ManifestReading parse_manifest(std::string_view text, const std::filesystem::path& file,
                               const Environment& environment);

/// A file or folder that a manifest names.
struct NamedFile {
  std::string text;            ///< as it is written
  std::filesystem::path file;  ///< as it would be opened
};

/// All that a manifest's text names, wherever in it. Opens none of them. Throws Faults for
/// what is no YAML; what the schema says of it is not looked at.
std::vector<NamedFile> named_files(std::string_view text, const std::filesystem::path& file,
                                   const Environment& environment);

/// Like parse_manifest, from a file; a file that cannot be read is a fault too.
ManifestReading read_manifest(const std::filesystem::path& file, const Environment& environment);

}  // namespace mien::pipeline
