#pragma once

#include "motion/math/geometry.h"
#include "motion/skeleton/body.h"

namespace mien::scenes {

/// How far the body's last joints twist about their bones in a character, radians: toes hardly,
/// head and hands about as far as they go with neck and forearm. No limit for other joints.
///
/// Nothing in a recording or a rig tells how an end is twisted, and linear blend skinning draws a
/// twist of half a turn as a candy's wrapper.
double most_twist_of(motion::BodyJoint joint);

/// The rotation with its twist about the unit vector `axis` brought within `most` radians.
motion::Quat with_twist_within(const motion::Quat& rotation, const motion::Vec3& axis, double most);

}  // namespace mien::scenes
