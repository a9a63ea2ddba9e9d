#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// An archive for a preregistration, in memory.
struct FrozenArchive {
  std::filesystem::path file;
  std::string bytes;
  std::size_t files = 0;
};

/// Freezes a study that was made in the folder `made`, with answers that nobody gave and the report
/// on them. Throws Error where its media are missing, and where something else than these bytes is
/// in `file`: what was registered is not lost by a slip. Nothing is left on the disk.
FrozenArchive frozen_archive(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                             const std::filesystem::path& made, const std::filesystem::path& file);

/// Writes it, whole or not at all.
void write_archive(const FrozenArchive& archive);

}  // namespace mien::pipeline
