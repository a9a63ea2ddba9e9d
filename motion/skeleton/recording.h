#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/skeleton/markers.h"
#include "motion/skeleton/pose.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// A motion as read from a file: any rig, in the file's own unit and axes (an Acclaim file that
/// states its unit of length is in metres, acclaim.h).
///
/// `to_body` (body_mapping.h) turns it into a Clip of the canonical body.
struct Recording {
  std::string name;  ///< file name without folder and extension
  /// "bvh", "amc", "gltf", "smpl", "mvnx", "c3d", "fbx"; "bind pose" of a character.
  std::string format;
  Skeleton skeleton;
  double frames_per_second = 30.0;
  std::vector<Pose> poses;
  std::vector<std::string> takes;     ///< names of the file's animations; empty unless glTF
  std::string take;                   ///< the name of this motion
  std::vector<std::string> notes;     ///< choices and omissions of the reader, as sentences
  std::vector<std::string> subjects;  ///< people that the file holds; empty if it does not tell
  std::string subject;                ///< the one who moves here; empty if the file does not tell
  /// Of a recording of points. The figure is then in metres with +Y up and the floor at y = 0: the
  /// canonical body fitted to them or, if that was not possible, a single joint in their centre.
  std::optional<Markers> markers;

  int frame_count() const { return static_cast<int>(poses.size()); }
};

}  // namespace mien::motion
