#pragma once

#include <vector>

#include "motion/skeleton/pose.h"
#include "motion/skeleton/skeleton.h"
#include "scenes/mannequin/mannequin_flesh.h"
#include "scenes/skinning/skinned_model.h"

namespace mien::scenes {

/// Skinning weights of a point of the mannequin's surface, in the bind pose `pose`.
///
/// A point belongs to the nearest limb, blended with the trunk where both are about as near; along
/// a limb the weights pass from joint to joint over a zone about as long as the limb is thick.
/// Points where two legs or arms are equally near belong to the trunk, so that limbs that happen to
/// be close do not influence each other. In a pose that includes fingers (mannequin_hand.h), these
/// have their own joints (motion::with_fingers).
std::vector<Influence> mannequin_weights(const motion::Skeleton& body,
                                         const motion::JointTransforms& pose, const Flesh& flesh,
                                         const motion::Vec3& point);

}  // namespace mien::scenes
