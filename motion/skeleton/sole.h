#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The points of one foot that touch the floor, world space. A skeleton has no sole: it is taken to
/// lie 0.02 m below the toe joint and to reach 0.045 m behind the ankle, for a stature of 1.75 m.
struct SolePoints {
  Vec3 heel;  ///< back edge; turns with the ankle
  Vec3 ball;  ///< under the toe joint
  Vec3 tip;   ///< under the end of the toes; turns with the toe joint
};

SolePoints sole_points(const Skeleton& body, const JointTransforms& world, bool left);

/// The sole of one foot in every frame.
std::vector<SolePoints> sole_paths(const Clip& clip, bool left);

}  // namespace mien::motion
