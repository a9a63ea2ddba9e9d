#include "scenes/mannequin/mannequin_hand.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "scenes/bent_fingers.h"
#include "scenes/closed_surface.h"
#include "scenes/glb_contents.h"
#include "scenes/mannequin/hand_surface.h"
#include "scenes/mannequin/mannequin.h"

namespace mien::scenes {
namespace {

using motion::Finger;
using motion::Vec3;

constexpr int joint_count = motion::body_joint_count + motion::finger_joint_count;

Mannequin with_hands(const motion::Skeleton& body, MeshDetail detail = MeshDetail::full) {
  return make_mannequin(body, {}, colours_of(Role::created), detail, MannequinHands::fingers);
}

motion::Pose t_pose(std::vector<motion::Quat> fingers) {
  motion::Pose pose;
  pose.root_position.y() = 1.0;
  pose.rotations.assign(motion::body_joint_count, motion::Quat::Identity());
  pose.fingers = std::move(fingers);
  return pose;
}

motion::JointTransforms joints_of(const motion::Skeleton& body, const motion::Pose& pose) {
  return motion::world_transforms(motion::with_fingers(body), motion::with_fingers(pose));
}

/// Whether the joint that moves a vertex most is one of a finger's.
bool is_of_finger(const Mannequin& mannequin, std::size_t vertex, bool left, Finger finger) {
  const int joint = mannequin.mesh.influences[vertex].front().joint - motion::body_joint_count;
  return joint >= 0 && motion::is_left_finger(joint) == left && motion::finger_of(joint) == finger;
}

TEST(AMannequinsHands, AreClosedSurfacesWithFingersApart) {
  for (const double stature : {1.3, 1.75}) {
    const motion::Skeleton body = motion::standard_body(stature);
    for (const MeshDetail detail : {MeshDetail::full, MeshDetail::draft}) {
      const Mannequin mannequin = with_hands(body, detail);
      const mien::test::Topology topology = mien::test::topology_of(mannequin.mesh.triangles);
      EXPECT_EQ(topology.bad_edges, 0);
      // Body and two hands; fingers that grew together would make a handle.
      EXPECT_EQ(topology.euler, 6) << stature;
      EXPECT_NO_THROW(validate(mannequin.mesh, joint_count));
      EXPECT_LT(mannequin.mesh.triangles.size(), detail == MeshDetail::full ? 50000u : 29000u);
    }
  }
}

TEST(AMannequinsHands, FaceOutwards) {
  const Mannequin mannequin = with_hands(motion::standard_body());
  const auto& mesh = mannequin.mesh;
  std::array<double, 2> volumes{};  // of the fingers' triangles, from the wrist: > 0 outwards
  for (const auto& t : mesh.triangles) {
    const auto a = static_cast<std::size_t>(t[0]), b = static_cast<std::size_t>(t[1]),
               c = static_cast<std::size_t>(t[2]);
    const Vec3 normal =
        (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    if (normal.norm() < 1e-9) continue;
    const int joint = mesh.influences[a].front().joint;
    if (joint < motion::body_joint_count) continue;
    EXPECT_GT(normal.normalized().dot(mesh.normals[a]), 0.0);
    const bool left = motion::is_left_finger(joint - motion::body_joint_count);
    const Vec3& wrist = mannequin.bind.positions[left ? motion::LeftWrist : motion::RightWrist];
    volumes[left ? 0 : 1] += (mesh.positions[a] - wrist).dot(normal) / 6.0;
  }
  EXPECT_GT(volumes[0], 5e-5);
  EXPECT_NEAR(volumes[0], volumes[1], 0.03 * volumes[0]);
}

TEST(AMannequinsHands, LeaveNoGapAtTheWrist) {
  const motion::Skeleton body = motion::standard_body();
  const Mannequin mannequin = with_hands(body);
  const Flesh flesh = flesh_of(body, mannequin.bind, {});
  const SignedDistance forearm = without_hands(flesh, mannequin.bind, hand_scale(body));
  const HandCells cells;
  const Surface hand = hand_surface(flesh, mannequin.bind, true, hand_scale(body), cells);
  const auto along = [&](const Vec3& point) {
    return (mannequin.bind.rotations[motion::LeftWrist].conjugate() *
            (point - mannequin.bind.positions[motion::LeftWrist]))
        .x();
  };
  // Where either surface ends, it is inside the other.
  int ends_of_hand = 0;
  int ends_of_body = 0;
  for (const Vec3& point : hand.positions) {
    if (along(point) > -0.058) continue;
    EXPECT_LT(forearm(point), -5e-4);
    ++ends_of_hand;
  }
  const std::size_t of_body = mannequin.mesh.positions.size() - 2 * hand.positions.size();
  for (std::size_t v = 0; v < of_body; ++v) {
    const Vec3& point = mannequin.mesh.positions[v];
    if (mannequin.mesh.influences[v].front().joint != motion::LeftWrist || along(point) < 0.004)
      continue;
    EXPECT_LT(signed_distance(flesh, point), -5e-4);
    ++ends_of_body;
  }
  EXPECT_GT(ends_of_hand, 20);
  EXPECT_GT(ends_of_body, 5);
}

TEST(AMannequinsHands, ReachTheirFingertipsInAnyPose) {
  const motion::Skeleton body = motion::standard_body(1.6);
  const Mannequin mannequin = with_hands(body);
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    const motion::Pose pose = t_pose(mien::test::random_fingers(seed));
    const motion::JointTransforms joints = joints_of(body, pose);
    const std::vector<Vec3> tips = fingertips_of(body, joints);
    const render::Mesh mesh = posed(mannequin, body, pose);
    for (std::size_t t = 0; t < tips.size(); ++t) {
      const bool left = t < motion::fingers_per_hand;
      const auto finger = Finger(t % motion::fingers_per_hand);
      const auto last = static_cast<std::size_t>(
          with_body(motion::finger_joint(left, finger, motion::joints_per_finger - 1)));
      const Vec3 along = (tips[t] - joints.positions[last]).normalized();
      double farthest = -1.0, nearest = 1.0;
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const int joint = mannequin.mesh.influences[v].front().joint;
        if (joint != static_cast<int>(last)) continue;
        const Vec3 from_tip = mesh.positions[v].cast<double>() - tips[t];
        nearest = std::min(nearest, from_tip.norm());
        if (from_tip.norm() < 0.02) farthest = std::max(farthest, from_tip.dot(along));
      }
      EXPECT_LT(nearest, 0.003) << seed << " " << t;
      EXPECT_NEAR(farthest, 0.0, 0.002) << seed << " " << t;
    }
  }
}

TEST(AMannequinsHands, BendTowardsThePalm) {
  const motion::Skeleton body = motion::standard_body();
  const Mannequin mannequin = with_hands(body);
  const auto middle_of = [&](double degrees, Finger finger) {
    const render::Mesh mesh =
        posed(mannequin, body, t_pose(mien::test::bent_fingers([&](int) { return degrees; })));
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      if (!is_of_finger(mannequin, v, true, finger)) continue;
      sum += mesh.positions[v].cast<double>();
      ++count;
    }
    return Vec3(sum / count);
  };
  for (const Finger finger : {Finger::index, Finger::middle, Finger::ring, Finger::little}) {
    // The palm looks down, and fingers curl back under it.
    EXPECT_LT(middle_of(80.0, finger).y(), middle_of(0.0, finger).y() - 0.01);
    EXPECT_LT(middle_of(80.0, finger).x(), middle_of(0.0, finger).x() - 0.02);
  }
  // The thumb goes down and across the palm.
  EXPECT_LT(middle_of(40.0, Finger::thumb).y(), middle_of(0.0, Finger::thumb).y() - 0.005);
  EXPECT_LT(middle_of(40.0, Finger::thumb).z(), middle_of(0.0, Finger::thumb).z() - 0.005);
}

