#pragma once

#include <array>
#include <vector>

#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"
#include "scenes/figures/figure.h"
#include "scenes/mannequin/lump.h"

namespace mien::scenes {

/// The flesh on a body's bones, limb by limb. Limbs flow into the trunk, not into each other.
struct Flesh {
  std::vector<Lump> trunk;  ///< with the head
  std::vector<Lump> left_arm;
  std::vector<Lump> right_arm;
  std::vector<Lump> left_leg;
  std::vector<Lump> right_leg;
};

/// Distances to the five parts of the flesh, as they are listed there.
using LimbDistances = std::array<double, 5>;
LimbDistances limb_distances(const Flesh& flesh, const motion::Vec3& point);

/// Signed distance, nearly, to all of it: negative inside.
double signed_distance(const Flesh& flesh, const motion::Vec3& point);

/// The pose in which a mannequin is modelled: arms hang away from the body at 50° below the
/// horizontal and legs are slightly apart, so that limbs are free of each other and neither walking
/// nor raised arms are far away. Collar bones lie as they are carried (`collar_lift`). The pelvis
/// stands where the soles touch y = 0.
motion::Pose modelling_pose(const motion::Skeleton& body);

/// Flesh for a body in that pose: breadths and bulges of an adult, modelled by eye, at the body's
/// own stature and on its own bones. The soles lie where motion/skeleton/sole.h has them.
Flesh flesh_of(const motion::Skeleton& body, const motion::JointTransforms& pose,
               const MannequinOptions& options);

}  // namespace mien::scenes
