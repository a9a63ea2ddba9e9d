#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/commands/line/console.h"

namespace mien::pipeline {

/// The folder with the manifests, scales and schemas that belong to a program:
/// ../share/mien/manifests for an installed program (<prefix>/bin/mien), or manifests/ of the
/// source tree for a program in <tree>/build/<preset>. Empty if neither exists.
///
/// No path is compiled in, so that installations and source trees can be moved.
std::filesystem::path manifests_beside(const std::filesystem::path& program);

/// The folder of installed manifests for the running program (manifests_beside).
std::filesystem::path installed_manifests();

/// Names of the manifests in a folder, without extension and in alphabetical order: its files
/// *.yaml, except those with another extension before it, such as *.scales.yaml and *.recipes.yaml.
/// Empty if the folder cannot be read.
std::vector<std::string> manifest_names(const std::filesystem::path& folder);

/// The file in `folder` that `name` means: "quickstart" or "manifests/quickstart", with or without
/// ".yaml". Empty if there is none, or if `name` contains another folder.
std::optional<std::filesystem::path> find_named_file(const std::filesystem::path& folder,
                                                     const std::string& name);

/// Returns `name` if that file exists. If not, returns the path of the installed file of that name
/// and prints a message on `console.err`. If there is none either, returns `name`.
std::string resolve_input_file(const std::string& name, const Console& console);

/// Like resolve_input_file, for a manifest. Throws Error for a name without folder and extension
/// that is neither that of a file nor that of an installed manifest.
std::string resolve_manifest(const std::string& name, const Console& console);

}  // namespace mien::pipeline
