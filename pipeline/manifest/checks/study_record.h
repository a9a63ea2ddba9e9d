#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace mien::pipeline {

/// What a provenance.json says of the manifest behind a study.
struct StudyRecord {
  std::filesystem::path as_run;    ///< a manifest that makes the study again
  std::filesystem::path manifest;  ///< a copy of what its author wrote
  std::string command;             ///< that made the study
};

/// The record, if the file is one: JSON whose `manifest` tells what was run.
std::optional<StudyRecord> study_record_in(const std::filesystem::path& file);

}  // namespace mien::pipeline
