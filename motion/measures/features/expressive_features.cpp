#include "motion/measures/features/expressive_features.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "motion/math/filter.h"
#include "motion/math/percentile.h"
#include "motion/measures/features/movement.h"

namespace mien::motion {

namespace {

/// Parts whose accelerations are measured; of limbs, both sides. The tips of hands (LeftWrist
/// stands for them), since it is they that gestures are made with.
constexpr std::array<std::pair<std::string_view, BodyJoint>, 4> moving_joints = {
    {{"hand", LeftWrist}, {"head", Head}, {"ankle", LeftAnkle}, {"pelvis", Pelvis}}};

std::vector<ExpressiveFeature> listed_features() {
  using enum FeatureFamily;
  std::vector<ExpressiveFeature> list;
  for (const MovementCurveName& curve : movement_curves) {
    const std::string id(curve.id);
    if (!curve.changes_sign) list.push_back({"mean-" + id, shape});
    list.push_back({"deviation-" + id, dynamics});
    list.push_back({"velocity-" + id, dynamics});
    list.push_back({"frequency-" + id, timing});
  }
  for (const auto& joint : moving_joints) {
    list.push_back({"acceleration-" + std::string(joint.first), dynamics});
    list.push_back({"roughness-" + std::string(joint.first), dynamics});
  }
  for (const char* id : {"mean-width", "mean-depth", "mean-head-height", "unevenness-hands"})
    list.push_back({id, shape});
  for (const char* id : {"deviation-width", "deviation-depth", "step-length"})
    list.push_back({id, dynamics});
  for (const char* id : {"speed", "stride-frequency", "turning"}) list.push_back({id, timing});
  return list;
}

double mean_of_curve(const Curve& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double deviation_of_curve(const Curve& values) {
  const double middle = mean_of_curve(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - middle) * (value - middle);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double root_mean_square(const Path& path) {
  double sum = 0.0;
  for (const Vec3& at : path) sum += at.squaredNorm();
  return std::sqrt(sum / static_cast<double>(path.size()));
}

double safe_log(double value) { return std::log(std::max(value, 1e-4)); }

Path rate_of(const Path& path) { return derivative(path, movement_samples_per_second); }

/// The curve as a path along x, for derivatives.
Path as_path(const Curve& curve) {
  Path path;
  for (const double value : curve) path.emplace_back(value, 0.0, 0.0);
  return path;
}

/// Mean over the sides.
double over(const std::vector<Curve>& sides, double (*measure)(const Curve&)) {
  double sum = 0.0;
  for (const Curve& curve : sides) sum += measure(curve);
  return sum / static_cast<double>(sides.size());
}

double velocity(const Curve& curve) { return root_mean_square(rate_of(as_path(curve))); }

double frequency(const Curve& curve) {
  const Path rate = rate_of(as_path(curve));
  return root_mean_square(rate_of(rate)) / std::max(root_mean_square(rate), 1e-9) / (2.0 * pi);
}

void add_curves(std::vector<double>& values, const Movement& m) {
  for (int curve = 0; curve < movement_curve_count; ++curve) {
    const std::vector<Curve> sides = curves_of(m, MovementCurve(curve));
    if (!movement_curves[static_cast<std::size_t>(curve)].changes_sign)
      values.push_back(over(sides, mean_of_curve));
    values.push_back(over(sides, deviation_of_curve));
    values.push_back(safe_log(over(sides, velocity)));
    values.push_back(safe_log(over(sides, frequency)));
  }
}

const Path& path_of(const Movement& m, BodyJoint joint) {
  if (joint == LeftWrist) return m.left_hand;
  return joint == RightWrist ? m.right_hand : m.joints[joint];
}

/// Accelerations of joints relative to the pelvis, of the pelvis in space; and how much jerk comes
/// with them, log(jerk / acceleration).
void add_accelerations(std::vector<double>& values, const Movement& m) {
  for (const auto& [id, joint] : moving_joints) {
    double acceleration = 0.0;
    double jerk = 0.0;
    for (const BodyJoint side : {joint, mirrored(joint)}) {
      const Path& moving = path_of(m, side);
      Path path;
      for (std::size_t f = 0; f < m.count(); ++f)
        path.push_back(side == Pelvis ? moving[f] : moving[f] - m.joints[Pelvis][f]);
      const Path second = rate_of(rate_of(path));
      acceleration += 0.5 * root_mean_square(second);
      jerk += 0.5 * root_mean_square(rate_of(second));
    }
    values.push_back(safe_log(acceleration));
    values.push_back(safe_log(jerk) - safe_log(acceleration));
  }
}

/// Extent of the body along its own direction: 0 forward, 2 left.
Curve extents(const Movement& m, int axis) {
  Curve result;
  for (std::size_t f = 0; f < m.count(); ++f) {
    double least = 0.0;
    double most = 0.0;
    for (int j = 0; j < body_joint_count; ++j) {
      const double at = m.own(m.between(Pelvis, BodyJoint(j), f), f)[axis];
      least = std::min(least, at);
      most = std::max(most, at);
    }
    result.push_back(most - least);
  }
  return result;
}

Curve ankle_separation(const Movement& m) {
  Curve result;
  for (std::size_t f = 0; f < m.count(); ++f)
    result.push_back(m.between(RightAnkle, LeftAnkle, f).dot(m.forward[f]));
  return result;
}

/// Frequency of the largest amplitude between 0.3 and 2.5 Hz, under a Hann window.
double main_frequency(const Curve& curve) {
  const double middle = mean_of_curve(curve);
  const auto count = static_cast<double>(curve.size());
  double largest = -1.0;
  double found = 0.0;
  for (double hertz = 0.3; hertz <= 2.5; hertz += 0.02) {
    double real = 0.0;
    double imaginary = 0.0;
    for (std::size_t f = 0; f < curve.size(); ++f) {
      const auto at = static_cast<double>(f);
      const double window = 0.5 - 0.5 * std::cos(2.0 * pi * (at + 0.5) / count);
      const double phase = 2.0 * pi * hertz * at / movement_samples_per_second;
      real += window * (curve[f] - middle) * std::cos(phase);
      imaginary += window * (curve[f] - middle) * std::sin(phase);
    }
    const double power = real * real + imaginary * imaginary;
    if (power > largest * (1.0 + 1e-9) + 1e-18) {
      largest = power;
      found = hertz;
    }
  }
  return found;
}

double mean_hand_difference(const Movement& m) {
  double sum = 0.0;
  for (const MovementCurve curve : {HandForward, HandUp, HandOut}) {
    const std::vector<Curve> sides = curves_of(m, curve);
    sum += std::abs(mean_of_curve(sides[0]) - mean_of_curve(sides[1]));
  }
  return sum;
}

double speed(const Movement& m) {
  double sum = 0.0;
  for (const Vec3& v : rate_of(m.joints[Pelvis])) sum += horizontal(v).norm();
  return sum / static_cast<double>(m.count());
}

/// Standard deviation of the rate at which the heading turns, rad/s.
double turning(const Movement& m) {
  Curve heading;
  for (const Vec3& forward : m.forward) heading.push_back(std::atan2(forward.x(), forward.z()));
  unwrap(heading);
  Curve rate;
  for (const Vec3& v : rate_of(as_path(heading))) rate.push_back(v.x());
  return deviation_of_curve(rate);
}

void add_whole_body(std::vector<double>& values, const Movement& m) {
  const Curve width = extents(m, 2);
  const Curve depth = extents(m, 0);
  Curve head;
  for (const Vec3& at : m.joints[Head]) head.push_back(at.y());
  Curve steps = ankle_separation(m);
  const double stride_frequency = main_frequency(steps);
  for (double& step : steps) step = std::abs(step);
  for (const double value :
       {mean_of_curve(width), mean_of_curve(depth), mean_of_curve(head), mean_hand_difference(m),
        deviation_of_curve(width), deviation_of_curve(depth), percentile(steps, 90.0), speed(m),
        stride_frequency, turning(m)})
    values.push_back(value);
}

}  // namespace

std::string_view id_of(FeatureFamily family) {
  constexpr std::array<std::string_view, feature_family_count> ids = {"shape", "timing",
                                                                      "dynamics"};
  return ids[static_cast<std::size_t>(family)];
}

std::span<const ExpressiveFeature> expressive_features() {
  static const std::vector<ExpressiveFeature> list = listed_features();
  return list;
}

std::vector<double> measure_expression(const Clip& clip) {
  const Movement m = sampled_movement(clip);
  std::vector<double> values;
  add_curves(values, m);
  add_accelerations(values, m);
  add_whole_body(values, m);
  return values;
}

}  // namespace mien::motion
