#pragma once

#include <vector>

#include "motion/math/spring_damper.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A part of the body that hangs on a joint by a spring and a damper, frame by frame, in the frame
/// of the joint's parent.
struct SuspendedPart {
  struct Moment {
    Vec3 bone = Vec3::UnitY();    ///< direction in which the part is meant to point, unit
    Vec3 rate = Vec3::Zero();     ///< of the bone until the next frame, radians/s
    Vec3 lever = Vec3::Zero();    ///< from the joint to the part's centre of mass, metres
    double inertia = 1.0;         ///< about the joint, per mass: m²
    Vec3 field = Vec3::Zero();    ///< force per mass that the spring must hold, m/s²
    double least_hinge = -10.0;   ///< of a hinge: the least deflection, radians
    Vec3 outward = Vec3::Zero();  ///< unit, away from the body; zero: nothing is in the way
    double least_outward = -1.0;  ///< the least part of the bone in that direction
  };
  std::vector<Moment> moments;  ///< one per frame
  SpringDamper spring;
  Vec3 hinge = Vec3::Zero();  ///< unit axis of the only deflection; zero: any but twists
  double largest = 1.0;       ///< deflection, radians; near it, weight deflects no farther
};

/// Deflections of the part as rotation vectors in the frame of the joint's parent, one per frame.
std::vector<Vec3> deflections(const SuspendedPart& part, double frames_per_second, bool loops);

/// The deflection by a field (m/s²) that ordinary muscles of that frequency (radians/s) hold, in
/// one frame.
Vec3 static_deflection(const SuspendedPart::Moment& moment, const Vec3& hinge, const Vec3& field,
                       double frequency, double largest);

}  // namespace mien::motion
