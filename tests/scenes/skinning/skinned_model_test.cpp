#include "scenes/skinning/skinned_model.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"

namespace mien::scenes {
namespace {

using motion::Quat;
using motion::Vec3;

Vec3 random_vector(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> number(-size, size);
  return {number(random), number(random), number(random)};
}

Quat random_turn(std::mt19937_64& random) { return motion::exp(random_vector(random, 1.8)); }

/// A tube along +X round two joints at x = 0 and x = 1, the second taking over softly.
SkinnedMesh tube() {
  SkinnedMesh mesh;
  constexpr int rings = 21;
  constexpr int around = 16;
  for (int r = 0; r < rings; ++r) {
    const double x = 2.0 * r / (rings - 1);
    for (int k = 0; k < around; ++k) {
      const double angle = 2.0 * motion::pi * k / around;
      const Vec3 normal(0.0, std::cos(angle), std::sin(angle));
      mesh.positions.push_back(Vec3(x, 0.0, 0.0) + 0.1 * normal);
      mesh.normals.push_back(normal);
      const double beyond = std::clamp(0.5 + 2.5 * (x - 1.0), 0.0, 1.0);
      std::vector<Influence> influences = {{0, static_cast<float>(1.0 - beyond)},
                                           {1, static_cast<float>(beyond)}};
      normalize(influences);
      mesh.influences.push_back(influences);
    }
  }
  for (int r = 0; r + 1 < rings; ++r) {
    for (int k = 0; k < around; ++k) {
      const int a = r * around + k;
      const int b = r * around + (k + 1) % around;
      mesh.triangles.push_back({a, b, b + around});
      mesh.triangles.push_back({a, b + around, a + around});
    }
  }
  return mesh;
}

motion::JointTransforms tube_joints() {
  return {{Vec3::Zero(), Vec3::UnitX()}, {Quat::Identity(), Quat::Identity()}};
}

/// The second joint twisted about the tube.
JointMotions twisted(double degrees) {
  motion::JointTransforms now = tube_joints();
  now.rotations[1] = motion::exp(Vec3(degrees * motion::radians_per_degree, 0.0, 0.0));
  return joint_motions(tube_joints(), now);
}

double least_radius(const render::Mesh& mesh) {
  double least = 1.0;
  for (const render::Vec3& p : mesh.positions) {
    least = std::min(least, static_cast<double>(std::hypot(p.y(), p.z())));
  }
  return least;
}

using Skin = render::Mesh (*)(const SkinnedMesh&, const JointMotions&);

class Skinning : public testing::TestWithParam<Skin> {};

TEST_P(Skinning, InTheBindPoseGivesTheBindMesh) {
  const SkinnedMesh mesh = tube();
  const render::Mesh posed = GetParam()(mesh, joint_motions(tube_joints(), tube_joints()));
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_LT((posed.positions[v].cast<double>() - mesh.positions[v]).norm(), 1e-6);
    EXPECT_LT((posed.normals[v].cast<double>() - mesh.normals[v]).norm(), 1e-6);
  }
}

TEST_P(Skinning, UnderOneRigidMotionOfAllJointsIsThatMotion) {
  std::mt19937_64 random(7);
  const SkinnedMesh mesh = tube();
  for (int trial = 0; trial < 50; ++trial) {
    const Quat turn = random_turn(random);
    const Vec3 shift = random_vector(random, 3.0);
    motion::JointTransforms now = tube_joints();
    for (size_t j = 0; j < 2; ++j) {
      now.positions[j] = turn * now.positions[j] + shift;
      // The same rotation, written with either sign.
      now.rotations[j] = j == 0 ? turn : Quat(-turn.coeffs());
    }
    const render::Mesh posed = GetParam()(mesh, joint_motions(tube_joints(), now));
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
      const Vec3 expected = turn * mesh.positions[v] + shift;
      EXPECT_LT((posed.positions[v].cast<double>() - expected).norm(), 2e-6);
      EXPECT_LT((posed.normals[v].cast<double>() - turn * mesh.normals[v]).norm(), 1e-6);
    }
  }
}

