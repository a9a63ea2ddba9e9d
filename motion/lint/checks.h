#pragma once

#include <vector>

#include "motion/biomechanics/subject.h"
#include "motion/biomechanics/support.h"
#include "motion/lint/finding.h"
#include "motion/lint/lint_options.h"

namespace mien::motion {

// The checks of the lint, one source file per group. All take a motion prepared by `lint_subject`;
// those that concern the whole body require the canonical body. `original` may be null where it is
// a pointer.

using Findings = std::vector<Finding>;

/// Thresholds of the checks that concern a whole take; chosen for this project. Lengths are for a
/// stature of 1.75 m. Quiet standing has a sway of some millimetres per second (Prieto et al.
/// 1996), above the threshold for frozen frames.
struct TakeLimits {
  double frozen_rad_s = 0.001;          ///< in frozen frames, no joint rotates faster, rad/s, …
  double frozen_m_s = 0.001;            ///< … and the root does not move faster, m/s
  Levels frozen_seconds = {0.25, 1.0};  ///< duration of a frozen interval
  double calibration_seconds = 0.1;     ///< start of the take in which a calibration pose may end
  int calibration_joints = 3;           ///< the pose ends if more joints than this jump at once
  /// Or the pose ends if half of the joints move farther than afterwards by this factor.
  double calibration_times = 5.0;
  double drift_seconds = 1.0;        ///< minimum duration of standing on both feet for `find_drift`
  Levels rise_metres = {0.03, 0.1};  ///< rise or fall of the whole body over a take
};
inline constexpr TakeLimits take_limits;

/// Finds non-finite numbers, invalid rotations and changing bone lengths in the clip as given.
Findings find_broken_data(const Clip& clip, const LintOptions& options);

/// Whether the data of a clip is valid, so that the other checks can be computed.
bool is_calculable(const Clip& clip);

/// Finds jumps: changes of rotation or root position from one frame to the next that deviate more
/// from the mean of the preceding and following changes than any body can move, however fast. The
/// seam of a loop is checked by `find_broken_seam`.
Findings find_jumps(const LintSubject& subject, const LintOptions& options);

/// Whether neither a joint nor the root moves from frame `step` to the next, to within
/// `frozen_rad_s` and `frozen_m_s`. In a walk in place, the velocity of the floor is subtracted.
bool is_frozen(const LintSubject& subject, int step);

/// Finds frozen intervals: nothing moves, although the motion otherwise moves for at least
/// `frozen_seconds.warning` in total.
Findings find_frozen(const LintSubject& subject, const LintSubject* original);

/// Finds a different pose before the motion, such as the T-pose of a calibration; at most one
/// finding, of the first frames. The pose ends with a step in which more than `calibration_joints`
/// joints (including the root) jump at once; or in which at least one jumps, while half of all
/// joints and more than `calibration_joints` rotate by more than 1° and `calibration_times` as far
/// as in the following `calibration_seconds`. The pose lasts at most `calibration_seconds`, or
/// longer as long as nothing moves. Loops have none.
Findings find_calibration_pose(const LintSubject& subject, const LintOptions& options);

/// Finds walking in place; the measured value is the speed of the floor, m/s. No finding for loops,
/// which are in place on purpose, nor if the original also walks in place.
Findings find_walk_on_spot(const LintSubject& subject, const LintSubject* original);

/// Finds steady sliding of the whole body while both feet bear weight for at least `drift_seconds`:
/// both feet slide by the same displacement at a constant velocity. No finding for loops.
Findings find_drift(const LintSubject& subject, const LintOptions& options,
                    const LintSubject* original);

/// Finds steady rising or sinking of the whole body over the take: a line fitted to the height of
/// the lower sole rises by more than the threshold and explains half of the variance, and the
/// median change per frame agrees with the slope of the line. On stairs and slopes this is not so,
/// because feet are level most of the time. No finding for loops.
Findings find_rise(const LintSubject& subject, const LintSubject* original);

/// Finds a jump at the seam of a loop, compared with the changes per frame elsewhere in the loop.
Findings find_broken_seam(const LintSubject& subject, const LintOptions& options);

/// Finds joint angles beyond the healthy range (joint_angles.h) and beyond those of the original.
Findings find_joints_beyond_limits(const LintSubject& subject, const LintOptions& options,
                                   const LintSubject* original);

/// Finds parts of the body (collision_shapes.h) that intersect more deeply than in relaxed standing
/// and than in the original. Depths are scaled to a stature of 1.75 m.
Findings find_self_intersections(const LintSubject& subject, const LintOptions& options,
                                 const LintSubject* original);

/// Finds feet that slide while they bear weight (weight_bearing.h), at any speed. With an original,
/// the thresholds are 0.5 cm (warning, but at least that of `options`) and 1.2 cm (error) more than
/// its largest slip.
Findings find_skating_feet(const LintSubject& subject, const LintOptions& options,
                           const LintSubject* original);

/// Finds soles below the floor, y = 0.
Findings find_sunken_feet(const LintSubject& subject, const LintOptions& options,
                          const LintSubject* original);

/// Finds floating: the lower sole is above the floor although the body is not in free fall and does
/// not rest on a knee, hand or the pelvis.
Findings find_floating(const LintSubject& subject, const LintOptions& options,
                       const LintSubject* original);

/// Finds joints that rotate faster than humans can, and faster than in the original.
Findings find_fast_joints(const LintSubject& subject, const LintOptions& options,
                          const LintSubject* original);

/// Finds loss of balance: while standing, the centre of mass outside the base of support; while
/// walking, the extrapolated centre of mass (Hof, Gazendam and Sinke 2005) beyond the outer edge of
/// the standing foot; at any time, the zero-moment point outside the base of support. `original`
/// and `original_body` are either both null or both given, here and below.
Findings find_lost_balance(const LintSubject& subject, const BodyOnFloor& body,
                           const LintOptions& options, const LintSubject* original,
                           const BodyOnFloor* original_body);

/// Finds impossible ground reaction forces: too large vertically, directed downwards, or with a
/// horizontal component that is too large relative to the vertical one.
Findings find_unnatural_forces(const LintSubject& subject, const BodyOnFloor& body,
                               const LintOptions& options, const LintSubject* original,
                               const BodyOnFloor* original_body);

/// Finds joint torques beyond those of strong adults (inverse_dynamics.h).
Findings find_unnatural_torques(const LintSubject& subject, const BodyOnFloor& body,
                                const LintOptions& options, const LintSubject* original,
                                const BodyOnFloor* original_body);

/// Finds feet that touch or leave the floor at other times than in the original, or are no longer
/// planted. Time shifts are in seconds of the original, here and below, because a motion may be
/// slowed down as a whole.
Findings find_shifted_contacts(const LintSubject& subject, const LintOptions& options,
                               const LintSubject& original);

/// Finds hands, feet and head that move earlier or later than in the original. The shift is that
/// with the highest correlation between the path of the limb and its original path, minus the shift
/// common to the limbs; in windows of 2 s. Also finds limbs whose correlation is low at any shift.
Findings find_shifted_limbs(const LintSubject& subject, const LintOptions& options,
                            const LintSubject& original);

/// Finds hands, feet and head that move more jerkily than in the original: root mean square, over
/// 0.5 s, of the third derivative of their paths relative to the trunk.
Findings find_jerks(const LintSubject& subject, const LintOptions& options,
                    const LintSubject& original);

}  // namespace mien::motion
