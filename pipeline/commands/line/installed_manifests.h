#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/commands/line/console.h"

namespace mien::pipeline {

/// The folder of the manifests, scales and schemas that came with a program:
/// ../share/mien/manifests beside an installed one (<prefix>/bin/mien), manifests of the source
/// tree beside one that was built in <tree>/build/<preset>. Empty when there is neither.
///
/// Nothing is compiled in, so that a prefix may be moved and a tree copied.
std::filesystem::path manifests_beside(const std::filesystem::path& program);

/// That folder for the program that is running.
std::filesystem::path installed_manifests();

/// Names of the manifests in a folder, without their ending and in alphabetical order; files of
/// scales (*.scales.yaml) and recipes (*.recipes.yaml) are none.
std::vector<std::string> manifest_names(const std::filesystem::path& folder);

/// The file of `folder` that is called `name`, "manifests/<name>" or either without ".yaml". Empty
/// when there is none, or when `name` says another folder.
std::optional<std::filesystem::path> file_among(const std::filesystem::path& folder,
                                                const std::string& name);

/// `name` when there is such a file; otherwise the installed file of that name, which is told on
/// `console.err`; otherwise `name`.
std::string given_or_installed(const std::string& name, const Console& console);

/// The same for a manifest. Throws Error for a single word that is neither a file nor the name of
/// an installed manifest.
std::string manifest_meant(const std::string& name, const Console& console);

}  // namespace mien::pipeline
