#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

/// A file of a study, or a sequence of frames, as recorded in the study's provenance.
struct ArtifactRecord {
  std::string path;  ///< in the study's folder, with '/'
  Hash hash;
  std::uint64_t size = 0;  ///< bytes; 0 for a copied input, whose size is not recorded
  int frames = 0;          ///< of a sequence; 0: a file

  friend bool operator==(const ArtifactRecord&, const ArtifactRecord&) = default;
};

/// What a finished study should hold.
struct StudyContents {
  std::filesystem::path folder;
  std::string study;    ///< its name
  std::string program;  ///< version of mien that made it
  std::string command;  ///< that made it
  std::uint64_t seed = 0;
  std::vector<ArtifactRecord> artifacts;  ///< by path
  std::vector<ArtifactRecord> inputs;     ///< copies of the files that describe it, by path
  std::string as_run;                     ///< the manifest that makes it again
  int inputs_elsewhere = 0;               ///< recordings and characters, of which it has no copy

  std::filesystem::path provenance() const { return folder / "provenance.json"; }
  const ArtifactRecord* find(const std::string& path) const;
};

/// The contents of a study, given its folder, its provenance.json, or a bag (BagIt) that holds it.
/// Throws Error when there is no provenance, or one that describes no study or names files outside
/// its folder.
StudyContents contents_of(const std::filesystem::path& study);

/// The study's folder: that of a given provenance.json, or of the study in a given bag.
std::filesystem::path study_folder_of(const std::filesystem::path& study);

/// What belongs to the work on a study and not to the study: what the store and the farm keep for
/// themselves.
bool is_bookkeeping(const std::string& path);

}  // namespace mien::pipeline
