#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "motion/lint/finding.h"
#include "motion/lint/lint_options.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// One check of the lint.
struct LintCheck {
  std::string_view id;          ///< "foot-skate"
  std::string_view what;        ///< short description of what it checks
  bool needs_original = false;  ///< requires an original; without one it reports nothing
};

/// All checks, in the order of their findings.
const std::vector<LintCheck>& lint_checks();

/// Checks a motion for physical impossibilities: invalid data, joints beyond their range,
/// intersecting body parts, feet that slide, sink or float, loss of balance, impossible forces and
/// torques.
///
/// The clip is in metres, +Y up, with the floor at y = 0. A loop is treated as repeating
/// indefinitely, and a loop that walks in place as a walk on a treadmill. If the skeleton is not
/// the canonical body, only invalid data, a calibration pose, frozen intervals, jumps and seams are
/// checked.
///
/// With an `original` (the motion before modification, on any canonical body), faults of the
/// original count less, and contact timing, limb phases and jerk are compared with it. The
/// durations may differ: moments at the same fraction of the duration correspond.
///
/// Findings are ordered by check, frame and joint. A clip without frames has none. If a clip has
/// non-finite numbers or rotations of length zero, only invalid data are found.
std::vector<Finding> lint(const Clip& clip, const LintOptions& options = {},
                          const Clip* original = nullptr);

/// The finding of the check `calibration-pose`: a different pose before the motion of a canonical
/// body, such as a T-pose in frame 0. Empty if there is none, or if the clip has no frames, invalid
/// numbers or another skeleton.
std::optional<Finding> calibration_pose(const Clip& clip);

/// Checks the data of a recording as read from a file for non-finite numbers, invalid rotations and
/// changing bone lengths. After conversion to the canonical body, changes of length can no longer
/// be detected, because the body's bone lengths are constant.
std::vector<Finding> lint(const Recording& recording, const LintOptions& options = {});

}  // namespace mien::motion
