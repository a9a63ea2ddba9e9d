#include "motion/biomechanics/inverse_dynamics.h"

namespace mien::motion {

namespace {

constexpr double upper_trunk_share = 0.743;  // of the trunk's mass, above the lower spine (de Leva)

/// The floor's force on one foot.
struct FootForce {
  Vec3 force = Vec3::Zero();  // N/kg of body
  Vec3 point = Vec3::Zero();
};

struct FeetForces {
  FootForce left;
  FootForce right;
};

FeetForces feet_forces(const BodyDynamics& moment, const Support& support) {
  FeetForces feet;
  const Vec3& zmp = moment.zero_moment_point;
  if (!support.left.empty()) feet.left.point = nearest_in_hull(zmp, support.left);
  if (!support.right.empty()) feet.right.point = nearest_in_hull(zmp, support.right);
  const double from_left = (zmp - feet.left.point).norm();
  const double from_right = (zmp - feet.right.point).norm();
  double left_share = support.left.empty() ? 0.0 : 1.0;
  if (!support.left.empty() && !support.right.empty()) {
    const double both = from_left + from_right;
    left_share = both > 1e-6 ? from_right / both : 0.5;
  }
  feet.left.force = left_share * moment.ground_reaction;
  if (!support.right.empty()) feet.right.force = (1.0 - left_share) * moment.ground_reaction;
  return feet;
}

/// Net moment about a point that moves the segments from `first` to `last`, N·m/kg.
Vec3 needed(const BodyDynamics& moment, const Vec3& about, int first, int last) {
  Vec3 torque = Vec3::Zero();
  for (int s = first; s <= last; ++s) {
    const Vec3 force = moment.mass[s] * (moment.acceleration[s] + gravity * Vec3::UnitY());
    torque += (moment.centre[s] - about).cross(force) + moment.momentum_rate[s];
  }
  return torque;
}

Vec3 trunk_torque(const BodyDynamics& moment) {
  const Vec3& spine = moment.world.positions[Spine];
  const Vec3 upper = spine + 0.5 * (moment.world.positions[Neck] - spine);
  const Vec3 force =
      upper_trunk_share * moment.mass[1] * (moment.acceleration[1] + gravity * Vec3::UnitY());
  return needed(moment, spine, 0, 0) + (upper - spine).cross(force) +
         upper_trunk_share * moment.momentum_rate[1] + needed(moment, spine, 2, 4) +
         needed(moment, spine, 8, 10);
}

}  // namespace

const std::vector<TorqueJoint>& torque_joints() {
  static const std::vector<TorqueJoint> joints = {
      {Spine, 300},    {LeftShoulder, 90}, {LeftElbow, 80},     {LeftHip, 250},
      {LeftKnee, 250}, {LeftAnkle, 170},   {RightShoulder, 90}, {RightElbow, 80},
      {RightHip, 250}, {RightKnee, 250},   {RightAnkle, 170},
  };
  return joints;
}

std::vector<double> joint_torques(const BodyDynamics& moment, const Support& support) {
  const FeetForces feet = feet_forces(moment, support);
  const auto& at = moment.world.positions;
  std::vector<double> torques = {trunk_torque(moment).norm()};
  for (const bool left : {true, false}) {
    const auto place = [&](BodyJoint joint) { return at[left ? joint : mirrored(joint)]; };
    const int arm = left ? 2 : 8;
    const FootForce& foot = left ? feet.left : feet.right;
    const auto leg_torque = [&](BodyJoint joint, int first) {
      const Vec3 about = place(joint);
      const Vec3 floor = (foot.point - about).cross(foot.force);
      return (needed(moment, about, first, arm + 5) - floor).norm();
    };
    torques.push_back(needed(moment, place(LeftShoulder), arm, arm + 2).norm());
    torques.push_back(needed(moment, place(LeftElbow), arm + 1, arm + 2).norm());
    torques.push_back(leg_torque(LeftHip, arm + 3));
    torques.push_back(leg_torque(LeftKnee, arm + 4));
    torques.push_back(leg_torque(LeftAnkle, arm + 5));
  }
  return torques;
}

}  // namespace mien::motion
