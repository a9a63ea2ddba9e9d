#pragma once

#include <string_view>
#include <vector>

#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// A round cone (tapered capsule) around a segment, metres.
struct RoundCone {
  Vec3 from;
  Vec3 to;
  double from_radius = 0.0;
  double to_radius = 0.0;
};

/// A part of the body that is tested for self-intersection.
struct CollisionPart {
  std::string_view name;  ///< "left forearm"
  BodyJoint joint;        ///< the joint whose frame the part follows
};

/// Head, neck, chest, abdomen, pelvis, and on either side upper arm, forearm, hand, thigh, shank
/// and foot.
const std::vector<CollisionPart>& collision_parts();

/// The shapes of the parts in a pose, in the order of `collision_parts`, world space. Radii are
/// those of an adult of 1.75 m, scaled to the body.
std::vector<RoundCone> collision_shapes(const Skeleton& body, const JointTransforms& world);

/// Penetration depth of two shapes where their axes are nearest to each other, metres. Negative if
/// the shapes do not overlap there.
double penetration_depth(const RoundCone& a, const RoundCone& b);

/// A pair of parts to test for intersection. Pairs within the trunk and head (head, neck, chest,
/// abdomen, pelvis) are not tested, nor are parts that follow the same joint or two joints joined
/// by one bone. `allowed` is the penetration depth in a relaxed standing pose, metres, at least 0:
/// it is tolerated because the shapes only approximate a body.
struct CollisionPair {
  int a = 0;
  int b = 0;
  double allowed = 0.0;
};

std::vector<CollisionPair> collision_pairs(const Skeleton& body);

}  // namespace mien::motion
