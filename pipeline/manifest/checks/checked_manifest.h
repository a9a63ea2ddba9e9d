#pragma once

#include <filesystem>
#include <string_view>

#include "pipeline/manifest/checks/manifest_reader.h"

namespace mien::pipeline {

/// Reads a manifest and finds everything wrong with it, names of examples and parameters included.
/// A run would write to <out>/<study>, where none of its sources may lie; empty: nothing is run.
ManifestReading check_manifest(const std::filesystem::path& file, const Environment& environment,
                               const std::filesystem::path& out = {});

/// Checks a text as if it were the content of `file`, which is not read.
ManifestReading check_manifest_text(std::string_view text, const std::filesystem::path& file,
                                    const Environment& environment,
                                    const std::filesystem::path& out = {});

/// The manifest; throws Faults that list everything wrong with it.
Manifest load_manifest(const std::filesystem::path& file, const Environment& environment,
                       const std::filesystem::path& out = {});

}  // namespace mien::pipeline
