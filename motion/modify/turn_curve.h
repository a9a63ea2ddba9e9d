#pragma once

#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The rotations of one joint as turns from their mean.
struct TurnCurve {
  Quat mean;                ///< Karcher mean over the clip
  std::vector<Vec3> turns;  ///< rotation vectors, radians: rotation = mean · exp(turn); continuous,
                            ///< so they may exceed π
};

/// The turns of a joint, frame by frame. The clip has at least one frame.
TurnCurve turn_curve(const Clip& clip, int joint);

/// Sets the rotations of a joint from its turns. The curve has as many entries as the clip has
/// frames.
void set_rotations(Clip& clip, int joint, const TurnCurve& curve);

}  // namespace mien::motion
