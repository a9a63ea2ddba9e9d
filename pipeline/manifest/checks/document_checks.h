#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {

/// The kind of document that a YAML file contains.
enum class DocumentKind { manifest, scales, set, recipes, texts };

/// Returns the kind whose schema knows the largest number of the document's top-level keys, where
/// keys that the schema requires count twice; in a tie, the first in the order of DocumentKind. If
/// no schema knows any of them, the kind follows from the file name (my.scales.yaml, my.set.yaml,
/// my.recipes.yaml, my.texts.yaml), with manifest as the default.
DocumentKind kind_of_document(std::string_view yaml, const std::filesystem::path& name);

/// Returns the fault for a file of a kind other than manifest that was given as a manifest, with
/// advice on how to refer to it.
Fault not_a_manifest_fault(DocumentKind kind, const std::filesystem::path& file);

/// Returns the faults of a scales, set, recipes or texts file. Never throws because of the file's
/// content.
std::vector<Fault> check_other_document(DocumentKind kind, const std::filesystem::path& file);

/// A recording of a study, as its provenance.json records it.
struct RecordedInput {
  std::string name;  ///< name of its folder and of the file: "captures/walk.bvh"
  std::string hash;
  std::string licence;  ///< empty: not stated
  std::string source;   ///< empty: not stated
  bool share = true;
};

/// The part of a provenance.json that identifies the manifest behind a study.
struct StudyRecord {
  std::filesystem::path as_run;    ///< manifest that reproduces the study
  std::filesystem::path manifest;  ///< copy of the author's manifest
  std::string command;             ///< command line that made the study
  std::vector<RecordedInput> recordings;
};

/// Returns the record if the file is a provenance file: a .json file in which `manifest.as_run` is
/// not empty. Throws Error if it names a manifest outside its own folder.
std::optional<StudyRecord> study_record_in(const std::filesystem::path& file);

}  // namespace mien::pipeline
