#pragma once

#include <string_view>
#include <vector>

#include "motion/skeleton/pose.h"

namespace mien::motion {

/// Source of the segment masses and centres of mass.
enum class MassModel {
  de_leva_male,    ///< de Leva 1996, adjusted Zatsiorsky–Seluyanov, men; default
  de_leva_female,  ///< the same, women
  winter,          ///< Winter 2009, table 4.1 (after Dempster 1955)
};

/// One segment of a body at one moment.
struct SegmentMass {
  std::string_view name;       ///< "head", "trunk", "left upper arm", …
  double share = 0.0;          ///< fraction of the body mass
  Vec3 centre = Vec3::Zero();  ///< centre of mass, world space, metres
};

/// The 14 segments of the canonical body in a pose: head with neck, trunk, and on each side upper
/// arm, forearm, hand, thigh, shank and foot.
///
/// The trunk extends from the neck joint, which represents the 7th cervical vertebra, to the
/// midpoint between the hip joints. The centre of mass of the hand lies at the published distance
/// from the wrist, scaled with stature; that of the foot lies halfway between the ankle and toe
/// joints. Winter locates the centre of mass of the head at the ear canal, which the body does not
/// have; the midpoint between neck and vertex is used instead, about as in de Leva.
std::vector<SegmentMass> segment_masses(const Skeleton& body, const JointTransforms& pose,
                                        MassModel model = MassModel::de_leva_male);

/// Centre of mass of the body: Σ share · centre / Σ share over the segments; metres, world space.
Vec3 centre_of_mass(const Skeleton& body, const JointTransforms& pose,
                    MassModel model = MassModel::de_leva_male);

}  // namespace mien::motion
