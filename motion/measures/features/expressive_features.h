#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Families of expressive features, after the description of expressive movement by how the body is
/// held, when it moves and with what effort (compare Laban's shape, time and weight).
enum class FeatureFamily {
  shape,     ///< mean posture and extent of the body
  timing,    ///< speed over the floor, frequency of the steps, mean frequency of each curve
  dynamics,  ///< ranges, velocities, accelerations and smoothness
};

inline constexpr int feature_family_count = 3;

/// "shape", "timing", "dynamics".
std::string_view id_of(FeatureFamily family);

/// A feature of a motion of any action.
struct ExpressiveFeature {
  std::string id;  ///< "mean-trunk-forward"
  FeatureFamily family;
};

/// All features in their fixed order.
std::span<const ExpressiveFeature> expressive_features();

/// Measures a whole motion, walk or gesture, for predicting how people rate it. Unlike
/// `measure_features` it needs no gait cycle and no straight walk: starts, stops and turns count,
/// because raters see them too.
///
/// The motion is sampled at 30 Hz and low-pass filtered at 6 Hz; a loop is repeated for at least
/// 4 s. Directions are those of the body in each frame: left is the horizontal part of the line
/// through hips and shoulders, low-pass filtered at 0.5 Hz (the mean for clips below 2 s). Hands
/// are the tips of stretched hands (hand_tip.h). Curves of limbs are measured on both sides and
/// averaged, so a motion and its mirror image have the same values. For each curve
/// - mean (shape; not for curves that change sign under mirroring),
/// - deviation: standard deviation,
/// - velocity: log of the root mean square of the derivative,
/// - frequency: log of the mean frequency, (root mean square of the second derivative) / (of the
///   first) / 2π, in Hz.
/// Lengths are fractions of the standing height of the body, angles radians; rates per second.
/// Logs are natural, with at least 1e-4 as argument, so that they are finite for a body at rest.
///
/// The values are invariant to rotation about the vertical, translation on the floor, mirroring and
/// the size of the body. Throws Error naming the clip if it has fewer than 8 samples at 30 Hz or is
/// not of the canonical body.
std::vector<double> measure_expression(const Clip& clip);

}  // namespace mien::motion
