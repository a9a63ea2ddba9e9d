#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/manifest/regression_limits.h"
#include "pipeline/manifest/stimulus.h"
#include "pipeline/production/film/film_record.h"
#include "pipeline/regression/settings.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

/// The program, its libraries and the machine that something was made with.
struct Origin {
  std::string program;      ///< "0.2.0"
  std::string motion_code;  ///< code_identity.h
  std::string film_code;
  std::map<std::string, std::string> libraries;  ///< Embree's with its instruction set
  std::string processor;                         ///< vendor: "AuthenticAMD"

  friend bool operator==(const Origin&, const Origin&) = default;
};

/// This program on this machine.
Origin this_origin();

/// What is kept of one frame.
struct KeyFrame {
  int frame = 0;
  Hash pixels;

  friend bool operator==(const KeyFrame&, const KeyFrame&) = default;
};

/// What is kept of a video. What it showed was checked when it was made, against its frames.
struct VideoFacts {
  VideoRecord record;
  Hash hash;
  int first_film_frame = 0;  ///< what comes before it is its presentation
};

/// What is known of a stimulus beside the clip and the pictures themselves.
struct StimulusFacts {
  std::string id;
  std::string edition;  ///< of the manifest that it was approved with (Baseline)
  Origin origin;
  std::vector<Setting> settings;
  NamedValues weights;
  NamedValues requested;
  NamedValues reached;
  std::vector<std::string> findings;  ///< of the lint, a sentence each
  Hash motion;                        ///< of every number of the clip shown
  Hash scene;                         ///< Rendition::scene_key
  Hash drawing;
  int frames = 0;
  double fps = 0.0;
  RegressionLimits limits;           ///< that it was approved with
  std::vector<KeyFrame> key_frames;  ///< ascending
  std::vector<VideoFacts> videos;    ///< none where none were made
  /// Hashes of all other files of the stimulus in the baseline: "frames/00012.png".
  std::map<std::string, Hash> files = {};
};

/// A decision to let a study look as it does now.
struct Approval {
  std::string who;
  std::string when;  ///< "2026-11-23T09:30:00Z"
  std::string why;
  std::vector<std::string> only;  ///< ids of stimuli; empty: all

  friend bool operator==(const Approval&, const Approval&) = default;
};

/// What people approved: a folder that is made to lie in git, or on a shared disk.
///
///     baseline.json                  the study, all approvals, hashes of the files below that no
///                                    stimulus.json has, and last a hash of this file before it
///     editions/<hash>/inputs/        manifests and what they name, as a study keeps its inputs
///     stimuli/<id>/stimulus.json     StimulusFacts
///     stimuli/<id>/motion.bvh        the clip shown
///     stimuli/<id>/frames/00012.png  key frames as a display shows them
///     stimuli/<id>/frames/00012.exr  their block statistics
///     stimuli/<id>/videos/<id>.mp4   videos, if they were kept
struct Baseline {
  std::filesystem::path folder;
  std::string study;
  std::vector<Approval> approvals;  ///< the oldest first
  std::vector<StimulusFacts> stimuli;
  /// Hashes of every stimulus.json and of all files of the editions, by their paths in the folder.
  /// Empty in a baseline that mien 0.2 wrote.
  std::map<std::string, Hash> sums = {};

  const StimulusFacts* find(const std::string& id) const;
  std::filesystem::path edition_manifest(const std::string& edition) const;
  std::filesystem::path motion_file(const std::string& id) const;
  std::filesystem::path picture_file(const std::string& id, int frame) const;
  std::filesystem::path blocks_file(const std::string& id, int frame) const;
  std::filesystem::path video_file(const std::string& id, const VideoFacts& video) const;
};

/// Whether a folder holds one.
bool is_baseline(const std::filesystem::path& folder);

/// Throws Error, with the file that is missing or damaged, and how to mend it.
Baseline read_baseline(const std::filesystem::path& folder);

/// Whether all that is kept is there as it was approved, to the byte, and nothing was added to an
/// edition. Throws Faults: what is missing, damaged or too much, and how to mend it. Of a baseline
/// without `sums` only motions, pictures and videos can be checked.
void check_files(const Baseline& baseline);

/// stimulus.json, in the folder of the stimulus.
void write_facts(const StimulusFacts& facts, const std::filesystem::path& folder);

/// Hashes of the files of an edition, by their paths in the baseline's folder.
std::map<std::string, Hash> sums_of_edition(const std::filesystem::path& folder,
                                            const std::string& edition);

/// "stimuli/sad-walk/stimulus.json"
std::string facts_path(const std::string& id);

/// baseline.json alone, with `sums`. It is replaced as a whole or not at all.
void write_baseline(const Baseline& baseline);

/// The key frames among `frame_count` frames: at most `most`, evenly spread, the first and the last
/// among them.
std::vector<int> key_frames_of(int frame_count, int most);

}  // namespace mien::pipeline
