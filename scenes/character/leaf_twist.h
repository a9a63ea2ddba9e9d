#pragma once

#include "motion/math/geometry.h"
#include "motion/skeleton/body.h"

namespace mien::scenes {

/// Limit of the twist of the body's end joints about their bones, radians: small for toes; for head
/// and hands roughly the anatomical range of neck and forearm; π, which is no limit, for other
/// joints.
///
/// Recordings and rigs do not determine the twist of an end joint, and linear blend skinning
/// collapses at half a turn (the candy-wrapper artefact).
double max_twist(motion::BodyJoint joint);

/// The rotation with its twist about the unit vector `axis` clamped to ± `most` radians.
motion::Quat clamped_twist(const motion::Quat& rotation, const motion::Vec3& axis, double most);

}  // namespace mien::scenes
