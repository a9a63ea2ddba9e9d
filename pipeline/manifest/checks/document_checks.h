#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {

/// What a YAML file can be.
enum class DocumentKind { manifest, scales, set, recipes };

/// By its keys: the kind whose schema knows most of them. Where no schema knows any, `name` says
/// it (my.scales.yaml, my.set.yaml, my.recipes.yaml); others are manifests.
DocumentKind kind_of_document(std::string_view yaml, const std::filesystem::path& name);

/// The fault of a file of another kind in the place of a manifest.
Fault told_as_no_manifest(DocumentKind kind, const std::filesystem::path& file);

/// Faults of a file that is no manifest. Never throws for what its text says.
std::vector<Fault> check_other_document(DocumentKind kind, const std::filesystem::path& file);

}  // namespace mien::pipeline
