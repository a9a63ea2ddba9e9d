#pragma once

#include "motion/procedural/walk_style.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/example.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// One cycle of a walk in the given style: a loop along +Z on the line x = 0. The cycle starts at
/// left heel strike and lasts the nearest whole number of frames, at least 8; the step length is
/// exact. Keytimes: left heel strike, right toe off, left mid-stance (the right ankle passes the
/// left), right heel strike, left toe off, right mid-stance, left heel strike again.
///
/// The feet are fixed to the floor: they roll over heel and ball without slipping, and the legs
/// follow by two-bone inverse kinematics between the feet and the moving pelvis. The pelvis is as
/// high as possible without the knee of a stance leg being straighter than the style's
/// `stance_knee_deg`. The swing follows the normal knee curve, adjusted so that it joins the stance
/// at both ends without jumps (`fit_swing`, leg_cycle.h).
///
/// Throws mien::Error when steps are too long for the legs, when `stance_share` is not between 0.5
/// and 0.85, when `heel_strike_deg` or `toe_off_deg` is negative, and when speed, cadence or frame
/// rate is not positive.
Example walk(const WalkStyle& style, double frames_per_second, const Skeleton& body);

/// Sets the rotations of spine, chest, neck, head and both arms at a phase of the gait cycle (0 is
/// left heel strike), given the world rotation of the pelvis.
///
/// The trunk rotates opposite to the pelvis; the head faces the direction of travel and pitches to
/// compensate for the body's vertical motion; the arms hang vertically in world space and swing
/// opposite to the legs, with forearm and hand lagging.
void set_upper_body(const WalkStyle& style, double phase, const Quat& pelvis_rotation, Pose& pose);

}  // namespace mien::motion
