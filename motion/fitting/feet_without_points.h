#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Height of an ankle above the floor while its foot lies flat, by the body's proportions, metres.
double ankle_height_on_floor(const Skeleton& body, bool left);

/// Sets that height for one foot, within 0.05 and 0.10 m (at a stature of 1.75 m).
void set_ankle_height(double height, bool left, Skeleton& body);

/// Height at which an ankle is while its foot stands: the median of the frames in which it is
/// slower than 0.3 m/s and less than 0.08 m above its lowest (3rd percentile); without such frames
/// its lowest. Metres.
double standing_ankle_height(const Clip& clip, bool left);

/// Turns a foot of which only the ankle is known, in a clip whose floor is at 0. While the ankle
/// is within 1 cm of the height at which it stands and the shank is less than 35° from upright, the
/// foot lies flat and points forward by the axis of the knee; from 6 cm and 60° on it is at a right
/// angle to the shank, as fitted; between, the rotations are interpolated smoothly. Then it is
/// turned about its own axis so that neither the ball nor the heel is in the floor, toes up by 40°
/// or down by 75° at most, more than the ankle itself. These limits are our decisions.
void turn_foot_by_floor(Clip& clip, bool left);

}  // namespace mien::motion
