#pragma once

#include <vector>

#include "motion/biomechanics/subject.h"
#include "motion/biomechanics/support.h"
#include "motion/lint/finding.h"
#include "motion/lint/lint_options.h"

namespace mien::motion {

// The checks of the lint, a file each. All take a motion prepared by `lint_subject`; those of
// whole bodies need the canonical one. `original` may be null where it is a pointer.

using Findings = std::vector<Finding>;

/// Thresholds of the checks of a take as a whole; our decisions. Lengths are for a stature of 1.75
/// m. Quiet standing sways by some millimetres a second (Prieto et al. 1996), which is more than
/// frozen frames move.
struct TakeLimits {
  double frozen_rad_s = 0.001;          ///< no joint turns faster in frozen frames…
  double frozen_m_s = 0.001;            ///< …nor does the root move faster
  Levels frozen_seconds = {0.25, 1.0};  ///< as long
  double calibration_seconds = 0.1;     ///< at the start, in which a take may leap out of a pose
  int calibration_joints = 3;           ///< more than these leap at once then…
  double calibration_times = 5.0;       ///< …or half of them step so much farther than after it
  double drift_seconds = 1.0;           ///< on both feet, at least
  Levels rise_metres = {0.03, 0.1};     ///< of the whole body over a take
};
inline constexpr TakeLimits take_limits;

/// Non-finite numbers, invalid rotations and changing bone lengths of the clip as given.
Findings find_broken_data(const Clip& clip, const LintOptions& options);

/// Whether the clip's data is valid, so that the other checks can be computed.
bool is_calculable(const Clip& clip);

/// Rotations and root positions that step farther between two frames than the mean of the steps
/// before and after: no body moves so, however fast it is. The seam of a loop is checked by
/// find_broken_seam.
Findings find_jumps(const LintSubject& subject, const LintOptions& options);

/// Whether neither a joint nor the root moves from frame `step` to the next, to within
/// `frozen_rad_s` and `frozen_m_s`; the floor's velocity under a walk in place is ignored.
bool is_frozen(const LintSubject& subject, int step);

/// Stretches in which everything is frozen, of motions that move elsewhere for `frozen_seconds`.
Findings find_frozen(const LintSubject& subject, const LintSubject* original);

/// One finding at most: the first frames, where more than `calibration_joints` joints (the root is
/// one) leap at once out of the pose that they show, as out of the T-pose of a calibration. Or one
/// leaps, and half of all joints and more than `calibration_joints` step by more than 1° and
/// `calibration_times` as far as in the `calibration_seconds` that follow. The pose lasts so long
/// at most, or until something moves. None of loops.
Findings find_calibration_pose(const LintSubject& subject, const LintOptions& options);

/// Walks on the spot, and how fast the floor would move under them. No finding for loops, which are
/// in place on purpose, nor if the original walks in place too.
Findings find_walk_on_spot(const LintSubject& subject, const LintSubject* original);

/// Bodies that slide steadily as a whole while both feet bear for `drift_seconds` or more: both
/// feet go the same way, by the same amount, at a constant velocity. None of loops.
Findings find_drift(const LintSubject& subject, const LintOptions& options,
                    const LintSubject* original);

/// Bodies that rise or sink steadily over the whole take: a line through the heights of the lower
/// sole over time climbs so far and explains half of their variance, and the median climb from
/// frame to frame is that of the line: who goes up stairs or a slope stands level most of the time.
/// None of loops.
Findings find_rise(const LintSubject& subject, const LintSubject* original);

/// A jump over a loop's seam, compared with the steps elsewhere in the loop.
Findings find_broken_seam(const LintSubject& subject, const LintOptions& options);

/// Angles beyond the healthy range (joint_angles.h) and beyond what the original did.
Findings find_joints_beyond_limits(const LintSubject& subject, const LintOptions& options,
                                   const LintSubject* original);

/// Parts of the body (collision_shapes.h) in each other, deeper than while standing at ease and
/// than in the original. Depths are scaled to a stature of 1.75 m.
Findings find_self_intersections(const LintSubject& subject, const LintOptions& options,
                                 const LintSubject* original);

/// Feet that slide while they bear the body (weight_bearing.h), however fast. Against an original,
/// what they slid more than there is an error sooner.
Findings find_skating_feet(const LintSubject& subject, const LintOptions& options,
                           const LintSubject* original);

/// Soles below the floor, y = 0.
Findings find_sunken_feet(const LintSubject& subject, const LintOptions& options,
                          const LintSubject* original);

/// Frames in which the lower sole hangs above the floor, though the body does not fall freely and
/// rests on no knee, hand or seat.
Findings find_floating(const LintSubject& subject, const LintOptions& options,
                       const LintSubject* original);

/// Joints that turn faster than people can, and than they did in the original.
Findings find_fast_joints(const LintSubject& subject, const LintOptions& options,
                          const LintSubject* original);

/// Standing, the centre of mass outside the feet; walking, the extrapolated centre of mass (Hof,
/// Gazendam and Sinke 2005) outward of the standing foot; the zero-moment point beside the feet.
/// `original` and `original_body` are both null or neither, here and below.
Findings find_lost_balance(const LintSubject& subject, const BodyOnFloor& body,
                           const LintOptions& options, const LintSubject* original,
                           const BodyOnFloor* original_body);

/// The floor's force on the feet: too large, upward from below, or too much sideways.
Findings find_unnatural_forces(const LintSubject& subject, const BodyOnFloor& body,
                               const LintOptions& options, const LintSubject* original,
                               const BodyOnFloor* original_body);

/// Torques beyond what strong adults have (inverse_dynamics.h).
Findings find_unnatural_torques(const LintSubject& subject, const BodyOnFloor& body,
                                const LintOptions& options, const LintSubject* original,
                                const BodyOnFloor* original_body);

/// Feet that come down or leave the floor at other moments than in the original, or stand no more.
/// Shifts count in seconds of the original, here and below: a motion may be slowed down as a whole.
Findings find_shifted_contacts(const LintSubject& subject, const LintOptions& options,
                               const LintSubject& original);

/// Limbs that come earlier or later than in the original: the shift at which the ways of hands,
/// feet and head correlate best with theirs there, less what the limbs share; over 2 s each.
Findings find_shifted_limbs(const LintSubject& subject, const LintOptions& options,
                            const LintSubject& original);

/// Hands, feet and head that move more jerkily than in the original: root mean square of the third
/// derivative of their ways from the trunk over 0.5 s.
Findings find_jerks(const LintSubject& subject, const LintOptions& options,
                    const LintSubject& original);

}  // namespace mien::motion
