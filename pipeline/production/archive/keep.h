#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "pipeline/tasks/receipt.h"

namespace mien::pipeline {

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

/// Artifacts in `folder` of other kinds than those, as their receipts tell them. provenance.json,
/// inputs/, the report with methods.md and references.bib, and what the store keeps for itself are
/// of no kind and stay. All of it is hashed. Throws Error when the folder has no receipts.
Cleaning all_but(const std::filesystem::path& folder, const std::vector<ArtifactKind>& kept);

/// Removes them, and notes in the folder that this was on purpose (not_kept.h). What has been
/// changed since `all_but` looked is left, and told as changed.
Cleaning remove_all_but(const std::filesystem::path& folder, const std::vector<ArtifactKind>& kept);

}  // namespace mien::pipeline
