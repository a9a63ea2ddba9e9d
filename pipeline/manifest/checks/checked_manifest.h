#pragma once

#include <filesystem>
#include <string_view>

#include "pipeline/manifest/checks/manifest_reader.h"

namespace mien::pipeline {

/// Reads a manifest and reports all of its faults, including unknown names of examples and
/// parameters. A run would write to <out>/<study>, which must contain none of the manifest's source
/// files, except in its folder `inputs`; with an empty `out`, this is not checked.
///
/// If `file` is a study's provenance.json, the manifest that reproduces the study is read, without
/// warnings about deprecated names.
ManifestReading check_manifest(const std::filesystem::path& file, const Environment& environment,
                               const std::filesystem::path& out = {});

/// Checks a text as if it were the content of `file`, which is not read.
ManifestReading check_manifest_text(std::string_view text, const std::filesystem::path& file,
                                    const Environment& environment,
                                    const std::filesystem::path& out = {});

/// Returns the manifest. Throws Faults that list all of its faults.
Manifest load_manifest(const std::filesystem::path& file, const Environment& environment,
                       const std::filesystem::path& out = {});

}  // namespace mien::pipeline
