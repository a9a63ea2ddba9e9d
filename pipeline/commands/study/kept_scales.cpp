#include "pipeline/commands/study/kept_scales.h"

#include "pipeline/base/documents/environment.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/checks/study_record.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

fs::path folder_of_study(const fs::path& study) {
  return fs::is_directory(study) ? study : fs::absolute(study).parent_path().parent_path();
}

}  // namespace

std::optional<fs::path> kept_scales(const fs::path& study) {
  const auto record = study_record_in(folder_of_study(study) / "provenance.json");
  if (!record || !fs::is_regular_file(record->as_run)) return std::nullopt;
  // Motions that the study was made of may be gone: of faults, only those of the scales matter, and
  // who reads these is told them.
  const fs::path scales = read_manifest(record->as_run, process_environment()).manifest.scales.file;
  if (scales.empty()) return std::nullopt;
  return scales;
}

}  // namespace mien::pipeline