/// Extents of the finger where a plane through a joint cuts it: along the axis about which it
/// bends, and across.
std::array<double, 2> section(const Mannequin& mannequin, const motion::Skeleton& body,
                              const motion::Pose& pose, int joint) {
  const motion::JointTransforms joints = joints_of(body, pose);
  const auto j = static_cast<std::size_t>(with_body(joint));
  const auto before = static_cast<std::size_t>(with_body(joint - 1));
  const Vec3 to_joint = (joints.positions[j] - joints.positions[before]).normalized();
  const Vec3 along =
      (joints.rotations[j] * (joints.rotations[before].conjugate() * to_joint) + to_joint)
          .normalized();
  const Vec3 axis = joints.rotations[j] * motion::flexion_axis(joint);
  const Vec3 across = axis.cross(along);
  const render::Mesh mesh = posed(mannequin, body, pose);
  std::array<double, 2> least = {1.0, 1.0}, most = {-1.0, -1.0};
  for (const auto& t : mesh.triangles) {
    for (std::size_t e = 0; e < 3; ++e) {
      const auto a = static_cast<std::size_t>(t[e]), b = static_cast<std::size_t>(t[(e + 1) % 3]);
      const bool left = motion::is_left_finger(joint);
      if (!is_of_finger(mannequin, a, left, motion::finger_of(joint))) continue;
      const Vec3 from = mesh.positions[a].cast<double>() - joints.positions[j];
      const Vec3 to = mesh.positions[b].cast<double>() - joints.positions[j];
      const double x = from.dot(along), y = to.dot(along);
      if ((x < 0.0) == (y < 0.0) || from.norm() > 0.02) continue;
      const Vec3 cut = from + (to - from) * (x / (x - y));
      const std::array<double, 2> place = {cut.dot(axis), cut.dot(across)};
      for (std::size_t k = 0; k < 2; ++k) {
        least[k] = std::min(least[k], place[k]);
        most[k] = std::max(most[k], place[k]);
      }
    }
  }
  return {most[0] - least[0], most[1] - least[1]};
}

