#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/clip.h"
#include "pipeline/production/synthesis/synthesis.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

/// The stored record of a motion: its warnings and a digest of all its numbers and sentences, so
/// that dependent artifacts are remade if the motion has changed, and only then.
struct MotionRecord {
  std::string digest;
  int shown_frames = 0;  ///< number of frames of the film before durations are equalized
  std::vector<std::string> warnings;  ///< plain sentences
};

/// Returns a digest of every number in a clip.
Hash digest_of(const motion::Clip& clip);

/// Returns the record as text. `shown` is the clip that the video shows, before durations are
/// equalized (playback_clip).
std::string motion_record(const Synthesis& synthesis, const motion::Clip& shown);

/// Reads such a record. Throws std::runtime_error if the text is malformed.
MotionRecord parse_motion_record(const std::string& json);

}  // namespace mien::pipeline
