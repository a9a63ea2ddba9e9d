#include "motion/measures/features/motion_features.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "motion/gait/contact.h"
#include "motion/gait/gait.h"
#include "motion/math/filter.h"
#include "motion/skeleton/straighten.h"

namespace mien::motion {

namespace {

/// An angle of a segment over a cycle, forward and sideways, radians, without jumps at ±180°.
/// Frames at which an angle is undefined are omitted, so the two may differ in length.
struct SegmentAngles {
  std::vector<double> forward;
  std::vector<double> sideways;
};

/// The curves that motion features are statistics of (measure_features), 30 times a second.
/// Index 0 of the pairs is the left side.
struct FeatureCurves {
  SegmentAngles torso, head;
  std::array<SegmentAngles, 2> upper_arm, forearm, thigh, shin, foot;
  std::vector<double> mass_left, mass_height;                        ///< metres
  std::vector<double> velocity_forward, velocity_left, velocity_up;  ///< m/s
};

constexpr double samples_per_second = 30.0;

/// Forward, its left, and up.
struct Directions {
  Vec3 forward, left, up;
};

Directions directions_of(const Vec3& forward) {
  return {forward, Vec3::UnitY().cross(forward), Vec3::UnitY()};
}

/// The direction of travel; its opposite for someone who walks backwards, whose body faces more
/// than 120° away from it.
Vec3 front_of(const Clip& clip) {
  const Vec3 travel = mean_direction(clip);
  Vec3 facing = Vec3::Zero();
  for (const Pose& pose : clip.poses) facing += pose.rotations[Pelvis] * Vec3::UnitZ();
  return facing.dot(travel) < -0.5 * facing.norm() ? Vec3(-travel) : travel;
}

/// One cycle, evenly sampled.
struct Samples {
  std::vector<JointTransforms> poses;
  double per_second = samples_per_second;
};

Samples sampled(const Clip& clip) {
  const double duration = clip.duration_seconds();
  const int steps = std::max(2, static_cast<int>(std::lround(duration * samples_per_second)));
  const int count = clip.loops ? steps : steps + 1;
  Samples samples;
  samples.per_second = steps / duration;
  for (int k = 0; k < count; ++k) {
    samples.poses.push_back(world_transforms(clip.body, pose_at(clip, k * duration / steps)));
  }
  return samples;
}

/// The curve turned by whole circles so that its mean is within 180° of `middle`: the branch must
/// not depend on the frame with which a curve begins.
void turn_to(double middle, std::vector<double>& curve) {
  if (curve.empty()) return;
  const double mean = std::accumulate(curve.begin(), curve.end(), 0.0) / curve.size();
  const double turns = 2.0 * pi * std::round((middle - mean) / (2.0 * pi));
  for (double& angle : curve) angle += turns;
}

double next_to(double previous, double angle) {
  return angle + 2.0 * pi * std::round((previous - angle) / (2.0 * pi));
}

void append(std::vector<double>& curve, double angle) {
  curve.push_back(curve.empty() ? angle : next_to(curve.back(), angle));
}

enum class Pointing { up, down };

/// Sine of 10°: the smallest angle between a segment and the axis of an angle that it determines.
constexpr double least_in_plane = 0.17;

/// Whether a segment determines the angle in a plane in which it has the components x and y: not if
/// it is nearly perpendicular to the plane, where noise would turn it at will.
bool determines_angle(double x, double y, const Vec3& segment) {
  return std::hypot(x, y) > least_in_plane * segment.norm();
}

void append_segment(SegmentAngles& angles, const Vec3& segment, const Directions& to,
                    Pointing pointing) {
  const double along = pointing == Pointing::up ? segment.dot(to.up) : -segment.dot(to.up);
  const double forward = segment.dot(to.forward);
  const double left = segment.dot(to.left);
  if (determines_angle(forward, along, segment)) append(angles.forward, std::atan2(forward, along));
  if (determines_angle(left, along, segment)) append(angles.sideways, std::atan2(left, along));
}

/// `sole` is the unit vector along the sole towards the toes.
void append_foot(SegmentAngles& angles, const Vec3& sole, const Directions& to) {
  const double forward = sole.dot(to.forward);
  const double left = sole.dot(to.left);
  const double up = sole.dot(to.up);
  if (determines_angle(forward, up, sole)) append(angles.forward, std::atan2(up, forward));
  if (forward > least_in_plane) append(angles.sideways, std::atan2(left, forward));
}

/// The way from ankle to toes as it lies when standing, turned with the ankle.
Vec3 sole_of(const Skeleton& body, const JointTransforms& pose, BodyJoint ankle) {
  const Vec3& foot = body.joints[ankle + 1].offset;
  return pose.rotations[ankle] * Vec3(foot.x(), 0.0, foot.z()).normalized();
}

void append_limbs(FeatureCurves& curves, size_t side, const Skeleton& body,
                  const JointTransforms& pose, const Directions& to) {
  const auto on_side = [side](BodyJoint joint) { return side == 0 ? joint : mirrored(joint); };
  const auto segment = [&](BodyJoint from, BodyJoint end) -> Vec3 {
    return pose.positions[on_side(end)] - pose.positions[on_side(from)];
  };
  const Pointing down = Pointing::down;
  append_segment(curves.upper_arm[side], segment(LeftShoulder, LeftElbow), to, down);
  append_segment(curves.forearm[side], segment(LeftElbow, LeftWrist), to, down);
  append_segment(curves.thigh[side], segment(LeftHip, LeftKnee), to, down);
  append_segment(curves.shin[side], segment(LeftKnee, LeftAnkle), to, down);
  append_foot(curves.foot[side], sole_of(body, pose, on_side(LeftAnkle)), to);
}

/// Neck to vertex; to the head joint on a body without one.
Vec3 head_of(const Skeleton& body, const JointTransforms& pose) {
  const Vec3 beyond = body.joints[Head].tip.value_or(Vec3::Zero());
  return pose.positions[Head] + pose.rotations[Head] * beyond - pose.positions[Neck];
}

/// Velocity of the body relative to the floor: continuous over the seam of a loop; for a walk in
/// place the floor's velocity is subtracted.
std::vector<Vec3> velocities(const Clip& clip, std::vector<Vec3> path, double per_second) {
  if (!clip.loops) return derivative(path, per_second);
  const auto count = static_cast<double>(path.size());
  for (size_t k = 0; k < path.size(); ++k) {
    path[k] -= clip.cycle_displacement * (static_cast<double>(k) / count);
  }
  const Vec3 mean = clip.cycle_displacement * (per_second / count) - floor_velocity(clip);
  std::vector<Vec3> result = derivative(path, per_second, SignalEnds::periodic);
  for (Vec3& velocity : result) velocity += mean;
  return result;
}

void add_mass_curves(FeatureCurves& curves, const Clip& clip, const Samples& samples,
                     const Directions& to, MassModel masses) {
  std::vector<Vec3> path;
  for (const JointTransforms& pose : samples.poses) {
    path.push_back(centre_of_mass(clip.body, pose, masses));
  }
  for (const Vec3& place : path) {
    curves.mass_left.push_back(place.dot(to.left));
    curves.mass_height.push_back(place.dot(to.up));
  }
  for (const Vec3& velocity : velocities(clip, path, samples.per_second)) {
    curves.velocity_forward.push_back(velocity.dot(to.forward));
    curves.velocity_left.push_back(velocity.dot(to.left));
    curves.velocity_up.push_back(velocity.dot(to.up));
  }
}

void turn_outward(FeatureCurves& curves) {
  for (auto* limb :
       {&curves.upper_arm, &curves.forearm, &curves.thigh, &curves.shin, &curves.foot}) {
    for (double& angle : (*limb)[1].sideways) angle = -angle;
  }
}

/// Angles of arms around 90°, forward and outward, since a raised arm is at 180°; others around 0.
void settle_circles(FeatureCurves& curves) {
  for (SegmentAngles* trunk : {&curves.torso, &curves.head}) {
    turn_to(0.0, trunk->forward);
    turn_to(0.0, trunk->sideways);
  }
  for (const size_t side : {0u, 1u}) {
    for (SegmentAngles* arm : {&curves.upper_arm[side], &curves.forearm[side]}) {
      turn_to(0.5 * pi, arm->forward);
      turn_to(side == 0 ? 0.5 * pi : -0.5 * pi, arm->sideways);
    }
    for (SegmentAngles* leg : {&curves.thigh[side], &curves.shin[side], &curves.foot[side]}) {
      turn_to(0.0, leg->forward);
      turn_to(0.0, leg->sideways);
    }
  }
}

FeatureCurves feature_curves(const Example& example, const FeatureOptions& options) {
  const Clip& clip = example.clip;
  const Directions to = directions_of(front_of(clip));
  const Samples samples = sampled(clip);
  FeatureCurves curves;
  for (const JointTransforms& pose : samples.poses) {
    append_segment(curves.torso, pose.positions[Neck] - pose.positions[Pelvis], to, Pointing::up);
    append_segment(curves.head, head_of(clip.body, pose), to, Pointing::up);
    for (const size_t side : {0u, 1u}) append_limbs(curves, side, clip.body, pose, to);
  }
  settle_circles(curves);
  if (options.outward) turn_outward(curves);
  add_mass_curves(curves, clip, samples, directions_of(mean_direction(clip)), options.masses);
  return curves;
}

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
