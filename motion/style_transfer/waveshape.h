#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A shape function S of an angle, radians.
struct Waveshape {
  double lower = -0.2;    ///< identity from here …
  double upper = 0.2;     ///< … to here
  double softness = 0.1;  ///< radians beyond the limit that are never exceeded; 0 is a hard limit
  /// When given, instead of limits: S runs as a monotone cubic through these (angle, shaped angle),
  /// angles ascending, and straight beyond its ends.
  std::vector<std::pair<double, double>> points;
};

/// S(angle): soft beyond the limits as y₀ + m(1 − exp(−(x − y₀)/m)).
double shaped(const Waveshape& shape, double angle);

struct JointWaveshape {
  BodyJoint joint = Pelvis;
  /// Unit vector in the parent's frame: the component of the rotation about it is shaped. Without
  /// one the whole angle is, direction kept, and the shape must be odd to make sense.
  std::optional<Vec3> axis;
  Waveshape shape;
};

struct WaveshapeOptions {
  double amount = 1.0;  ///< θ + amount·(S(θ) − θ)
};

/// Waveshaping (Bruderlin and Williams 1995): θ' = S(θ) frame by frame, θ being the rotation vector
/// of the joint about its mean (motion_curves.h). Throws Error when lower > upper, softness is
/// negative or points do not ascend.
Clip waveshaped(const Clip& motion, const std::vector<JointWaveshape>& shapes,
                const WaveshapeOptions& options = {});

/// The shapes that bring each joint's swing about its mean from that of `neutral` to that of
/// `styled`: one straight line a joint through the origin, its slope the ratio of root mean square
/// angles. Joints that swing less than 1° in the neutral motion are left out.
std::vector<JointWaveshape> shapes_between(const Clip& neutral, const Clip& styled);

}  // namespace mien::motion
