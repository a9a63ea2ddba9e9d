#pragma once

#include <string>
#include <utility>
#include <vector>

#include "motion/skeleton/clip_markers.h"
#include "scenes/walking_clip.h"

namespace mien::scenes::test {

/// Joints that carry a marker each, with the names of the markers.
inline const std::vector<std::pair<std::string, motion::BodyJoint>>& carriers() {
  static const std::vector<std::pair<std::string, motion::BodyJoint>> all = {
      {"LANK", motion::LeftAnkle}, {"RANK", motion::RightAnkle}, {"LKNE", motion::LeftKnee},
      {"RKNE", motion::RightKnee}, {"LWRA", motion::LeftWrist},  {"HEAD", motion::Head}};
  return all;
}

/// The clip with a marker on some joints, seen in all frames.
inline motion::Clip with_markers(motion::Clip clip) {
  motion::Markers markers;
  for (const auto& [name, joint] : carriers()) markers.points.push_back(name);
  for (const std::vector<motion::Vec3>& joints : motion::joint_paths(clip)) {
    for (const auto& [name, joint] : carriers()) markers.positions.push_back(joints[joint]);
  }
  markers.seen.assign(markers.positions.size(), true);
  markers.filled.assign(markers.positions.size(), false);
  motion::attach(clip, std::move(markers));
  return clip;
}

/// The clip with a marker missing, or filled in, from frame `first` to `last`.
inline motion::Clip with_gap(motion::Clip clip, int point, int first, int last, bool filled) {
  motion::Markers markers = *motion::markers_of(clip);
  for (int frame = first; frame <= last; ++frame) {
    const std::size_t at = markers.at(frame, point);
    markers.seen[at] = false;
    markers.filled[at] = filled;
    if (!filled) markers.positions[at] = motion::Vec3::Zero();
  }
  motion::attach(clip, std::move(markers));
  return clip;
}

}  // namespace mien::scenes::test
