#pragma once

#include <array>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::scenes {

/// Triangles of a head, seen from its joint: x to its left, y up, z to its front, metres.
using HeadTriangles = std::vector<std::array<motion::Vec3, 3>>;

/// What is seen of a head from its front, in the directions of HeadTriangles.
struct FrontOfHead {
  /// The box of its outline: left and right as far as the surface reaches without a gap, up to its
  /// top and down to its chin.
  Eigen::AlignedBox2d outline;
  /// Points that are seen of its surface within the ellipse of this box, a grid of 90 rows from the
  /// joint to the crown; those farther back than half of the head's depth behind the nose omitted.
  std::vector<motion::Vec3> face;
};

/// The front of a head. The nose is the foremost point in its middle, of those between 0.15 and 0.7
/// of the height of its crown above the joint; the chin is where the profile below it recedes by
/// 0.25 of the head's depth, towards the neck, or else 0.35 of the height of the crown below the
/// joint. Hair that hangs beside the face, behind its middle, is outside the outline. `face` is
/// empty if nothing is in front of the joint.
FrontOfHead front_of_head(const HeadTriangles& head);

}  // namespace mien::scenes
