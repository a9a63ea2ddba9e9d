#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/clip.h"
#include "pipeline/production/synthesis/synthesis.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

/// What the store keeps of a motion: a digest of every number in it, so that whatever is made from
/// the motion is made again exactly when the motion has changed, and what a run has to say about
/// it.
struct MotionRecord {
  std::string digest;
  int shown_frames = 0;
  std::vector<std::string> warnings;  ///< plain sentences
};

/// A digest of every number in a clip.
Hash digest_of(const motion::Clip& clip);

/// `shown` is the clip that the video shows.
std::string motion_record(const Synthesis& synthesis, const motion::Clip& shown);

/// Throws std::runtime_error when the text is no such record.
MotionRecord parse_motion_record(const std::string& json);

}  // namespace mien::pipeline
