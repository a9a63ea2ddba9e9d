#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A shape function S of an angle, radians.
struct Waveshape {
  double lower = -0.2;    ///< lower limit: S is the identity between the limits
  double upper = 0.2;     ///< upper limit
  double softness = 0.1;  ///< S exceeds a limit by less than this, radians; 0: a hard limit
  /// If given, used instead of the limits: S is a monotone cubic through these (angle, shaped
  /// angle) pairs, with angles ascending, and linear beyond the ends.
  std::vector<std::pair<double, double>> points;
};

/// S(angle). Beyond the upper limit y₀ it is y₀ + m(1 − exp(−(x − y₀)/m)), with m the softness; the
/// lower limit is softened in the same way.
double shaped(const Waveshape& shape, double angle);

struct JointWaveshape {
  BodyJoint joint = Pelvis;
  /// Unit vector in the parent's frame: the component of the rotation vector along it is shaped.
  /// Without an axis, the whole angle is shaped and the direction kept; S should then be odd.
  std::optional<Vec3> axis;
  Waveshape shape;
};

struct WaveshapeOptions {
  double amount = 1.0;  ///< θ + amount·(S(θ) − θ)
};

/// Waveshaping (Bruderlin and Williams 1995): θ' = S(θ) frame by frame, where θ is the joint's
/// rotation vector relative to its mean (motion_curves.h). Throws Error if lower > upper, softness
/// is negative, there is only one point, or the angles of points do not ascend.
Clip waveshaped(const Clip& motion, const std::vector<JointWaveshape>& shapes,
                const WaveshapeOptions& options = {});

/// The shapes that scale each joint's swing about its mean from that of `neutral` to that of
/// `styled`: per joint a straight line through the origin whose slope is the ratio of root mean
/// square angles. Joints that swing by less than 1° in the neutral motion are omitted.
std::vector<JointWaveshape> shapes_between(const Clip& neutral, const Clip& styled);

}  // namespace mien::motion
