#pragma once

#include "motion/procedural/walk_style.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/example.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// One cycle of a walk in the given style: looping, along +Z, x = 0 being the line walked on. The
/// cycle starts at left heel strike and lasts the nearest whole number of frames; step length is
/// kept. Keytimes: left heel strike, right toe off, left mid-stance (the right ankle passes the
/// left), right heel strike, left toe off, right mid-stance, left heel strike again.
///
/// The feet are fixed to the floor: they roll over heel and ball without slipping, and the legs
/// follow by two-bone inverse kinematics between the feet and the moving pelvis. The pelvis walks
/// as high as the style's `stance_knee_deg` allows, so no knee ever locks. The swing follows the
/// normal knee curve, bent so that it continues the stance on both sides with its speed and
/// acceleration.
///
/// Throws mien::Error when the style is impossible (steps longer than the legs reach, no swing or
/// no double support, not positive speed, cadence or frame rate).
Example walk(const WalkStyle& style, double frames_per_second, const Skeleton& body);

/// Sets the rotations of spine, chest, neck, head and both arms at a phase of the gait cycle (0 is
/// left heel strike), given the world rotation of the pelvis.
///
/// The trunk turns against the pelvis; the head looks where the walker goes and nods against the
/// rise and fall of the body; the arms hang from the shoulders in the world's vertical and swing
/// against the legs, forearm and hand following late.
void set_upper_body(const WalkStyle& style, double phase, const Quat& pelvis_rotation, Pose& pose);

}  // namespace mien::motion
