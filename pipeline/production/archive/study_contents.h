#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

/// A file of a study, or a sequence of frames, as the study's provenance tells it.
struct ArtifactRecord {
  std::string path;  ///< in the study's folder, with '/'
  Hash hash;
  std::uint64_t size = 0;  ///< bytes; of a copied input 0, which is not told
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

/// Of a study's folder, its provenance.json, or a bag (BagIt) that holds it. Throws Error when
/// there is no provenance, or one that tells no study or names files outside its folder.
StudyContents contents_of(const std::filesystem::path& study);

/// The folder that is meant: of a provenance.json its own, of a bag that of the study in it.
std::filesystem::path study_folder_meant(const std::filesystem::path& study);

/// What belongs to the work on a study and not to the study: what the store and the farm keep for
/// themselves.
bool is_bookkeeping(const std::string& path);

}  // namespace mien::pipeline
