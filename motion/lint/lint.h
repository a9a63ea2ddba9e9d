#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "motion/lint/finding.h"
#include "motion/lint/lint_options.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// One rule of the lint.
struct LintCheck {
  std::string_view id;          ///< "foot-skate"
  std::string_view what;        ///< what it looks for, a few words
  bool needs_original = false;  ///< finds nothing without one
};

/// All rules, in the order of their findings.
const std::vector<LintCheck>& lint_checks();

/// Checks a motion for physical impossibilities: invalid data, joints beyond their range, parts of
/// the body in each other, feet that slide, sink or float, lost balance, impossible forces and
/// torques.
///
/// The clip is in metres, +Y up, its floor at y = 0; a loop is judged as going on for ever, and one
/// that walks in place as on a treadmill. Of a skeleton that is not the canonical body only the
/// data is checked. With an `original` (the motion before it was modified, on any canonical body)
/// what that did already counts less, and timing, phases and jerk are compared; it need not last
/// as long, since moments are compared by their share of the duration. Findings are ordered by
/// check, frame and joint. A clip without frames has none.
std::vector<Finding> lint(const Clip& clip, const LintOptions& options = {},
                          const Clip* original = nullptr);

/// The finding of check `calibration-pose`: a different pose before the motion of a canonical body,
/// such as a T-pose in frame 0. None if the clip has no frames or non-finite numbers.
std::optional<Finding> calibration_pose(const Clip& clip);

/// Checks the data of a recording as it was read, before it is mapped to the canonical body, whose
/// bone lengths are constant: non-finite numbers and changing bone lengths.
std::vector<Finding> lint(const Recording& recording, const LintOptions& options = {});

}  // namespace mien::motion
