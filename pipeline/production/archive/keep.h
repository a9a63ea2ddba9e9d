#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "pipeline/production/archive/study_contents.h"
#include "pipeline/tasks/receipt.h"

namespace mien::pipeline {

/// Path of the list of artifacts that were removed from a study on purpose. It lies next to
/// provenance.json and not among the store's own files, so that it is copied with the study.
inline constexpr char not_kept_path[] = "not-kept.json";

/// Returns the removed artifacts that the list in the study's folder contains, sorted by path;
/// empty if there is no list. Throws Error if the list is damaged.
std::vector<ArtifactRecord> not_kept_in(const std::filesystem::path& folder);

/// Adds entries to the list, replacing those with the same path. Throws Error if the list is
/// damaged.
void note_not_kept(const std::filesystem::path& folder, const std::vector<ArtifactRecord>& removed);

/// The kinds of artifacts of a study that can be kept or removed, by their folder.
enum class ArtifactKind { videos, frames, clips, sheets, metrics };

struct ArtifactKindName {
  ArtifactKind kind;
  std::string_view name;  ///< name, also that of its folder
};
inline constexpr ArtifactKindName artifact_kinds[] = {{ArtifactKind::videos, "videos"},
                                                      {ArtifactKind::frames, "frames"},
                                                      {ArtifactKind::clips, "clips"},
                                                      {ArtifactKind::sheets, "sheets"},
                                                      {ArtifactKind::metrics, "metrics"}};

/// The result of removing all artifacts except those of the kinds to be kept.
struct Cleaning {
  std::vector<Receipt> removed;  ///< removed or to be removed, by path
  std::vector<Receipt> changed;  ///< not removed, because they have changed since they were made
  std::uint64_t bytes = 0;       ///< total size of the removed artifacts
};

/// Returns the number of links in report.html that lead to removed artifacts.
int dead_links(const std::filesystem::path& folder, const Cleaning& cleaning);

/// Returns the artifacts in `folder` that are not of the given kinds, as listed by their receipts.
/// Files of no kind are kept: provenance.json, inputs/, the report with methods.md and
/// references.bib, and the store's own files. Hashes the artifacts that it returns. Throws Error if
/// the folder does not exist or has no receipts.
Cleaning all_but(const std::filesystem::path& folder, const std::vector<ArtifactKind>& kept);

/// Removes the artifacts that `all_but` returns as `removed`, after listing them in the folder as
/// removed on purpose. Artifacts that have changed since they were made are kept and returned as
/// `changed`. Throws the errors of `all_but`, Error if that list is damaged, and StoreBusy if
/// another process works in the folder.
Cleaning remove_all_but(const std::filesystem::path& folder, const std::vector<ArtifactKind>& kept);

}  // namespace mien::pipeline
