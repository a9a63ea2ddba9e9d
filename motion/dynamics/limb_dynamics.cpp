#include "motion/dynamics/limb_dynamics.h"

#include <algorithm>
#include <cmath>

#include "motion/biomechanics/body_dynamics.h"
#include "motion/biomechanics/body_mass.h"
#include "motion/dynamics/suspended_part.h"
#include "motion/math/filter.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/joint_curve.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

namespace {

constexpr double least_stiffness = 0.01;  // of a spring
constexpr double posture_hz = 0.5;        // below which a posture is held
constexpr double nearest_arm = 0.15;  // sideways part of an upper arm that hangs beside the body
constexpr double least_bend = 0.03;   // radians, of an elbow that is nearly straight

/// Radii of gyration of head, trunk, upper arm, forearm and hand about their own centres, metres
/// at a stature of 1.75 m (de Leva 1996, rounded).
constexpr std::array<double, 5> own_radii = {0.08, 0.17, 0.08, 0.07, 0.04};

/// How a part of the body hangs on its joint.
struct Suspension {
  BodyJoint joint;
  BodyJoint end;              ///< the bone points there from the joint; the joint itself: its tip
  std::vector<int> segments;  ///< of segment_masses, that hang on the joint
  double hz;
  double largest;             ///< radians
  BodyJoint second = Pelvis;  ///< a joint that takes half of the deflection; Pelvis: none
  double before = 0.0;        ///< metres that the centre of mass lies before the bones
  bool hinges = false;
  bool beside_body = false;  ///< the trunk is in the way of the bone
};

Suspension trunk() { return {Spine, Neck, {0, 1, 2, 3, 4, 8, 9, 10}, trunk_hz, 0.45, Chest, 0.04}; }

Suspension head() { return {Neck, Head, {0}, head_hz, 0.6, Head, 0.02}; }

std::vector<Suspension> arm(bool left) {
  const auto side = [&](BodyJoint joint) { return left ? joint : mirrored(joint); };
  const int upper = left ? 2 : 8;
  return {{.joint = side(LeftShoulder),
           .end = side(LeftElbow),
           .segments = {upper, upper + 1, upper + 2},
           .hz = arm_hz,
           .largest = 1.6,
           .beside_body = true},
          {.joint = side(LeftElbow),
           .end = side(LeftWrist),
           .segments = {upper + 1, upper + 2},
           .hz = arm_hz,
           .largest = 2.0,
           .hinges = true},
          {side(LeftWrist), side(LeftWrist), {upper + 2}, arm_hz, 0.9}};
}

double radius_of(int segment) {
  return segment < 2 ? own_radii[static_cast<std::size_t>(segment)]
                     : own_radii[static_cast<std::size_t>(2 + (segment - 2) % 6)];
}

Vec3 rest_bone(const Skeleton& body, const Suspension& part) {
  if (part.end == part.joint)
    return body.joints[part.joint].tip.value_or(rest_direction(part.joint)).normalized();
  return Vec3::Zero();
}

/// Accelerations of a joint, m/s², without what is quicker than a gait.
std::vector<Vec3> accelerations(const Clip& clip, const std::vector<JointTransforms>& worlds,
                                BodyJoint joint) {
  const SignalEnds ends = clip.loops ? SignalEnds::periodic : SignalEnds::open;
  const double rate = clip.frames_per_second;
  std::vector<Vec3> path;
  for (std::size_t f = 0; f < worlds.size(); ++f) {
    const double share = static_cast<double>(f) / clip.frame_count();
    path.push_back(worlds[f].positions[joint] - share * clip.cycle_displacement);
  }
  path = low_pass(path, gait_cutoff_hz(rate), rate, ends);
  return derivative(derivative(path, rate, ends), rate, ends);
}

/// The axis about which an elbow bends, in the upper arm's frame: across its bone at rest and where
/// the forearm goes, on the average; of an arm that is always straight that of its anatomy.
Vec3 hinge_of(const Clip& clip, const Suspension& part) {
  const Vec3 rest = clip.body.joints[part.end].offset.normalized();
  Vec3 sum = Vec3::Zero();
  for (const Pose& pose : clip.poses) sum += rest.cross(pose.rotations[part.joint] * rest);
  if (sum.norm() > 0.02 * clip.frame_count()) return sum.normalized();
  return rest.cross(Vec3::UnitZ()).normalized();
}

/// What the springs and the ordinary muscles hold.
struct Fields {
  double carried = 1.0;  ///< share of weight and inertia that moves with the clip
  double weight = 1.0;
};

SuspendedPart suspended(const Clip& clip, const Suspension& part, const Fields& fields) {
  SuspendedPart result;
  result.largest = part.largest;
  if (part.hinges) result.hinge = hinge_of(clip, part);
  const BodyJoint parent = static_cast<BodyJoint>(clip.body.joints[part.joint].parent);
  const double scale = relative_stature(clip.body);
  std::vector<JointTransforms> worlds;
  for (const Pose& pose : clip.poses) worlds.push_back(world_transforms(clip.body, pose));
  const std::vector<Vec3> thrown = accelerations(clip, worlds, part.joint);
  for (std::size_t f = 0; f < worlds.size(); ++f) {
    const JointTransforms& world = worlds[f];
    const Quat to_parent = world.rotations[parent].conjugate();
    const Vec3& at = world.positions[part.joint];
    const std::vector<SegmentMass> masses = segment_masses(clip.body, world);
    SuspendedPart::Moment moment;
    double mass = 0.0, inertia = 0.0;
    Vec3 lever = Vec3::Zero();
    for (const int s : part.segments) {
      const SegmentMass& segment = masses[static_cast<std::size_t>(s)];
      const double radius = scale * radius_of(s);
      mass += segment.share;
      lever += segment.share * (segment.centre - at);
      inertia += segment.share * ((segment.centre - at).squaredNorm() + radius * radius);
    }
    const BodyJoint front = part.second == Pelvis ? part.joint : part.second;
    lever = lever / mass + scale * part.before * (world.rotations[front] * Vec3::UnitZ());
    moment.lever = to_parent * lever;
    moment.inertia = inertia / mass;
    const Vec3 bone = part.end == part.joint
                          ? Vec3(world.rotations[part.joint] * rest_bone(clip.body, part))
                          : Vec3(world.positions[part.end] - at);
    moment.bone = (to_parent * bone).normalized();
    const Vec3 held = Vec3(0.0, -fields.weight * gravity, 0.0) - thrown[f];
    moment.field = to_parent * ((1.0 - fields.carried) * held);
    if (part.beside_body) {
      moment.outward = clip.body.joints[part.end].offset.normalized();
      moment.least_outward = std::min(nearest_arm, moment.bone.dot(moment.outward));
    }
    if (part.hinges) {
      const Vec3 rest = clip.body.joints[part.end].offset.normalized();
      const double bend =
          std::atan2(rest.cross(moment.bone).dot(result.hinge), rest.dot(moment.bone));
      moment.least_hinge = std::min(0.0, least_bend - bend);
    }
    result.moments.push_back(moment);
  }
  const std::size_t count = result.moments.size();
  for (std::size_t f = 0; f < count; ++f) {
    if (f + 1 == count && !clip.loops) break;
    const std::size_t next = (f + 1) % count;
    // A hinge turns by what the joint turns about it, another part by what its bone does.
    const Vec3 turn = part.hinges
                          ? log(clip.poses[next].rotations[part.joint] *
                                clip.poses[f].rotations[part.joint].conjugate())
                          : log(turn_between(result.moments[f].bone, result.moments[next].bone));
    result.moments[f].rate = turn * clip.frames_per_second;
  }
  return result;
}

/// Deflects a part in every frame by rotation vectors in the frame of its joint's parent.
void deflect(Clip& clip, const Suspension& part, const std::vector<Vec3>& angles) {
  for (std::size_t f = 0; f < angles.size(); ++f) {
    std::vector<Quat>& rotations = clip.poses[f].rotations;
    Quat& first = rotations[part.joint];
    if (part.second == Pelvis) {
      first = (exp(angles[f]) * first).normalized();
      continue;
    }
    const Vec3 half = 0.5 * angles[f];
    first = (exp(half) * first).normalized();
    Quat& second = rotations[part.second];
    second = (exp(first.conjugate() * half) * second).normalized();
  }
}

void suspend(Clip& clip, const Suspension& part, double stiffness, double weight) {
  const SuspendedPart loaded = suspended(clip, part, {1.0, weight});
  if (weight != 1.0) {
    std::vector<Vec3> angles;
    const auto parent = clip.body.joints[part.joint].parent;
    for (std::size_t f = 0; f < clip.poses.size(); ++f) {
      const Vec3 more = Vec3(0.0, -(weight - 1.0) * gravity, 0.0);
      const Quat to_parent = world_transform(clip.body, clip.poses[f], parent).rotation.conjugate();
      angles.push_back(static_deflection(loaded.moments[f], loaded.hinge, to_parent * more,
                                         2.0 * pi * part.hz, part.largest));
    }
    deflect(clip, part, angles);
  }
  if (stiffness >= 1.0) return;
  SuspendedPart slack = suspended(clip, part, {stiffness, weight});
  slack.spring = muscle_spring(stiffness, part.hz);
  deflect(clip, part, deflections(slack, clip.frames_per_second, clip.loops));
}

/// The joint's rotations with their deviations from the mean posture (of a loop; else from what is
/// slower than 0.5 Hz) made smaller.
void hold(Clip& clip, BodyJoint joint, double share) {
  const std::vector<Directions> curve = direction_curve(clip, joint);
  std::vector<Vec3> first, second;
  for (const Directions& directions : curve) {
    first.push_back(directions.head<3>());
    second.push_back(directions.tail<3>());
  }
  if (clip.loops) {
    Vec3 sums[2] = {Vec3::Zero(), Vec3::Zero()};
    for (std::size_t f = 0; f < curve.size(); ++f) {
      sums[0] += first[f] / static_cast<double>(curve.size());
      sums[1] += second[f] / static_cast<double>(curve.size());
    }
    std::fill(first.begin(), first.end(), sums[0]);
    std::fill(second.begin(), second.end(), sums[1]);
  } else {
    first = low_pass(first, posture_hz, clip.frames_per_second);
    second = low_pass(second, posture_hz, clip.frames_per_second);
  }
  for (std::size_t f = 0; f < curve.size(); ++f) {
    Quat& rotation = clip.poses[f].rotations[joint];
    const Quat mean = to_rotation(DirectionVectors{first[f], second[f]}, rotation);
    rotation = slerp(rotation, in_hemisphere_of(rotation, mean), share);
  }
}

void move_part(Clip& clip, const std::vector<Suspension>& parts, double stiffness, double weight) {
  if (stiffness > 1.0) {
    for (const Suspension& part : parts) {
      hold(clip, part.joint, stiffness - 1.0);
      if (part.second != Pelvis) hold(clip, part.second, stiffness - 1.0);
    }
  }
  if (stiffness >= 1.0 && weight == 1.0) return;
  for (const Suspension& part : parts) suspend(clip, part, stiffness, weight);
}

}  // namespace

bool is_unit(const Stiffness& stiffness) { return stiffness == Stiffness{}; }

Stiffness scaled(const Stiffness& stiffness, double strength) {
  const auto at = [&](double value, double most) {
    return std::clamp(1.0 + strength * (value - 1.0), 0.0, most);
  };
  return {at(stiffness.head, 2.0), at(stiffness.trunk, 2.0), at(stiffness.left_arm, 2.0),
          at(stiffness.right_arm, 2.0), at(stiffness.legs, 1.0)};
}

SpringDamper muscle_spring(double stiffness, double hz) {
  const double held = std::max(stiffness, least_stiffness);
  return {2.0 * pi * hz * held / (1.0 - held), 0.3 + 0.7 * stiffness};
}

Clip with_limb_dynamics(const Clip& clip, const Stiffness& stiffness, double weight) {
  Clip result = clip;
  if (clip.frame_count() < 2) return result;
  move_part(result, {trunk()}, stiffness.trunk, weight);
  move_part(result, {head()}, stiffness.head, weight);
  move_part(result, arm(true), stiffness.left_arm, weight);
  move_part(result, arm(false), stiffness.right_arm, weight);
  return result;
}

}  // namespace mien::motion
