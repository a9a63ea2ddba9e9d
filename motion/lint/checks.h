#pragma once

#include <vector>

#include "motion/biomechanics/lint_motion.h"
#include "motion/biomechanics/support.h"
#include "motion/lint/finding.h"
#include "motion/lint/lint_options.h"

namespace mien::motion {

// The checks of the lint, one source file per group. All take a motion prepared by `lint_motion`;
// those that concern the whole body require the canonical body. `original` is the motion before
// modification; where it is a pointer, it may be null.

using Findings = std::vector<Finding>;

/// Thresholds of the checks that concern a whole take; chosen for this project. Lengths are for a
/// stature of 1.75 m. Quiet standing has a sway of some millimetres per second (Prieto et al.
/// 1996), above the threshold for frozen frames.
struct TakeLimits {
  double frozen_rad_s = 0.001;          ///< in frozen frames, no joint rotates faster, rad/s, …
  double frozen_m_s = 0.001;            ///< … and the root does not move faster, m/s
  Levels frozen_seconds = {0.25, 1.0};  ///< duration of a frozen interval
  double calibration_seconds = 0.1;     ///< maximum duration of a calibration pose that moves
  int calibration_joints = 3;           ///< the pose ends if more joints than this jump at once
  /// The pose also ends if half of the joints move this many times as far as afterwards.
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
Findings find_jumps(const LintMotion& motion, const LintOptions& options);

/// Finds jumps of hands, feet and head relative to the pelvis: changes of position that deviate
/// from the preceding change, from the following one and from their mean, and much more than any
/// other change within 0.3 s and the roughness of the path (path_noise.h) do. Jumps of a joint that
/// carries the limb (`joint_jumps`) are not found again unless they are less severe. Lengths are
/// for a stature of 1.75 m.
Findings find_limb_jumps(const LintMotion& motion, const LintOptions& options,
                         const Findings& joint_jumps);

/// Finds random trembling of hands, feet and head relative to the pelvis (path_noise.h). None below
/// 20 frames per second. Lengths are for a stature of 1.75 m.
Findings find_jitter(const LintMotion& motion, const LintOptions& options,
                     const LintMotion* original);

/// Whether from frame `step` to the next no joint rotates faster than `frozen_rad_s` and the root
/// does not move faster than `frozen_m_s`. For a walk in place, the root's velocity is that
/// before `lint_motion` converted the walk to a travelling one.
bool is_frozen(const LintMotion& motion, int step);

/// Finds frozen intervals, in which nothing moves. No finding if the rest of the motion moves for
/// less than `frozen_seconds.warning` in total.
Findings find_frozen(const LintMotion& motion, const LintMotion* original);

/// Finds a different pose before the motion, such as the T-pose of a calibration; at most one
/// finding, of the first frames. The pose ends with a step in which more than `calibration_joints`
/// joints (including the root) jump at once; or in which at least one jumps, while half of all
/// joints and more than `calibration_joints` rotate by more than 1° and by more than
/// `calibration_times` times their largest rotation per frame in the following
/// `calibration_seconds`. The pose lasts at most `calibration_seconds` or, if nothing moves
/// meanwhile, longer. No finding for loops.
Findings find_calibration_pose(const LintMotion& motion, const LintOptions& options);

/// Finds walking in place; the measured value is the speed of the floor, m/s. No finding for loops,
/// which may walk in place on purpose, nor if the original walks in place.
Findings find_walk_on_spot(const LintMotion& motion, const LintMotion* original);

/// Finds steady sliding of the whole body while both feet bear weight for at least `drift_seconds`:
/// both feet slide with the same constant velocity. No finding for loops.
Findings find_drift(const LintMotion& motion, const LintOptions& options,
                    const LintMotion* original);

/// Finds steady rising or sinking of the whole body over the take: a line fitted to the height of
/// the lower sole rises or sinks by more than the threshold and explains at least half of the
/// variance, and the median change per frame agrees with the slope of the line. On stairs and
/// slopes the two disagree, because the lower sole keeps its height while a foot stands. No finding
/// for loops.
Findings find_rise(const LintMotion& motion, const LintMotion* original);

/// Finds a jump at the seam of a loop. Measured is the deviation of the change over the seam from
/// the mean of the preceding and following changes, minus twice the deviation usual in the rest of
/// the loop (its 95th percentile). No finding for loops of fewer than 8 frames.
Findings find_broken_seam(const LintMotion& motion, const LintOptions& options);

/// Finds joint angles beyond the healthy range (joint_angles.h) and beyond those that the original
/// reaches. Wrists are measured from their mean direction and are not compared with the original.
Findings find_joints_beyond_limits(const LintMotion& motion, const LintOptions& options,
                                   const LintMotion* original);

/// Finds finger joints beyond their range (finger_angles.h) and beyond what the original's do.
/// Warnings only: where a straight finger lies differs between rigs. Nothing without fingers.
Findings find_fingers_beyond_limits(const LintMotion& motion, const LintOptions& options,
                                    const LintMotion* original);

/// Finds elbows that are bent backwards for at least 0.25 s: the forearm points away from forward
/// by more than the shoulder and the elbow together allow, and more than in the original. Not
/// measured of arms that are nearly straight or raised above horizontal by more than 30°.
Findings find_backward_elbows(const LintMotion& motion, const LintOptions& options,
                              const LintMotion* original);

/// Finds parts of the body (collision_shapes.h) that intersect more deeply than in relaxed standing
/// and than in the original. Depths are scaled to a stature of 1.75 m.
Findings find_self_intersections(const LintMotion& motion, const LintOptions& options,
                                 const LintMotion* original);

/// Finds feet that slide while they bear weight (weight_bearing.h), at any speed. With an original,
/// the thresholds are its largest slip plus 0.5 cm (warning; at least the warning level of
/// `options`) and plus 1.2 cm (error), and of each plant only the part counts in which the
/// original's foot stands too.
Findings find_skating_feet(const LintMotion& motion, const LintOptions& options,
                           const LintMotion* original);

/// Finds soles below the floor, y = 0.
Findings find_sunken_feet(const LintMotion& motion, const LintOptions& options,
                          const LintMotion* original);

/// Finds floating: the lower sole is above the floor although the body is not in free fall and does
/// not rest on a knee, hand or the pelvis.
Findings find_floating(const LintMotion& motion, const LintOptions& options,
                       const LintMotion* original);

/// Finds joints, other than wrists and toes, that rotate faster than humans can, and faster than in
/// the original.
Findings find_fast_joints(const LintMotion& motion, const LintOptions& options,
                          const LintMotion* original);

/// Finds loss of balance: while standing, the centre of mass outside the base of support; while
/// walking, the extrapolated centre of mass (Hof, Gazendam and Sinke 2005) beyond the outer edge of
/// the standing foot; at any time, the zero-moment point outside the base of support. `original`
/// and `original_body` are either both null or both given, here and below.
Findings find_lost_balance(const LintMotion& motion, const BodyOnFloor& body,
                           const LintOptions& options, const LintMotion* original,
                           const BodyOnFloor* original_body);

/// Finds impossible ground reaction forces: too large vertically, directed downwards, or with a
/// horizontal component that is too large relative to the vertical one.
Findings find_unnatural_forces(const LintMotion& motion, const BodyOnFloor& body,
                               const LintOptions& options, const LintMotion* original,
                               const BodyOnFloor* original_body);

/// Finds joint torques beyond those of strong adults (inverse_dynamics.h).
Findings find_unnatural_torques(const LintMotion& motion, const BodyOnFloor& body,
                                const LintOptions& options, const LintMotion* original,
                                const BodyOnFloor* original_body);

/// Finds feet that touch or leave the floor at other times than in the original, or are no longer
/// planted. Time shifts are in seconds of the original, here and in `find_shifted_limbs`, because a
/// motion may be slowed down as a whole.
Findings find_shifted_contacts(const LintMotion& motion, const LintOptions& options,
                               const LintMotion& original);

/// Finds hands, feet and head that move earlier or later than in the original. The shift is the one
/// with the highest correlation between the limb's path and its original path, in windows of 2 s
/// (of a loop: one lap), minus the median shift of the limbs (if at least three correlate well).
/// Also finds limbs whose correlation is low at every shift. Shifts are searched up to 0.6 s, and
/// up to half a period of a limb that moves periodically.
Findings find_shifted_limbs(const LintMotion& motion, const LintOptions& options,
                            const LintMotion& original);

/// Finds hands, feet and head that hardly move any more: measured is the share of the original's
/// movement (root mean square distance from the mean place, relative to the shoulder girdle, chest
/// or pelvis that carries the limb, in windows of 2 s; of a loop, one lap) that is gone, where the
/// original moves by at least 4 cm.
Findings find_still_limbs(const LintMotion& motion, const LintOptions& options,
                          const LintMotion& original);

/// Finds hands, feet and head that move more jerkily than in the original. Measured is the root
/// mean square, over 0.5 s, of the third derivative of their paths relative to chest or pelvis,
/// divided by its 90th percentile in the original (at least 10 m/s³).
Findings find_jerks(const LintMotion& motion, const LintOptions& options,
                    const LintMotion& original);

}  // namespace mien::motion
