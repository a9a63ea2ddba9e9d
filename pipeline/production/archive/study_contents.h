#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/manifest/packed_recordings.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

/// Name of the file that describes a packed study as a research object (research_crate.h), and of
/// the folder of a packed study that can be copied into a BIDS dataset (bids_stimuli.h).
inline constexpr char crate_path[] = "ro-crate-metadata.json";
inline constexpr char bids_folder[] = "stimuli";

/// A file or frame sequence of a study, as recorded in the study's provenance.
struct ArtifactRecord {
  std::string path;  ///< relative to the study's folder, with '/'
  Hash hash;
  std::uint64_t size = 0;  ///< bytes; 0 for a copied input, whose size is not recorded
  int frames = 0;          ///< number of frames of a sequence; 0 for a file
  /// Licences that do not permit sharing the recordings from which a motion file was made.
  std::vector<std::string> restricting = {};

  friend bool operator==(const ArtifactRecord&, const ArtifactRecord&) = default;
};

/// A recording of a study, as its provenance records it. It is not in the study's folder.
struct RecordingRecord {
  std::string path;  ///< its name: "captures/walk.bvh"
  Hash hash;
  std::string licence;  ///< empty: not stated
  bool share = true;    ///< false: its licence does not permit sharing
};

/// The expected contents of a finished study.
struct StudyContents {
  std::filesystem::path folder;
  std::string study;    ///< name of the study
  std::string program;  ///< version of mien that made it
  std::string command;  ///< command line that made it
  std::uint64_t seed = 0;
  std::vector<ArtifactRecord> artifacts;  ///< by path
  std::vector<ArtifactRecord> inputs;     ///< copies of the files that describe the study, by path
  std::string as_run;                     ///< path of the manifest that reproduces the study
  std::vector<RecordingRecord> recordings;  ///< by path
  PackedRecordings packed;                  ///< of an unpacked archive: the recordings in it
  /// Number of recordings and characters that are neither copied into the study nor packed with it
  /// nor left out of the archive because of their licence.
  int inputs_elsewhere = 0;

  std::filesystem::path provenance() const { return folder / "provenance.json"; }
  const ArtifactRecord* find(const std::string& path) const;
  const RecordingRecord* find_recording(const std::string& path) const;
};

/// Returns the contents of a study, given its folder, its provenance.json, or a bag (BagIt) that
/// contains it. Throws Error if there is no provenance, or if the provenance or the list of packed
/// recordings is damaged or names files outside the study's folder.
StudyContents contents_of(const std::filesystem::path& study);

/// Returns the study's folder, given the folder itself, its provenance.json, or a bag that contains
/// it.
std::filesystem::path study_folder_of(const std::filesystem::path& study);

/// Whether a path of an unpacked study was written by mien pack, not by mien run: a packed
/// recording or the list of them, the description of the archive or a stimulus for BIDS.
bool is_only_in_archive(const StudyContents& contents, const std::string& path);

/// Whether a path belongs to bookkeeping and not to the study: the files of the store and the farm.
bool is_bookkeeping(const std::string& path);

}  // namespace mien::pipeline
