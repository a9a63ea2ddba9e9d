#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {

/// What a YAML file can be.
enum class DocumentKind { manifest, scales, set, recipes };

/// By its keys: the kind whose schema knows most of them. Where no schema knows any, `name` says
/// it (my.scales.yaml, my.set.yaml, my.recipes.yaml); others are manifests.
DocumentKind kind_of_document(std::string_view yaml, const std::filesystem::path& name);

/// The fault of a file of another kind that was given as a manifest, with how to refer to it.
Fault not_a_manifest_fault(DocumentKind kind, const std::filesystem::path& file);

/// Faults of a file that is no manifest. Never throws for what its text says.
std::vector<Fault> check_other_document(DocumentKind kind, const std::filesystem::path& file);

/// What a provenance.json says of the manifest behind a study.
struct StudyRecord {
  std::filesystem::path as_run;    ///< a manifest that makes the study again
  std::filesystem::path manifest;  ///< a copy of what its author wrote
  std::string command;             ///< that made the study
};

/// The record, if the file is one: JSON whose `manifest` names the manifest that was run.
std::optional<StudyRecord> study_record_in(const std::filesystem::path& file);

}  // namespace mien::pipeline
