#pragma once

#include <vector>

#include "motion/biomechanics/body_on_floor.h"
#include "motion/biomechanics/subject.h"
#include "motion/lint/finding.h"
#include "motion/lint/lint_options.h"

namespace mien::motion {

// The checks of the lint, a file each. All take a motion made ready by `lint_subject`; those of
// whole bodies need the canonical one. `original` may be null where it is a pointer.

using Findings = std::vector<Finding>;

/// Numbers that are none, rotations that are none and bones that grow, of the clip as it was given.
Findings find_broken_data(const Clip& clip, const LintOptions& options);

/// Whether there is nothing in the clip that other checks could not calculate with.
bool is_calculable(const Clip& clip);

/// Rotations and root positions that step farther between two frames than the mean of the steps
/// before and after: no body moves so, however fast it is. A loop's seam is left to the next.
Findings find_jumps(const LintSubject& subject, const LintOptions& options);

/// The step over a loop's seam, likewise, against what the steps elsewhere in the loop do.
Findings find_broken_seam(const LintSubject& subject, const LintOptions& options);

/// Angles beyond the healthy range (joint_angles.h) and beyond what the original did.
Findings find_joints_beyond_limits(const LintSubject& subject, const LintOptions& options,
                                   const LintSubject* original);

/// Parts of the body (body_capsules.h) in each other, deeper than while standing at ease and than
/// in the original. Depths are scaled to a stature of 1.75 m.
Findings find_self_intersections(const LintSubject& subject, const LintOptions& options,
                                 const LintSubject* original);

/// Feet that slide while they bear the body (bearing.h), however fast. Against an original, what
/// they slid more than there is an error sooner.
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
/// The originals are both null or neither; likewise below.
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
