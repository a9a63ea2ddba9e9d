#include "motion/biomechanics/collision_shapes.h"

#include <algorithm>
#include <cmath>

#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

constexpr int trunk_parts = 5;  // head to pelvis

struct Thickness {
  double from_radius;
  double to_radius;
};

Vec3 end_of(const Skeleton& body, const JointTransforms& world, BodyJoint joint, double share) {
  const Vec3 tip = body.joints[joint].tip.value_or(rest_direction(joint) * 0.1);
  return world.positions[joint] + share * (world.rotations[joint] * tip);
}

void add_side(const Skeleton& body, const JointTransforms& world, bool left, double scale,
              std::vector<RoundCone>& parts) {
  const auto on_side = [left](BodyJoint joint) { return left ? joint : mirrored(joint); };
  const auto bone = [&](BodyJoint from, BodyJoint to, Thickness thick) {
    parts.push_back({world.positions[on_side(from)], world.positions[on_side(to)],
                     thick.from_radius * scale, thick.to_radius * scale});
  };
  bone(LeftShoulder, LeftElbow, {0.05, 0.042});
  bone(LeftElbow, LeftWrist, {0.042, 0.03});
  const BodyJoint wrist = on_side(LeftWrist);
  // The palm only: fingers bend round what the hand lies on, and no skeleton here has any.
  parts.push_back(
      {world.positions[wrist], end_of(body, world, wrist, 0.4), 0.03 * scale, 0.025 * scale});
  bone(LeftHip, LeftKnee, {0.075, 0.05});
  bone(LeftKnee, LeftAnkle, {0.05, 0.035});
  bone(LeftAnkle, LeftToe, {0.035, 0.035});
}

/// A slice of the trunk: wider than deep, so it lies across it.
RoundCone across(const Vec3& centre, const Quat& turn, double half_width, double half_depth) {
  const Vec3 side = turn * Vec3(std::max(half_width - half_depth, 0.0), 0, 0);
  return {centre - side, centre + side, half_depth, half_depth};
}

/// Chest, abdomen and pelvis, as wide as the performer's shoulders and hips tell.
void add_trunk(const Skeleton& body, const JointTransforms& world, double scale,
               std::vector<RoundCone>& parts) {
  const auto& at = world.positions;
  const auto breadth = [&](BodyJoint joint) { return std::abs(body.joints[joint].offset.x()); };
  const double shoulders = breadth(LeftClavicle) + breadth(LeftShoulder);
  const double hips = breadth(LeftHip);
  const Vec3 hip_centre = 0.5 * (at[LeftHip] + at[RightHip]);
  const Vec3 chest = at[Chest] + 0.4 * (at[Neck] - at[Chest]);
  const Vec3 abdomen = 0.5 * (at[Spine] + at[Chest]);
  const Vec3 pelvis = hip_centre + 0.4 * (at[Spine] - hip_centre);
  parts.push_back(across(chest, world.rotations[Chest], 0.75 * shoulders, 0.1 * scale));
  parts.push_back(across(abdomen, world.rotations[Spine], 1.35 * hips, 0.09 * scale));
  parts.push_back(across(pelvis, world.rotations[Pelvis], 1.55 * hips, 0.1 * scale));
}

Pose at_ease() {
  Pose pose;
  pose.rotations.assign(body_joint_count, Quat::Identity());
  const double hanging = 1.4;  // radians from the T-pose: arms 10° off the sides
  pose.rotations[LeftShoulder] = exp(Vec3(0, 0, -hanging));
  pose.rotations[RightShoulder] = exp(Vec3(0, 0, hanging));
  return pose;
}

/// Number of bones between two joints in the tree.
int joints_between(BodyJoint a, BodyJoint b) {
  int steps = 0;
  int from = a;
  int to = b;
  while (from != to) {
    // Parents come before their children.
    int& later = from > to ? from : to;
    later = body_parents[static_cast<size_t>(later)];
    ++steps;
  }
  return steps;
}

}  // namespace

const std::vector<CollisionPart>& collision_parts() {
  static const std::vector<CollisionPart> parts = {
      {"head", Head},
      {"neck", Neck},
      {"chest", Chest},
      {"abdomen", Spine},
      {"pelvis", Pelvis},
      {"left upper arm", LeftShoulder},
      {"left forearm", LeftElbow},
      {"left hand", LeftWrist},
      {"left thigh", LeftHip},
      {"left shank", LeftKnee},
      {"left foot", LeftAnkle},
      {"right upper arm", RightShoulder},
      {"right forearm", RightElbow},
      {"right hand", RightWrist},
      {"right thigh", RightHip},
      {"right shank", RightKnee},
      {"right foot", RightAnkle},
  };
  return parts;
}

std::vector<RoundCone> collision_shapes(const Skeleton& body, const JointTransforms& world) {
  const double scale = relative_stature(body);
  const auto& at = world.positions;
  std::vector<RoundCone> parts;
  parts.push_back({end_of(body, world, Head, 0.25), end_of(body, world, Head, 0.5), 0.09 * scale,
                   0.09 * scale});
  parts.push_back({at[Neck], at[Head], 0.06 * scale, 0.055 * scale});
  add_trunk(body, world, scale, parts);
  add_side(body, world, true, scale, parts);
  add_side(body, world, false, scale, parts);
  return parts;
}

double penetration_depth(const RoundCone& a, const RoundCone& b) {
  // Closest points of two segments (Ericson 2005, Real-Time Collision Detection, 5.1.9).
  const Vec3 u = a.to - a.from;
  const Vec3 v = b.to - b.from;
  const Vec3 w = a.from - b.from;
  const double uu = u.dot(u);
  const double vv = v.dot(v);
  const double uv = u.dot(v);
  const double uw = u.dot(w);
  const double vw = v.dot(w);
  const double denominator = uu * vv - uv * uv;
  double s = denominator > 1e-12 ? std::clamp((uv * vw - uw * vv) / denominator, 0.0, 1.0) : 0.0;
  double t = vv > 1e-12 ? (uv * s + vw) / vv : 0.0;
  if (t < 0.0 || t > 1.0 || vv <= 1e-12) {
    t = std::clamp(t, 0.0, 1.0);
    s = uu > 1e-12 ? std::clamp((uv * t - uw) / uu, 0.0, 1.0) : 0.0;
  }
  const double distance = (w + s * u - t * v).norm();
  return a.from_radius + s * (a.to_radius - a.from_radius) + b.from_radius +
         t * (b.to_radius - b.from_radius) - distance;
}

std::vector<CollisionPair> collision_pairs(const Skeleton& body) {
  const std::vector<CollisionPart>& parts = collision_parts();
  const std::vector<RoundCone> easy = collision_shapes(body, world_transforms(body, at_ease()));
  std::vector<CollisionPair> pairs;
  for (int a = 0; a < static_cast<int>(parts.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(parts.size()); ++b) {
      const bool in_trunk = b < trunk_parts;
      const bool joined = joints_between(parts[a].joint, parts[b].joint) <= 1;
      if (in_trunk || joined) continue;
      pairs.push_back({a, b, std::max(0.0, penetration_depth(easy[a], easy[b]))});
    }
  }
  return pairs;
}

}  // namespace mien::motion
