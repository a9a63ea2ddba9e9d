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
  bool needs_original = false;  ///< says nothing without one
};

/// All rules, in the order in which their findings are told.
const std::vector<LintCheck>& lint_checks();

/// Looks a motion over for what no body does: broken data, joints beyond their range, parts of the
/// body in each other, feet that slide, sink or float, lost balance, forces and torques that
/// nobody has.
///
/// The clip is in metres, +Y up, its floor at y = 0; a loop is judged as going on for ever, and one
/// that walks in place as on a treadmill. Of a skeleton that is not the canonical body only the
/// data is checked. With an `original` (the motion before it was modified, on any canonical body)
/// what that did already counts less, and timing, phases and jerk are compared; it need not last
/// as long, since moments are compared by their share of the duration. Findings are ordered by
/// check, frame and joint. A clip without frames has none.
std::vector<Finding> lint(const Clip& clip, const LintOptions& options = {},
                          const Clip* original = nullptr);

/// The finding of check `calibration-pose`: another pose before the motion of a canonical body, as
/// a T-pose in frame 0. None where the clip has no frames, or numbers that are none.
std::optional<Finding> calibration_pose(const Clip& clip);

/// What is wrong with the data of a recording as it was read, before it is put on the canonical
/// body, whose bones never change: numbers that are none and bones that grow.
std::vector<Finding> lint(const Recording& recording, const LintOptions& options = {});

}  // namespace mien::motion
