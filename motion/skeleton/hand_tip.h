#pragma once

#include "motion/skeleton/pose.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// Length of a hand from the wrist to the tip of the middle finger, metres: 0.108 of the stature
/// (Drillis and Contini 1966), 0.189 at 1.75 m.
double hand_length(const Skeleton& body);

/// From a wrist of the canonical body to the tip of its stretched hand, metres, world axes.
Vec3 hand_vector(const Skeleton& body, const Pose& pose, bool left);

/// The tip of a stretched hand of the canonical body, metres, world axes.
Vec3 hand_tip(const Skeleton& body, const Pose& pose, bool left);

}  // namespace mien::motion
