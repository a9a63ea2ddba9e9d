#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/manifest/regression_limits.h"
#include "pipeline/manifest/stimulus.h"
#include "pipeline/production/film/film_record.h"
#include "pipeline/regression/settings.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

/// The program, libraries and machine with which something was made.
struct Origin {
  std::string program;      ///< "0.2.0"
  std::string motion_code;  ///< code_identity.h
  std::string film_code;
  /// Versions by library; Embree's includes its instruction set.
  std::map<std::string, std::string> libraries;
  std::string processor;  ///< vendor of the processor: "AuthenticAMD"

  friend bool operator==(const Origin&, const Origin&) = default;
};

/// Returns the origin of this program on this machine.
Origin this_origin();

/// The stored facts about a key frame, one of the evenly spaced frames that are kept for
/// comparison.
struct KeyFrame {
  int frame = 0;
  Hash pixels;

  friend bool operator==(const KeyFrame&, const KeyFrame&) = default;
};

/// The stored facts about a video. When it was made, its decoded pictures were compared with the
/// frames that were encoded.
struct VideoFacts {
  VideoRecord record;
  Hash hash;
  /// Index of the film's first frame in the video; earlier frames show the title card, the fixation
  /// cross or a blank.
  int first_film_frame = 0;
};

/// The stored facts about a stimulus, in addition to the clip and the pictures.
struct StimulusFacts {
  std::string id;
  std::string edition;  ///< edition of the manifest with which it was approved (Baseline)
  Origin origin;
  std::vector<Setting> settings;
  NamedValues weights;
  NamedValues requested;
  NamedValues reached;
  std::vector<std::string> findings;  ///< lint findings, one sentence each
  Hash motion;                        ///< digest of every number of the clip shown
  Hash scene;                         ///< Rendition::scene_key
  Hash drawing;
  int frames = 0;
  double fps = 0.0;
  RegressionLimits limits;           ///< limits at the time of approval
  std::vector<KeyFrame> key_frames;  ///< ascending
  std::vector<VideoFacts> videos;    ///< empty if none were made
  /// Hashes of all other files of the stimulus, by path in its folder: "frames/00012.png".
  std::map<std::string, Hash> files = {};
};

/// A decision to accept the current state of a study.
struct Approval {
  std::string who;
  std::string when;  ///< "2026-11-23T09:30:00Z"
  std::string why;
  std::vector<std::string> only;  ///< ids of the approved stimuli; empty: all

  friend bool operator==(const Approval&, const Approval&) = default;
};

/// The approved state of a study: a folder that can be kept in git or on a shared disk. An edition
/// is the manifest with its files at one approval, named by their hash.
///
///     baseline.json                  the study, all approvals, facts about overlays, hashes of the
///                                    files below (except those that a stimulus.json lists), and a
///                                    checksum of the preceding text
///     editions/<hash>/inputs/        manifests and the files that they name, like a study's inputs
///     stimuli/<id>/stimulus.json     StimulusFacts
///     stimuli/<id>/motion.bvh        the clip shown
///     stimuli/<id>/frames/00012.png  key frames as a display shows them
///     stimuli/<id>/frames/00012.exr  their block statistics
///     stimuli/<id>/videos/<id>.mp4   videos, if they are stored
struct Baseline {
  std::filesystem::path folder;
  std::string study;
  std::vector<Approval> approvals;  ///< oldest first
  std::vector<StimulusFacts> stimuli;
  /// Hashes of every stimulus.json and of all files of the editions, by path relative to the
  /// folder. Empty in baselines written before these hashes existed.
  std::map<std::string, Hash> sums = {};
  /// Facts about the overlays (overlay_facts). Unset in baselines of versions up to 0.3.
  std::optional<std::vector<StimulusFacts>> overlays = {};

  const StimulusFacts* find(const std::string& id) const;
  std::filesystem::path edition_manifest(const std::string& edition) const;
  std::filesystem::path motion_file(const std::string& id) const;
  std::filesystem::path picture_file(const std::string& id, int frame) const;
  std::filesystem::path blocks_file(const std::string& id, int frame) const;
  std::filesystem::path video_file(const std::string& id, const VideoFacts& video) const;
};

/// Whether a folder contains a baseline.
bool is_baseline(const std::filesystem::path& folder);

/// Reads a baseline. Throws an Error that names the missing or damaged file and a remedy.
Baseline read_baseline(const std::filesystem::path& folder);

/// Checks that all stored files are identical to the approved ones and that no file was added to an
/// edition. Throws Faults that list missing, damaged and additional files with a remedy. In a
/// baseline without `sums`, only motions, pictures, block statistics and videos can be checked.
void check_files(const Baseline& baseline);

/// Writes stimulus.json to the folder of the stimulus.
void write_facts(const StimulusFacts& facts, const std::filesystem::path& folder);

/// Returns the hashes of the files of an edition, by path relative to the baseline's folder.
std::map<std::string, Hash> sums_of_edition(const std::filesystem::path& folder,
                                            const std::string& edition);

/// Returns "stimuli/sad-walk/stimulus.json".
std::string facts_path(const std::string& id);

/// Writes only baseline.json, including `sums`. The file is replaced atomically.
void write_baseline(const Baseline& baseline);

/// Returns the key frames among `frame_count` frames: at most `most`, evenly spaced, including the
/// first and the last; the middle frame if `most` is 1.
std::vector<int> key_frames_of(int frame_count, int most);

}  // namespace mien::pipeline
