#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/documents/environment.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/reading/resolved_manifest.h"

namespace mien::pipeline {

/// A manifest and its faults. Invalid values keep their defaults, so that semantic checks can
/// continue and all faults are reported together.
struct ManifestReading {
  Manifest manifest;
  std::vector<Fault> faults;  ///< in reading order
};

/// Reads YAML, expands ${NAME} and ${NAME:-default}, validates against the JSON Schema and performs
/// the checks that do not need the examples (check_meaning). Relative paths are resolved against
/// the folder of `file`, and `paths` may replace them. Never throws because of the text's content.
ManifestReading parse_manifest(std::string_view text, const std::filesystem::path& file,
                               const Environment& environment, const PathVisitor& paths = {});

/// A file or folder that a manifest names.
struct NamedFile {
  std::string text;            ///< as written in the manifest
  std::filesystem::path file;  ///< resolved path
};

/// Returns all files and folders named anywhere in a manifest's text, without opening them. Throws
/// the faults of read_json, such as text that is not YAML and unset variables, as Faults; the
/// schema is not checked.
std::vector<NamedFile> named_files(std::string_view text, const std::filesystem::path& file,
                                   const Environment& environment);

/// Like parse_manifest, from a file. If the file cannot be read or contains another kind of
/// document (scales, a set, recipes), that is reported as the only fault.
ManifestReading read_manifest(const std::filesystem::path& file, const Environment& environment,
                              const PathVisitor& paths = {});

}  // namespace mien::pipeline
