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
  /// On the recording's own joints, where they are; on the canonical body when `on_body`.
  Clip before, now;
  /// On the canonical body, when a human was recognised in both.
  std::optional<Clip> body_before, body_now;
  /// Body part of each joint of `before`: "left forearm"; the joint's name if unknown.
  std::vector<std::string> parts;
  bool on_body = false;
  std::vector<std::string> remarks;
  /// Renamed joints of skeletons that are otherwise equal: old name, new name. `now` has the names
  /// of `before`.
  std::vector<std::pair<std::string, std::string>> renamed;
};

/// Recordings whose joints have the same names for the most part (three of four of each) are
/// compared on their own joints, others as humans. In two of one file format a unit of the file
/// means the same length and its up axis is the same, as found for the first; a file of another
/// format has its own. Rigs that agree joint by joint are put on the body by one calibration, that
/// of the first.
///
/// Throws Error when a recording has no frames, or when rigs differ and are not both human.
ComparedRecordings compared_recordings(const Recording& before, const Recording& now);

/// As for clips; contacts, lint and D are those of the body on its own floor.
MotionDifference motion_difference(const ComparedRecordings& recordings,
                                   const MotionDifferenceOptions& options = {});

}  // namespace mien::motion
