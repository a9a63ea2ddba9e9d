#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/production/archive/study_contents.h"

namespace mien::pipeline {

/// Tells what was removed from a study on purpose. It lies beside provenance.json and not among the
/// store's own files, so that it goes where the study goes.
inline constexpr char not_kept_path[] = "not-kept.json";

/// What the study's folder says was removed, by path; nothing where it says nothing. Throws Error
/// when the note is damaged.
std::vector<ArtifactRecord> not_kept_in(const std::filesystem::path& folder);

/// Adds to the note; an entry of the same path is replaced.
void note_not_kept(const std::filesystem::path& folder, const std::vector<ArtifactRecord>& removed);

}  // namespace mien::pipeline
