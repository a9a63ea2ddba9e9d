#pragma once

#include <string_view>
#include <vector>

#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// A part of the body as a segment whose roundness goes from one radius to another, metres.
struct Capsule {
  Vec3 from;
  Vec3 to;
  double from_radius = 0.0;
  double to_radius = 0.0;
};

/// A part of the body that others must not enter.
struct BodyPart {
  std::string_view name;  ///< "left forearm"
  BodyJoint joint;        ///< that carries it
};

/// Head, neck, chest, abdomen, pelvis, and on either side upper arm, forearm, hand, thigh, shank
/// and foot.
const std::vector<BodyPart>& body_parts();

/// The parts in a pose, in the order of `body_parts`; radii of an adult of 1.75 m, scaled.
std::vector<Capsule> body_capsules(const Skeleton& body, const JointTransforms& world);

/// How deep two capsules are in each other, metres; negative is the gap between them.
double depth(const Capsule& a, const Capsule& b);

/// Two parts that can be looked at: neither is joined to the other, nor to what the other is
/// joined to at one joint. `allowed` is how deep they are in each other while the body stands at
/// ease, at least 0, for round parts are only much like a body.
struct PartPair {
  int a = 0;
  int b = 0;
  double allowed = 0.0;
};

std::vector<PartPair> separate_parts(const Skeleton& body);

}  // namespace mien::motion
