#include <array>
#include <cmath>

#include "motion/formats/bvh/bvh.h"
#include "motion/formats/bvh/bvh_rotation.h"
#include "motion/formats/reading/frame_rate.h"

namespace mien::motion {

namespace {

constexpr double power_of_ten(int exponent) {
  double power = 1.0;
  for (int i = 0; i < exponent; ++i) power *= 10.0;
  return power;
}

/// The number that a value is read as once it is written with so many decimals: what is nearest in
/// decimals, of two the even one, as double. `value` · 10^decimals must be below 2^52.
double as_written(double value, int decimals) {
  const double scale = power_of_ten(decimals);
  const double product = value * scale;
  const double lost = std::fma(value, scale, -product);  // product + lost is exact
  double whole = std::nearbyint(product);
  const double rest = product - whole;  // exact
  if (rest == 0.5 && lost > 0.0) {
    whole = product + 0.5;
  } else if (rest == -0.5 && lost < 0.0) {
    whole = product - 0.5;
  } else if (rest == 0.5 && lost < 0.0) {
    whole = product - 0.5;
  } else if (rest == -0.5 && lost > 0.0) {
    whole = product + 0.5;
  }
  return whole == 0.0 ? 0.0 : whole / scale;
}

/// How many decimals a number has that is written with `most` of them, without zeros at the end.
int decimals_of(double written, int most) {
  while (most > 0 && as_written(written, most - 1) == written) --most;
  return most;
}

Vec3 as_written(const Vec3& vector, int decimals) {
  return {as_written(vector.x(), decimals), as_written(vector.y(), decimals),
          as_written(vector.z(), decimals)};
}

Quat as_written(const Vec3& angles) {
  constexpr std::array<Axis, 3> order = {Axis::z, Axis::x, Axis::y};
  Quat rotation = Quat::Identity();
  for (int i = 0; i < 3; ++i) {
    const double degrees = as_written(angles[i] / radians_per_degree, bvh_angle_decimals);
    rotation = turned(rotation, order[static_cast<size_t>(i)], degrees);
  }
  return rotation.normalized();
}

}  // namespace

Recording as_read_from_bvh(const Recording& recording) {
  Recording read;
  read.name = recording.name;
  read.format = "bvh";
  read.skeleton = recording.skeleton;
  for (Joint& joint : read.skeleton.joints) {
    joint.offset = as_written(joint.offset, bvh_position_decimals);
    if (joint.tip) *joint.tip = as_written(*joint.tip, bvh_position_decimals);
  }
  const double period = 1.0 / recording.frames_per_second;
  const double written = as_written(period, bvh_time_decimals);
  read.frames_per_second = frame_rate_of_period(written, decimals_of(written, bvh_time_decimals));
  std::vector<Vec3> angles(recording.skeleton.joints.size(), Vec3::Zero());
  for (const Pose& pose : recording.poses) {
    Pose& now = read.poses.emplace_back();
    now.root_position = as_written(pose.root_position, bvh_position_decimals);
    for (size_t j = 0; j < angles.size(); ++j) {
      angles[j] = bvh_angles(pose.rotations[j], angles[j]);
      now.rotations.push_back(as_written(angles[j]));
    }
  }
  return read;
}

}  // namespace mien::motion
