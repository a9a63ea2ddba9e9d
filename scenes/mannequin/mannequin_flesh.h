#pragma once

#include <array>
#include <vector>

#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"
#include "scenes/figures/figure.h"
#include "scenes/mannequin/sdf_primitive.h"

namespace mien::scenes {

/// The implicit surface of a body as SDF primitives, limb by limb. Limbs blend with the trunk; the
/// two arms do not blend with each other, and the two legs only within about a centimetre.
struct Flesh {
  std::vector<SdfPrimitive> trunk;  ///< including the head
  std::vector<SdfPrimitive> left_arm;
  std::vector<SdfPrimitive> right_arm;
  std::vector<SdfPrimitive> left_leg;
  std::vector<SdfPrimitive> right_leg;
};

/// Signed distances to the five parts of Flesh, in their order.
using LimbDistances = std::array<double, 5>;
LimbDistances limb_distances(const Flesh& flesh, const motion::Vec3& point);

/// Approximate signed distance to the whole body: negative inside.
double signed_distance(const Flesh& flesh, const motion::Vec3& point);

/// The same from the distances to its parts.
double united(const Flesh& flesh, const LimbDistances& distances);

/// The bind pose of a mannequin (an A-pose): arms 50° below the horizontal and legs slightly apart,
/// so that limbs do not touch and the pose is close both to walking and to raised arms. Clavicles
/// are raised by `collar_lift`. The soles touch y = 0.
motion::Pose modelling_pose(const motion::Skeleton& body);

/// The implicit surface of a body in its `modelling_pose`, whose joint transforms are `pose`:
/// widths and shapes of an adult, modelled by eye, scaled to the body's stature and bones. The
/// soles are those of motion/skeleton/sole.h. Hands have five fingers if `pose` includes them
/// (mannequin_hand.h); otherwise palm and fingers are one piece.
Flesh flesh_of(const motion::Skeleton& body, const motion::JointTransforms& pose,
               const MannequinOptions& options);

}  // namespace mien::scenes
