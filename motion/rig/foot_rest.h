#pragma once

#include <span>
#include <vector>

#include "motion/rig/rig_motion.h"

namespace mien::motion {

/// World directions in the coordinates of a foot's joints, summed over the frames in which the foot
/// stands flat. Only the directions of these vectors have a meaning; those of the toe are zero if
/// the rig has no rotating toe joint.
struct FootRest {
  Vec3 up = Vec3::Zero();           ///< world up, in the ankle's coordinates
  Vec3 forward = Vec3::Zero();      ///< ankle to toe, likewise; zero without a toe
  Vec3 toe_up = Vec3::Zero();       ///< world up, in the toe's coordinates
  Vec3 toe_forward = Vec3::Zero();  ///< horizontal direction from ankle to toe, likewise
  int frames = 0;                   ///< number of frames in which the foot stands flat
};

/// Frames in which the foot of `ankle` stands flat: both ankle and toe are low and slow. If there
/// are none, the tenth of the frames in which they are lowest.
std::vector<int> flat_frames(const RigMotion& motion, BodyJoint ankle);

FootRest foot_rest(std::span<const RigMotion> motions, BodyJoint ankle);

}  // namespace mien::motion
