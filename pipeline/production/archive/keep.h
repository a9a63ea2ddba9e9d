#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "pipeline/production/archive/study_contents.h"
#include "pipeline/tasks/receipt.h"

namespace mien::pipeline {

/// The list of what was removed from a study on purpose. It is beside provenance.json and not among
/// the store's own files, so that it goes where the study goes.
inline constexpr char not_kept_path[] = "not-kept.json";

/// What the study's folder says was removed, by path; nothing where it says nothing. Throws Error
/// when the note is damaged.
std::vector<ArtifactRecord> not_kept_in(const std::filesystem::path& folder);

/// Adds to the note; an entry of the same path is replaced.
void note_not_kept(const std::filesystem::path& folder, const std::vector<ArtifactRecord>& removed);

/// What can be kept or removed of a study, by the folder that it lies in.
enum class ArtifactKind { videos, frames, clips, sheets, metrics };

struct ArtifactKindName {
  ArtifactKind kind;
  std::string_view name;  ///< also of its folder
};
inline constexpr ArtifactKindName artifact_kinds[] = {{ArtifactKind::videos, "videos"},
                                                      {ArtifactKind::frames, "frames"},
                                                      {ArtifactKind::clips, "clips"},
                                                      {ArtifactKind::sheets, "sheets"},
                                                      {ArtifactKind::metrics, "metrics"}};

/// What removing all other kinds removes, and what it leaves.
struct Cleaning {
  std::vector<Receipt> removed;  ///< or to be removed, by path
  std::vector<Receipt> changed;  ///< since they were made, and so left
  std::uint64_t bytes = 0;       ///< of those removed
};

/// How many links of the study's report lead to artifacts that are removed, and so nowhere.
int dead_links(const std::filesystem::path& folder, const Cleaning& cleaning);

/// Artifacts in `folder` of other kinds than those, as listed by their receipts. provenance.json,
/// inputs/, the report with methods.md and references.bib, and what the store keeps for itself are
/// of no kind and stay. All of it is hashed. Throws Error when the folder has no receipts.
Cleaning all_but(const std::filesystem::path& folder, const std::vector<ArtifactKind>& kept);

/// Removes them, and notes in the folder that this was on purpose. What has been
/// changed since `all_but` looked is left, and reported as changed.
Cleaning remove_all_but(const std::filesystem::path& folder, const std::vector<ArtifactKind>& kept);

}  // namespace mien::pipeline
