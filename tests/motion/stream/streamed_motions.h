#pragma once

#include <string>
#include <vector>

#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/clip.h"

namespace mien::test {

/// The motions of a built-in set as a camera would see them: loops walked so many times.
inline std::vector<motion::Clip> performed(const std::string& set, double frames_per_second = 30.0,
                                           int cycles = 3) {
  std::vector<motion::Clip> clips;
  for (const motion::Example& example : motion::builtin_examples(set, frames_per_second).examples) {
    clips.push_back(example.clip.loops ? motion::repeated(example.clip, cycles) : example.clip);
    clips.back().name = example.name;
  }
  return clips;
}

/// The clip with different frames from `first` on, in an implausible pose.
inline motion::Clip changed_from(motion::Clip clip, std::size_t first) {
  for (std::size_t f = first; f < clip.poses.size(); ++f) {
    for (motion::Quat& rotation : clip.poses[f].rotations) {
      rotation = rotation * motion::Quat(0.8, 0.0, 0.6, 0.0);
    }
    clip.poses[f].root_position *= 1.5;
  }
  return clip;
}

}  // namespace mien::test
