#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The sole of one foot in the frames of its joints, metres. Skeletons have no sole: it is assumed
/// to lie 0.02 m below the toe joint, to reach 0.045 m behind the ankle and, if the toe joint has
/// no tip, 0.06 m beyond the toe joint, for a stature of 1.75 m.
struct SoleShape {
  double depth;  ///< of the sole below the toe joint
  Vec3 heel;     ///< back edge, in the ankle's frame
  Vec3 ball;     ///< under the toe joint, in the ankle's frame
  Vec3 toes;     ///< end of the toes, in the toe joint's frame, `depth` above the sole
};

SoleShape sole_shape(const Skeleton& body, bool left);

/// Depth of the soles below the toe joints, metres.
double sole_depth(const Skeleton& body);

/// The points of one foot that touch the floor, world space.
struct SolePoints {
  Vec3 heel;  ///< back edge; rotates with the ankle
  Vec3 ball;  ///< under the toe joint
  Vec3 tip;   ///< under the end of the toes; rotates with the toe joint
};

SolePoints sole_points(const Skeleton& body, const JointTransforms& world, bool left);

/// The sole points of one foot in every frame.
std::vector<SolePoints> sole_paths(const Clip& clip, bool left);

}  // namespace mien::motion
