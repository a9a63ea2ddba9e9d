#pragma once

#include <string>
#include <vector>

namespace mien::motion {

/// The weight of one facial expression over time.
struct FaceCurve {
  enum class Interpolation { step, linear, cubic_spline };

  std::string name;  ///< of the expression or morph target
  Interpolation interpolation = Interpolation::linear;
  std::vector<double> times;  ///< seconds, increasing; at least one
  /// A number for each time; for cubic splines three: in-tangent, value, out-tangent.
  std::vector<double> values;
};

/// The weights of a face over time; of several curves of one name the first counts.
using FaceTrack = std::vector<FaceCurve>;

/// The weight at a time; before the first time and after the last one, that of the nearest (glTF
/// 2.0, appendix C).
double weight_at(const FaceCurve& curve, double seconds);

}  // namespace mien::motion
