#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/commands/line/console.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/archive/zip_archive.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// An archive for a preregistration, in memory.
struct FrozenArchive {
  std::filesystem::path file;
  std::string bytes;
  std::size_t files = 0;
};

/// Builds the preregistration archive of a study in the folder `made`, with the files on `power`,
/// simulated answers and the report on them. Throws Error if its media are missing, or if `file`
/// exists with other bytes, so that a registered archive is not overwritten. Writes nothing to
/// disk.
FrozenArchive frozen_archive(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                             const ZipFiles& power, const std::filesystem::path& made,
                             const std::filesystem::path& file);

/// Prints what is missing from an archive, or should not be published with it.
void remark_on_archive(const Manifest& manifest, bool has_power, const Console& console);

/// Writes the archive atomically.
void write_archive(const FrozenArchive& archive);

}  // namespace mien::pipeline
