#pragma once

#include <string_view>
#include <vector>

#include "motion/skeleton/pose.h"

namespace mien::motion {

/// The source of the masses and centres of mass of a body's segments.
enum class MassModel {
  de_leva_male,    ///< de Leva 1996, adjusted Zatsiorsky–Seluyanov, men; default
  de_leva_female,  ///< the same, women
  winter,          ///< Winter 2009, table 4.1 (after Dempster 1955)
};

/// One segment of a body at one moment.
struct SegmentMass {
  std::string_view name;       ///< "head", "trunk", "left upper arm", …
  double share = 0.0;          ///< of the body's mass
  Vec3 centre = Vec3::Zero();  ///< of its mass, world space, metres
};

/// The 14 segments of the canonical body in a pose: head with neck, trunk, and on either side upper
/// arm, forearm, hand, thigh, shank and foot.
///
/// The neck joint represents the 7th cervical vertebra, the middle between the hip joints for the
/// trunk's lower end. The hand's centre lies the published distance beyond the wrist, scaled with
/// stature; the foot's halfway from ankle to toe joint. Winter gives the head's centre at the ear
/// canal, which the body does not have: the middle between neck and vertex is taken, as by de Leva.
std::vector<SegmentMass> segment_masses(const Skeleton& body, const JointTransforms& pose,
                                        MassModel model = MassModel::de_leva_male);

/// Σ share · centre / Σ share over the segments; metres, world space.
Vec3 centre_of_mass(const Skeleton& body, const JointTransforms& pose,
                    MassModel model = MassModel::de_leva_male);

}  // namespace mien::motion
