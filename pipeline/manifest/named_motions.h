#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "motion/formats/motion_file.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A motion file that a stimulus takes something from.
struct NamedMotion {
  std::string path;  ///< in the manifest, of the map or the name alone: "stimuli[2].clip"
  std::string key;   ///< of its file in that map: "file", "motion"
  std::filesystem::path file;
  std::string take;      ///< empty: none is chosen
  int last_frame = 0;    ///< that is asked for; 0 where all are
  std::string frame_at;  ///< path of what asks for it
};

/// The motion files of the stimulus's clip, its path's graph and its modifications' poses, in this
/// order.
std::vector<NamedMotion> named_motions(const Stimulus& stimulus);

/// A sentence that the file has several motions, and which is the default; empty where one was
/// chosen or there is only one. Throws Error where the file cannot be read.
std::string default_take_note(const NamedMotion& motion);

/// What is wrong with a frame that is asked for: `it has 173 frames, so frame 400 does not exist`,
/// of a file with several takes with the take's name. Empty when there is such a frame.
std::string frame_fault(const motion::Recording& recording, int frame);

/// Throws Error with that where there is no such frame.
void require_frame(const motion::Recording& recording, int frame,
                   const std::filesystem::path& file);

}  // namespace mien::pipeline
