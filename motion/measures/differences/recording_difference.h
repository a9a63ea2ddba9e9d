#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "motion/measures/differences/motion_difference.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// Two recordings prepared for comparison: metres, +Y up, otherwise unchanged.
struct ComparedRecordings {
  /// Clips on the recordings' own joints and floor, or on the canonical body if `on_body`.
  Clip before, now;
  /// Clips on the canonical body, if both were recognised as human.
  std::optional<Clip> body_before, body_now;
  /// Body part of each joint of `before`: "left forearm"; the joint's name if unknown.
  std::vector<std::string> parts;
  bool on_body = false;
  std::vector<std::string> remarks;
  /// Renamed joints of skeletons that are otherwise equal: old name, new name. `now` has the names
  /// of `before`.
  std::vector<std::pair<std::string, std::string>> renamed;
};

/// Prepares two recordings for comparison. If at least three quarters of the joint names of each
/// occur in the other, or if skeletons of the same file format differ only in names (`renamed`),
/// the recordings are compared on their own joints, otherwise on the canonical body. Recordings of
/// the same file format are assumed to have the same unit and up axis, as determined for the first;
/// for different formats they are determined separately. Recordings of the same format whose joints
/// have the same names and parents are mapped to the body by the same calibration, that of the
/// first.
///
/// Throws Error if a recording has no frames, or if the rigs differ and are not both human.
ComparedRecordings compared_recordings(const Recording& before, const Recording& now);

/// Like the comparison of clips, but contacts and D are measured on the canonical body, each motion
/// on its own floor, and lint findings are those of the recordings and of the canonical body.
MotionDifference motion_difference(const ComparedRecordings& recordings,
                                   const MotionDifferenceOptions& options = {});

}  // namespace mien::motion
