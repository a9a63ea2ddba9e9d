#pragma once

#include "motion/math/geometry.h"
#include "motion/procedural/walk_style.h"

namespace mien::motion {

/// How the pelvis travels through a gait cycle of phase 0 … 1 (phase 0 is left heel strike), along
/// +Z with the path's line at x = 0.
struct PelvisPath {
  WalkStyle style;
  double stride_m = 0.0;       ///< forward per cycle
  double mean_height_m = 0.0;  ///< of the pelvis joint above the floor
};

/// Position of the pelvis joint: steady progress with the small surges of double support, two rises
/// a cycle (highest over the standing leg, lowest just after heel strike) and one sway to each
/// side.
Vec3 pelvis_position(const PelvisPath& path, double phase);

/// Rotation about the vertical, in the frontal plane, and forward tilt, in this order.
Quat pelvis_rotation(const PelvisPath& path, double phase);

}  // namespace mien::motion
