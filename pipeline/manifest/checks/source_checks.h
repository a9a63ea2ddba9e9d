#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Files that the manifest reads out of `folder`, in which its run writes: it would replace them.
std::vector<Fault> check_sources(const Manifest& manifest, const std::filesystem::path& folder);

}  // namespace mien::pipeline
