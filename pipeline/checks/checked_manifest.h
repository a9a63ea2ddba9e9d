#pragma once

#include <filesystem>

#include "pipeline/checks/manifest_reader.h"

namespace mien::pipeline {

/// Reads a manifest and finds everything wrong with it, names of examples and parameters included.
ManifestReading check_manifest(const std::filesystem::path& file, const Environment& environment);

/// The manifest; throws Faults that list everything wrong with it.
Manifest load_manifest(const std::filesystem::path& file, const Environment& environment);

}  // namespace mien::pipeline
