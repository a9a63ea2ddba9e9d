#pragma once

#include "motion/procedural/walk_style.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// Sets the rotations of spine, chest, neck, head and both arms at a phase of the gait cycle (0 is
/// left heel strike), given the world rotation of the pelvis.
///
/// The trunk turns against the pelvis; the head looks where the walker goes and nods against the
/// rise and fall of the body; the arms hang from the shoulders in the world's vertical and swing
/// against the legs, forearm and hand following late.
void set_upper_body(const WalkStyle& style, double phase, const Quat& pelvis_rotation, Pose& pose);

}  // namespace mien::motion