TEST_P(Skinning, MovesAVertexOfOneJointWithThatJoint) {
  std::mt19937_64 random(11);
  const SkinnedMesh mesh = tube();
  motion::JointTransforms now = tube_joints();
  now.rotations = {random_turn(random), random_turn(random)};
  now.positions[1] = random_vector(random, 2.0);
  const JointMotions motions = joint_motions(tube_joints(), now);
  const render::Mesh posed = GetParam()(mesh, motions);
  EXPECT_LT((posed.positions.front().cast<double>() - motions[0] * mesh.positions.front()).norm(),
            1e-6);
  EXPECT_LT((posed.positions.back().cast<double>() - motions[1] * mesh.positions.back()).norm(),
            1e-6);
}

INSTANTIATE_TEST_SUITE_P(BothWays, Skinning,
                         testing::Values(linear_blend_skinned, dual_quaternion_skinned),
                         [](const auto& way) {
                           return way.param == linear_blend_skinned ? "Linear" : "DualQuaternion";
                         });

TEST(DualQuaternionSkinning, KeepsATwistedLimbAsThickAsItIs) {
  EXPECT_NEAR(least_radius(dual_quaternion_skinned(tube(), twisted(170.0))), 0.1, 1e-6);
  // The linear blend collapses: this is what the other is for.
  EXPECT_LT(least_radius(linear_blend_skinned(tube(), twisted(170.0))), 0.02);
}

TEST(DualQuaternionSkinning, TakesTheShortWayWhicheverSignARotationHas) {
  motion::JointTransforms now = tube_joints();
  now.rotations[1] = motion::exp(Vec3(0.0, 0.0, 1.0));
  const render::Mesh one = dual_quaternion_skinned(tube(), joint_motions(tube_joints(), now));
  now.rotations[1].coeffs() *= -1.0;
  const render::Mesh other = dual_quaternion_skinned(tube(), joint_motions(tube_joints(), now));
  for (size_t v = 0; v < one.positions.size(); ++v) {
    EXPECT_LT((one.positions[v] - other.positions[v]).norm(), 1e-6f);
  }
}

TEST(LinearSkinning, KeepsNormalsUprightUnderUnevenScales) {
  std::mt19937_64 random(3);
  const SkinnedMesh mesh = tube();
  const motion::Mat3 squeeze =
      random_turn(random).toRotationMatrix() * Vec3(1.0, 0.3, 2.0).asDiagonal();
  const Eigen::Affine3d motion(squeeze);
  const render::Mesh posed = linear_blend_skinned(mesh, {motion, motion});
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3 along(1.0, 0.0, 0.0);
    const Vec3 around = mesh.normals[v].cross(along);
    const Vec3 normal = posed.normals[v].cast<double>();
    EXPECT_NEAR(normal.norm(), 1.0, 1e-6);
    EXPECT_NEAR(normal.dot(squeeze * along), 0.0, 1e-6);
    EXPECT_NEAR(normal.dot(squeeze * around), 0.0, 1e-6);
    EXPECT_GT(normal.dot(squeeze * mesh.normals[v]), 0.0);
  }
}

TEST(DualQuaternions, AreTheRigidMotionsTheyWereMadeOf) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const Quat turn = random_turn(random);
    const Vec3 shift = random_vector(random, 5.0);
    DualQuaternion scaled = dual_quaternion(turn, shift);
    scaled.real *= 3.7;
    scaled.dual *= 3.7;
    const DualQuaternion back = normalized(scaled);
    EXPECT_LT(motion::angle_between(rotation_of(back), turn), 1e-7);
    EXPECT_LT((translation_of(back) - shift).norm(), 1e-12);
  }
}

