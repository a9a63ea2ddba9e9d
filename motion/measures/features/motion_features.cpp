#include "motion/measures/features/motion_features.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include "motion/gait/gait.h"
#include "motion/measures/features/feature_curves.h"
#include "motion/skeleton/straighten.h"

namespace mien::motion {

namespace {

/// NaN without values.
double mean(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double deviation(std::span<const double> values) {
  const double middle = mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - middle) * (value - middle);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double in_degrees(double radians) { return radians / radians_per_degree; }

/// Puts values at the features' ids, so that none can stand in another's place.
class FeatureSheet {
 public:
  FeatureSheet() { values_.fill(std::numeric_limits<double>::quiet_NaN()); }

  void set(const std::string& id, double value) {
    const int index = find_motion_feature(id);
    assert(index >= 0);
    values_[static_cast<size_t>(index)] = value;
  }
  /// Mean and swing of an angle, radians.
  void set_angle(const std::string& what, std::span<const double> curve) {
    set("mu-" + what, in_degrees(mean(curve)));
    set("sigma-" + what, in_degrees(deviation(curve)));
  }

  const FeatureValues& values() const { return values_; }

 private:
  FeatureValues values_;
};

void set_angles(FeatureSheet& sheet, const FeatureCurves& curves) {
  sheet.set_angle("torso-fb", curves.torso.forward);
  sheet.set_angle("torso-lr", curves.torso.sideways);
  sheet.set_angle("head-fb", curves.head.forward);
  sheet.set_angle("head-lr", curves.head.sideways);
  for (const size_t side : {0u, 1u}) {
    const std::string name = side == 0 ? "left-" : "right-";
    sheet.set_angle(name + "upper-arm-fb", curves.upper_arm[side].forward);
    sheet.set_angle(name + "upper-arm-lr", curves.upper_arm[side].sideways);
    sheet.set_angle(name + "forearm-fb", curves.forearm[side].forward);
    sheet.set_angle(name + "thigh-fb", curves.thigh[side].forward);
    sheet.set_angle(name + "thigh-lr", curves.thigh[side].sideways);
    sheet.set_angle(name + "shin-fb", curves.shin[side].forward);
    sheet.set_angle(name + "foot-fb", curves.foot[side].forward);
    sheet.set_angle(name + "foot-lr", curves.foot[side].sideways);
  }
}

void set_mass(FeatureSheet& sheet, const FeatureCurves& curves) {
  sheet.set("sigma-com-pos-lr", deviation(curves.mass_left));
  sheet.set("sigma-com-vel-lr", deviation(curves.velocity_left));
  sheet.set("mu-com-vel-lr", mean(curves.velocity_left));
  sheet.set("mu-com-pos-v", mean(curves.mass_height));
  sheet.set("sigma-com-pos-v", deviation(curves.mass_height));
  sheet.set("sigma-com-vel-v", deviation(curves.velocity_up));
  sheet.set("mu-com-vel-fb", mean(curves.velocity_forward));
  sheet.set("sigma-com-vel-fb", deviation(curves.velocity_forward));
}

bool has_steps(const Example& example) {
  return example.clip.loops && example.keytimes.size() == gait_keytime_count;
}

void set_steps(FeatureSheet& sheet, const Example& example) {
  if (!has_steps(example)) return;
  constexpr size_t right_strike = 3;
  const Vec3 forward = mean_direction(example.clip);
  const Vec3 left = Vec3::UnitY().cross(forward);
  double length = 0.0;
  double width = 0.0;
  for (const double strike : {example.keytimes[0], example.keytimes[right_strike]}) {
    const auto at = world_positions(example.clip.body, pose_at(example.clip, strike));
    const Vec3 apart = at[LeftAnkle] - at[RightAnkle];
    length += 0.5 * std::abs(apart.dot(forward));
    width += 0.5 * std::abs(apart.dot(left));
  }
  sheet.set("step-length-fb", length);
  sheet.set("step-length-lr", width);
}

}  // namespace

FeatureValues measure_features(const Example& example, const FeatureOptions& options) {
  assert(example.clip.frame_count() >= 2);
  const FeatureCurves curves = feature_curves(example, options);
  FeatureSheet sheet;
  set_angles(sheet, curves);
  set_mass(sheet, curves);
  set_steps(sheet, example);
  sheet.set("duration", example.clip.duration_seconds());
  return sheet.values();
}

}  // namespace mien::motion
