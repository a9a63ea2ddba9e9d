#include "motion/biomechanics/body_dynamics.h"

#include "motion/biomechanics/body_mass.h"
#include "motion/math/filter.h"
#include "motion/math/rotation.h"

namespace mien::motion {

const std::array<int, segment_count> segment_joints = {
    Head,      Chest,         LeftShoulder, LeftElbow,  LeftWrist, LeftHip,   LeftKnee,
    LeftAnkle, RightShoulder, RightElbow,   RightWrist, RightHip,  RightKnee, RightAnkle};

namespace {

/// Radii of gyration about a crosswise axis and about the segment's own, shares of its length
/// (de Leva 1996, table 4, men, rounded).
struct Gyration {
  double across;
  double along;
};

constexpr Gyration head_gyration = {0.31, 0.26};
constexpr Gyration trunk_gyration = {0.32, 0.17};
constexpr Gyration upper_arm_gyration = {0.28, 0.16};
constexpr Gyration forearm_gyration = {0.27, 0.12};
constexpr Gyration hand_gyration = {0.57, 0.40};
constexpr Gyration thigh_gyration = {0.33, 0.15};
constexpr Gyration shank_gyration = {0.25, 0.10};
constexpr Gyration foot_gyration = {0.25, 0.12};

constexpr std::array<Gyration, segment_count> gyrations = {
    head_gyration,  trunk_gyration, upper_arm_gyration, forearm_gyration,   hand_gyration,
    thigh_gyration, shank_gyration, foot_gyration,      upper_arm_gyration, forearm_gyration,
    hand_gyration,  thigh_gyration, shank_gyration,     foot_gyration};

/// Length and direction at rest of the axis of each segment, in its joint's frame.
std::array<Vec3, segment_count> axes(const Skeleton& body) {
  const auto offset = [&](BodyJoint joint) { return body.joints[joint].offset; };
  const auto tip = [&](BodyJoint joint) {
    return body.joints[joint].tip.value_or(0.1 * rest_direction(joint));
  };
  const Vec3 head = offset(Head) + tip(Head);
  const Vec3 trunk = offset(Spine) + offset(Chest) + offset(Neck) - offset(LeftHip);
  std::array<Vec3, segment_count> result = {head, Vec3(0, trunk.y(), 0)};
  for (const bool left : {true, false}) {
    const auto on_side = [left](BodyJoint joint) { return left ? joint : mirrored(joint); };
    const size_t first = left ? 2 : 8;
    result[first] = offset(on_side(LeftElbow));
    result[first + 1] = offset(on_side(LeftWrist));
    result[first + 2] = 0.5 * tip(on_side(LeftWrist));
    result[first + 3] = offset(on_side(LeftKnee));
    result[first + 4] = offset(on_side(LeftAnkle));
    result[first + 5] = offset(on_side(LeftToe)) + tip(on_side(LeftToe));
  }
  return result;
}

/// The clip without what moves faster than 6 Hz.
Clip smoothed(const Clip& clip) {
  const double rate = clip.frames_per_second;
  const double cutoff = gait_cutoff_hz(rate);
  Clip result = clip;
  std::vector<Vec3> root;
  for (const Pose& pose : clip.poses) root.push_back(pose.root_position);
  root = low_pass(root, cutoff, rate);
  for (size_t t = 0; t < root.size(); ++t) result.poses[t].root_position = root[t];
  for (size_t j = 0; j < clip.body.joints.size(); ++j) {
    std::array<std::vector<double>, 4> parts;
    Quat before = clip.poses.front().rotations[j];
    for (const Pose& pose : clip.poses) {
      before = in_hemisphere_of(before, pose.rotations[j]);
      for (int i = 0; i < 4; ++i) parts[i].push_back(before.coeffs()[i]);
    }
    for (std::vector<double>& part : parts) part = low_pass(part, cutoff, rate);
    for (size_t t = 0; t < root.size(); ++t) {
      const Quat smooth(parts[3][t], parts[0][t], parts[1][t], parts[2][t]);
      if (smooth.norm() > 0.1) result.poses[t].rotations[j] = smooth.normalized();
    }
  }
  return result;
}

/// Angular velocities, rad/s, world space.
std::vector<Vec3> angular_velocity(const std::vector<BodyDynamics>& body, int joint, double rate) {
  const int count = static_cast<int>(body.size());
  std::vector<Vec3> result;
  for (int t = 0; t < count; ++t) {
    const int before = std::max(t - 1, 0);
    const int after = std::min(t + 1, count - 1);
    const Quat turn =
        body[after].world.rotations[joint] * body[before].world.rotations[joint].conjugate();
    result.push_back(log(turn) * (rate / std::max(after - before, 1)));
  }
  return result;
}

void add_segment(std::vector<BodyDynamics>& body, int segment, const Vec3& axis, double rate) {
  std::vector<Vec3> path;
  for (const BodyDynamics& moment : body) path.push_back(moment.centre[segment]);
  const std::vector<Vec3> acceleration = derivative(derivative(path, rate), rate);
  const int joint = segment_joints[segment];
  const Gyration& gyration = gyrations[segment];
  const double length = axis.norm();
  const double across = std::pow(gyration.across * length, 2);
  const double along = std::pow(gyration.along * length, 2);
  const std::vector<Vec3> turning = angular_velocity(body, joint, rate);
  std::vector<Vec3> momentum;
  for (size_t t = 0; t < body.size(); ++t) {
    const Vec3 direction = body[t].world.rotations[joint] * axis.normalized();
    const Vec3 spin = direction * direction.dot(turning[t]);
    momentum.push_back(body[t].mass[segment] * (across * (turning[t] - spin) + along * spin));
  }
  const std::vector<Vec3> rate_of_momentum = derivative(momentum, rate);
  for (size_t t = 0; t < body.size(); ++t) {
    body[t].acceleration[segment] = acceleration[t];
    body[t].momentum_rate[segment] = rate_of_momentum[t];
  }
}

void add_floor(BodyDynamics& moment) {
  const Vec3 up = Vec3::UnitY();
  Vec3 moment_about_origin = Vec3::Zero();
  for (int s = 0; s < segment_count; ++s) {
    const Vec3 force = moment.mass[s] * (moment.acceleration[s] + gravity * up);
    moment.ground_reaction += force;
    moment_about_origin += moment.centre[s].cross(force) + moment.momentum_rate[s];
  }
  const double press = moment.ground_reaction.y();
  moment.zero_moment_point = Vec3(moment.centre_of_mass.x(), 0, moment.centre_of_mass.z());
  if (press < 0.1 * gravity) return;
  // M = p × F with p on the floor: M.x = −p.z·F.y, M.z = p.x·F.y.
  moment.zero_moment_point =
      Vec3(moment_about_origin.z() / press, 0, -moment_about_origin.x() / press);
}

void add_centre_of_mass(std::vector<BodyDynamics>& body, double rate) {
  std::vector<Vec3> path;
  for (BodyDynamics& moment : body) {
    double mass = 0.0;
    for (int s = 0; s < segment_count; ++s) {
      moment.centre_of_mass += moment.mass[s] * moment.centre[s];
      mass += moment.mass[s];
    }
    moment.centre_of_mass /= mass;
    path.push_back(moment.centre_of_mass);
  }
  const std::vector<Vec3> velocity = derivative(path, rate);
  for (size_t t = 0; t < body.size(); ++t) body[t].velocity = velocity[t];
}

}  // namespace

std::vector<BodyDynamics> body_dynamics(const LintMotion& motion) {
  const Clip clip = smoothed(motion.clip);
  std::vector<BodyDynamics> body(clip.poses.size());
  for (size_t t = 0; t < body.size(); ++t) {
    body[t].world = world_transforms(clip.body, clip.poses[t]);
    const std::vector<SegmentMass> segments = segment_masses(clip.body, body[t].world);
    for (int s = 0; s < segment_count; ++s) {
      body[t].mass[s] = segments[s].share;
      body[t].centre[s] = segments[s].centre;
    }
  }
  add_centre_of_mass(body, motion.rate());
  const std::array<Vec3, segment_count> axis = axes(clip.body);
  for (int s = 0; s < segment_count; ++s) add_segment(body, s, axis[s], motion.rate());
  for (BodyDynamics& moment : body) add_floor(moment);
  return body;
}

}  // namespace mien::motion
