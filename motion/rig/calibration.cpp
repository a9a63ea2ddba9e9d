#include "motion/rig/calibration.h"

#include "motion/math/rotation.h"
#include "motion/rig/measured_calibration.h"
#include "motion/rig/proportions.h"
#include "motion/rig/rest_calibration.h"

namespace mien::motion {

namespace {

/// The zero pose's constants, with those joints measured instead that it has clearly wrong.
std::array<Quat, body_joint_count> rest_checked(const std::array<Quat, body_joint_count>& rest,
                                                const MeasuredCalibration& measured,
                                                ZeroPose zero_pose) {
  std::array<Quat, body_joint_count> constants = rest;
  for (int j = 0; j < body_joint_count; ++j) {
    // A sole on the floor is better evidence of the foot's orientation than an unposed figure.
    const bool is_foot = j == LeftAnkle || j == RightAnkle;
    if (zero_pose == ZeroPose::defined && !is_foot) continue;
    const double tolerance = (is_foot ? 12 : 25) * radians_per_degree;
    const bool wrong = angle_between(rest[j], measured.constants[j]) > tolerance;
    if (measured.has_evidence[j] && wrong) constants[j] = measured.constants[j];
  }
  return constants;
}

}  // namespace

Calibration calibrate(std::span<const RigMotion> motions, ZeroPose zero_pose) {
  if (zero_pose == ZeroPose::own) {
    Calibration calibration;
    calibration.to_body.fill(Quat::Identity());
    calibration.from_rest_pose = true;
    calibration.body = proportions(motions, calibration.to_body);
    return calibration;
  }
  const MeasuredCalibration measured = measured_calibration(motions);
  const auto rest = rest_calibration(motions.front());
  Calibration calibration;
  calibration.from_rest_pose = rest.has_value();
  calibration.to_body = rest ? rest_checked(*rest, measured, zero_pose) : measured.constants;
  calibration.body = proportions(motions, calibration.to_body);
  return calibration;
}

}  // namespace mien::motion