TEST(AMannequinsFingers, StayThickWhereTheyBend) {
  const motion::Skeleton body = motion::standard_body();
  const Mannequin mannequin = with_hands(body);
  for (int joint = 0; joint < motion::finger_joint_count; ++joint) {
    if (motion::segment_of(joint) == 0) continue;
    const auto straight =
        section(mannequin, body, t_pose(mien::test::bent_fingers([](int) { return 0.0; })), joint);
    const auto bent = section(
        mannequin, body,
        t_pose(mien::test::bent_fingers([&](int other) { return other == joint ? 90.0 : 0.0; })),
        joint);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_GT(straight[k], 0.011) << motion::finger_joint_name(joint);
      EXPECT_GT(bent[k], 0.7 * straight[k]) << motion::finger_joint_name(joint) << " " << k;
      EXPECT_LT(bent[k], 1.6 * straight[k]) << motion::finger_joint_name(joint) << " " << k;
    }
  }
}

TEST(AMannequinsFingers, AreMovedByTheirOwnJoints) {
  const Mannequin mannequin = with_hands(motion::standard_body());
  const std::vector<Vec3> tips = fingertips_of(motion::standard_body(), mannequin.bind);
  int last_segments = 0;
  for (const auto& influences : mannequin.mesh.influences) {
    const int joint = influences.front().joint - motion::body_joint_count;
    if (joint < 0 || motion::segment_of(joint) != 2) continue;
    ++last_segments;
    for (const Influence& influence : influences) {
      const int other = influence.joint - motion::body_joint_count;
      ASSERT_GE(other, 0);
      EXPECT_EQ(motion::finger_of(other), motion::finger_of(joint));
      EXPECT_EQ(motion::is_left_finger(other), motion::is_left_finger(joint));
    }
  }
  EXPECT_GT(last_segments, 500);
}

TEST(AMannequinsFingers, AreStraightBetweenTheirJoints) {
  const Mannequin mannequin = with_hands(motion::standard_body());
  const auto& mesh = mannequin.mesh;
  for (const Finger finger : {Finger::thumb, Finger::index, Finger::middle, Finger::ring}) {
    const int joint = with_body(motion::finger_joint(true, finger, 1));
    const Vec3& from = mannequin.bind.positions[static_cast<std::size_t>(joint)];
    const Vec3& to = mannequin.bind.positions[static_cast<std::size_t>(joint) + 1];
    const Vec3 along = (to - from).normalized();
    int there = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      const Vec3 from_middle = mesh.positions[v] - 0.5 * (from + to);
      if (std::abs(from_middle.dot(along)) > 0.003 || from_middle.norm() > 0.014) continue;
      if (!is_of_finger(mannequin, v, true, finger)) continue;
      EXPECT_EQ(mesh.influences[v].front().joint, joint);
      EXPECT_GT(mesh.influences[v].front().weight, 0.95f);
      ++there;
    }
    EXPECT_GT(there, 10);
  }
}

TEST(AMannequin, WithHandsHasTheirJointsInItsFile) {
  const motion::Skeleton body = motion::standard_body();
  const Mannequin mannequin = with_hands(body, MeshDetail::draft);
  const mien::test::GlbContents glb = mien::test::glb_contents(to_glb(mannequin, body));
  EXPECT_EQ(glb.json["skins"][0]["joints"].size(), static_cast<std::size_t>(joint_count));
  const auto& node =
      glb.json["nodes"]
              [static_cast<std::size_t>(with_body(motion::finger_joint(false, Finger::index, 1)))];
  EXPECT_EQ(node["name"], "RightIndex2");
  EXPECT_EQ(node["extras"]["body_joint"], static_cast<int>(motion::RightWrist));
}

}  // namespace
}  // namespace mien::scenes
