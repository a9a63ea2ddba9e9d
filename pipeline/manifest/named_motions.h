#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "motion/formats/motion_file.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A motion file that a stimulus uses.
struct NamedMotion {
  std::string path;  ///< path in the manifest of the file name or of its map: "stimuli[2].clip"
  std::string key;   ///< key of the file in that map: "file", "motion"
  std::filesystem::path file;
  motion::ReadOptions how;  ///< which motion of the file
  int last_frame = 0;       ///< last requested frame, counted from 0; 0 if all frames are used
  std::string frame_at;     ///< path in the manifest of the requested frame
  Licence licence = {};
  std::string source = {};  ///< where the recording can be obtained; empty: not stated
};

/// Returns the motion files of the stimulus's clip, of its path's graph, of its modifications'
/// poses and of its people, in this order.
std::vector<NamedMotion> named_motions(const Stimulus& stimulus);

/// Returns a sentence that names the default take of a file with several motions; empty if a take
/// is selected or there is only one. Throws Error if the file cannot be read.
std::string default_take_note(const NamedMotion& motion);

/// Returns a fault if the recording has no such frame, with the take's name if the file has several
/// takes: `it has 173 frames, so frame 400 does not exist`. Otherwise empty.
std::string frame_fault(const motion::Recording& recording, int frame);

/// Throws Error with that fault if there is no such frame.
void require_frame(const motion::Recording& recording, int frame,
                   const std::filesystem::path& file);

}  // namespace mien::pipeline