TEST(Influences, AreTheEightLargestAndSumToOne) {
  std::vector<Influence> influences;
  for (int j = 0; j < 12; ++j) influences.push_back({j, 1.0f + static_cast<float>(j)});
  influences.push_back({12, -5.0f});
  influences.push_back({13, 1e-6f});
  normalize(influences);
  ASSERT_EQ(influences.size(), 8u);
  float sum = 0.0f;
  for (const Influence& influence : influences) sum += influence.weight;
  EXPECT_NEAR(sum, 1.0f, 1e-6f);
  EXPECT_EQ(influences.front().joint, 11);
  EXPECT_EQ(influences.back().joint, 4);
}

TEST(ASkinnedMesh, IsRefusedWithAJointThatIsNotThere) {
  SkinnedMesh mesh = tube();
  EXPECT_NO_THROW(validate(mesh, 2));
  EXPECT_THROW(validate(mesh, 1), std::invalid_argument);
  mesh.influences[3] = {{0, 0.6f}};
  EXPECT_THROW(validate(mesh, 2), std::invalid_argument);
  mesh = tube();
  mesh.triangles[0][1] = 100000;
  EXPECT_THROW(validate(mesh, 2), std::invalid_argument);
  mesh = tube();
  mesh.positions[5].y() = std::nan("");
  EXPECT_THROW(validate(mesh, 2), std::invalid_argument);
}

/// Sum of the diagonals of the boxes around every eight consecutive triangles, metres.
double box_diagonals(const SkinnedMesh& mesh) {
  double sum = 0.0;
  for (size_t first = 0; first < mesh.triangles.size(); first += 8) {
    Eigen::AlignedBox3d box;
    for (size_t i = first; i < std::min(first + 8, mesh.triangles.size()); ++i)
      for (const int vertex : mesh.triangles[i])
        box.extend(mesh.positions[static_cast<size_t>(vertex)]);
    sum += box.diagonal().norm();
  }
  return sum;
}

TEST(ClusteredTriangles, AreTheSameTrianglesCloserTogether) {
  SkinnedMesh mesh = tube();
  for (size_t i = 0; i < mesh.triangles.size(); ++i)
    mesh.triangle_parts.push_back(static_cast<int>(i));
  const SkinnedMesh before = mesh;
  std::mt19937_64 random(4);
  std::shuffle(mesh.triangle_parts.begin(), mesh.triangle_parts.end(), random);
  for (size_t i = 0; i < mesh.triangles.size(); ++i)
    mesh.triangles[i] = before.triangles[static_cast<size_t>(mesh.triangle_parts[i])];
  const SkinnedMesh shuffled = mesh;

  cluster_triangles(mesh);
  EXPECT_LT(box_diagonals(mesh), 0.2 * box_diagonals(shuffled));
  std::vector<int> parts = mesh.triangle_parts;
  for (size_t i = 0; i < parts.size(); ++i)
    EXPECT_EQ(mesh.triangles[i], before.triangles[static_cast<size_t>(parts[i])])
        << "each triangle keeps its part";
  std::sort(parts.begin(), parts.end());
  EXPECT_EQ(parts, before.triangle_parts) << "none is lost or twice there";
}

TEST(ClusteredTriangles, StayCloseWhenClusteredAgain) {
  SkinnedMesh once = tube();
  cluster_triangles(once);
  SkinnedMesh again = once;
  cluster_triangles(again);
  EXPECT_NEAR(box_diagonals(again), box_diagonals(once), 0.2 * box_diagonals(once));
  // Few and coinciding triangles are no special case.
  SkinnedMesh one = tube();
  one.triangles.assign(17, one.triangles[0]);
  cluster_triangles(one);
  EXPECT_EQ(one.triangles, std::vector(17, tube().triangles[0]));
  one.triangles.clear();
  cluster_triangles(one);
  EXPECT_TRUE(one.triangles.empty());
}

}  // namespace
}  // namespace mien::scenes
