#pragma once

#include <vector>

#include "motion/skeleton/pose.h"
#include "motion/skeleton/skeleton.h"
#include "scenes/mannequin/mannequin_flesh.h"
#include "scenes/skinning/skinned_model.h"

namespace mien::scenes {

/// Which joints of the body a point of the mannequin's surface follows, as modelled in `pose`.
///
/// A point belongs to the limb whose flesh is nearest, softly to the trunk as well where both are
/// about as near; along a limb each joint takes over from the one before across a soft zone about
/// as long as the limb is thick. Points where two legs or arms are equally near belong to the
/// trunk, so that limbs which only happen to be close have no influence on each other.
std::vector<Influence> mannequin_weights(const motion::Skeleton& body,
                                         const motion::JointTransforms& pose, const Flesh& flesh,
                                         const motion::Vec3& point);

}  // namespace mien::scenes
