// The oval that hides a face: what it encloses, and how far it reaches.

#include "scenes/face/hidden_face.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"
#include "motion/refusal.h"
#include "scenes/face/front_of_head.h"
#include "scenes/face_figure.h"
#include "scenes/fbx_of_gltf.h"

#include "real_data.h"

namespace mien::scenes {
namespace {

using motion::Quat;
using motion::Vec3;

const motion::Skeleton hidden_body = motion::standard_body();

Character synthetic_head() {
  return scaled_to_body(
      parse_character(mien::test::face_figure_glb(mien::test::FaceFormat::gltf), "face.glb"),
      hidden_body);
}

/// The place of a point seen from the joint of the head: to its left, up, to its front.
struct HeadFrame {
  Vec3 joint;
  motion::Mat3 axes;

  explicit HeadFrame(const Character& character) {
    const std::vector<int> owner = body_joint_of(character);
    const auto head = std::ranges::find(owner, static_cast<int>(motion::Head)) - owner.begin();
    joint = rig_bind_pose(character).positions[static_cast<std::size_t>(head)];
    axes = character.bind_rotations[motion::Head].toRotationMatrix();
  }
  Vec3 place(const Vec3& at) const { return axes.transpose() * (at - joint); }
};

/// Vertices of triangles that follow the head mainly, in its frame, with the mesh of each.
void for_each_of_head(const Character& character,
                      const std::function<void(const Vec3&, const SkinnedMesh&)>& use) {
  const std::vector<int> owner = body_joint_of(character);
  const HeadFrame frame(character);
  for (const SkinnedMesh& mesh : character.meshes)
    for (const auto& triangle : mesh.triangles)
      for (const int v : triangle) {
        const auto vertex = static_cast<std::size_t>(v);
        const int mainly = mesh.influences[vertex].front().joint;
        if (owner[static_cast<std::size_t>(mainly)] == motion::Head)
          use(frame.place(mesh.positions[vertex]), mesh);
      }
}

Eigen::AlignedBox3d box_of_whole_head(const Character& character) {
  Eigen::AlignedBox3d box;
  for_each_of_head(character, [&](const Vec3& at, const SkinnedMesh&) { box.extend(at); });
  return box;
}

Eigen::AlignedBox3d box_of_oval(const Character& hidden) {
  const HeadFrame frame(hidden);
  Eigen::AlignedBox3d box;
  for (const Vec3& at : hidden.meshes.back().positions) box.extend(frame.place(at));
  return box;
}

/// Distance from the middle of the oval in shares of its half-axes; 1 on its surface.
double share_of_oval(const Eigen::AlignedBox3d& oval, const Vec3& at) {
  return (at - oval.center()).cwiseQuotient(0.5 * oval.sizes()).norm();
}

TEST(AHiddenFace, EnclosesEyesBrowsLipsAndNose) {
  const Character plain = synthetic_head();
  const Eigen::AlignedBox3d oval = box_of_oval(with_hidden_face(plain));
  int features = 0, skins = 0;
  for_each_of_head(plain, [&](const Vec3& at, const SkinnedMesh& mesh) {
    const render::Color colour = plain.materials[static_cast<std::size_t>(mesh.material)].albedo;
    const bool is_skin = std::abs(colour.x() - 0.62f) < 1e-3f;
    const bool is_cloth = std::abs(colour.z() - 0.35f) < 1e-3f && colour.y() > 0.23f;
    const bool is_hair = std::abs(colour.x() - 0.06f) < 1e-3f;
    if (is_cloth || is_hair) return;
    // Of the skin, what is in front within the oval's outline; the rest is eyes, brows and lips.
    const Vec3 share = (at - oval.center()).cwiseQuotient(0.5 * oval.sizes());
    if (is_skin && (at.z() < 0.02 || share.head<2>().norm() > 0.96)) return;
    (is_skin ? skins : features)++;
    EXPECT_LT(share_of_oval(oval, at), 1.0) << at.transpose();
  });
  EXPECT_GT(features, 1000);
  EXPECT_GT(skins, 1000);
}

/// The oval is scarcely larger than the head, and no wider.
void expect_size_of_head(const Character& plain) {
  const Eigen::AlignedBox3d head = box_of_whole_head(plain);
  const Eigen::AlignedBox3d oval = box_of_oval(with_hidden_face(plain));
  EXPECT_LT(oval.sizes().x(), 1.05 * head.sizes().x());
  EXPECT_GT(oval.sizes().x(), 0.85 * head.sizes().x());
  const double height = head.max().y() - std::max(head.min().y(), -0.35 * head.max().y());
  EXPECT_LT(oval.sizes().y(), 1.05 * height);
  EXPECT_GT(oval.sizes().y(), 0.8 * height);
  EXPECT_LT(oval.max().y(), head.max().y() + 0.03 * height);
  EXPECT_GT(oval.min().y(), head.min().y() - 0.03 * height);
  // In front of the nose, and not behind the middle of the head by much.
  EXPECT_GT(oval.max().z(), head.max().z());
  EXPECT_LT(oval.max().z(), head.max().z() + 0.12 * head.sizes().z());
  EXPECT_GT(oval.min().z(), head.center().z() - 0.35 * head.sizes().z());
}

TEST(AHiddenFace, HasTheOutlineOfTheHead) { expect_size_of_head(synthetic_head()); }

TEST(AHiddenFace, HasTheOutlineOfTheHeadOfAnFbxCharacter) {
  const std::string gltf =
      mien::test::text_of_glb(mien::test::face_figure_glb(mien::test::FaceFormat::joints));
  expect_size_of_head(scaled_to_body(
      parse_character(mien::test::fbx_of_gltf(gltf).binary(), "face.fbx"), hidden_body));
}

TEST(AHiddenFace, HasTheOutlineOfARealHelmet) {
  const auto data = test::real_data();
  if (!data) GTEST_SKIP() << "no characters here: set MIEN_DATA to the folder that has them";
  const Character man =
      scaled_to_body(read_character(*data / "characters" / "cesium_man.gltf"), hidden_body);
  expect_size_of_head(man);
  // Its visor is plane, so the oval is no deeper than it must be.
  const Eigen::AlignedBox3d oval = box_of_oval(with_hidden_face(man));
  EXPECT_NEAR(oval.sizes().z(), 0.15 * oval.sizes().x(), 0.01 * oval.sizes().x());
}

/// Gives the character a box that follows its head; corners in the frame of the head.
void add_box(Character& character, const Eigen::AlignedBox3d& box) {
  const HeadFrame frame(character);
  const std::vector<int> owner = body_joint_of(character);
  const auto head = std::ranges::find(owner, static_cast<int>(motion::Head)) - owner.begin();
  SkinnedMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
    mesh.positions.push_back(frame.joint + frame.axes * at);
    mesh.normals.push_back(Vec3::UnitY());
    mesh.influences.push_back({{static_cast<int>(head), 1.0f}});
  }
  for (const auto& [a, b, c, d] : std::vector<std::array<int, 4>>{
           {0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  mesh.triangle_parts.assign(mesh.triangles.size(), motion::Head);
  character.meshes.push_back(std::move(mesh));
}

TEST(AHiddenFace, IsNotPulledDownByANeckOrAsideByHair) {
  const Character plain = synthetic_head();
  Character dressed = plain;
  add_box(dressed, {Vec3(-0.05, -0.25, -0.05), Vec3(0.05, 0.02, 0.05)});  // a neck
  add_box(dressed, {Vec3(0.05, -0.3, -0.06), Vec3(0.16, 0.15, -0.01)});   // two tails of hair
  add_box(dressed, {Vec3(-0.16, -0.3, -0.06), Vec3(-0.05, 0.15, -0.01)});
  add_box(dressed, {Vec3(-0.03, -0.3, -0.5), Vec3(0.03, 0.15, -0.05)});  // and one behind
  const Eigen::AlignedBox3d expected = box_of_oval(with_hidden_face(plain));
  const Eigen::AlignedBox3d oval = box_of_oval(with_hidden_face(dressed));
  EXPECT_NEAR(oval.sizes().x(), expected.sizes().x(), 0.004);
  EXPECT_NEAR(oval.min().y(), expected.min().y(), 0.015);
  EXPECT_NEAR(oval.max().y(), expected.max().y(), 0.015);
  EXPECT_NEAR(oval.max().z(), expected.max().z(), 0.015);
}

TEST(AHiddenFace, IsRefusedWithoutAHead) {
  Character character = synthetic_head();
  std::erase_if(character.meshes, [](const SkinnedMesh& mesh) {
    return std::ranges::any_of(mesh.influences, [](const auto& influences) {
      return influences.front().joint == motion::Head;
    });
  });
  EXPECT_NE(mien::test::refusal_of([&] { with_hidden_face(character); }).find("no face to hide"),
            std::string::npos);
}

TEST(AHiddenFace, TurnsWithTheHead) {
  const Character hidden = with_hidden_face(synthetic_head());
  const SkinnedMesh& oval = hidden.meshes.back();
  validate(oval, hidden.rig.size());
  motion::Pose pose;
  pose.root_position = Vec3(0.1, 1.0, -0.2);
  pose.rotations.assign(motion::body_joint_count, Quat::Identity());
  pose.rotations[motion::Head] = motion::exp(Vec3(0.2, 0.7, -0.1));
  const auto meshes = posed(hidden, pose);
  const JointMotions motions = joint_motions(rig_bind_pose(hidden), rig_pose(hidden, pose));
  for (std::size_t v = 0; v < oval.positions.size(); v += 50)
    EXPECT_LT(
        (meshes.back().positions[v].cast<double>() - motions[motion::Head] * oval.positions[v])
            .norm(),
        1e-6);
}

/// A sphere above the joint of a head, as rings of triangles.
HeadTriangles sphere_of(const Vec3& centre, double radius) {
  const auto point = [&](int row, int column) -> Vec3 {
    const double up = motion::pi * (row / 60.0 - 0.5), round = motion::pi * column / 60.0;
    return centre + radius * Vec3(std::cos(up) * std::sin(round), std::sin(up),
                                  std::cos(up) * std::cos(round));
  };
  HeadTriangles head;
  for (int row = 0; row < 60; ++row)
    for (int column = 0; column < 120; ++column) {
      head.push_back({point(row, column), point(row, column + 1), point(row + 1, column + 1)});
      head.push_back({point(row, column), point(row + 1, column + 1), point(row + 1, column)});
    }
  return head;
}

// The profile of a sphere recedes by a quarter of its depth, half its radius, 60° below its middle.
TEST(TheFrontOfAHead, EndsWhereASphereRecedes) {
  const double radius = 0.1;
  const FrontOfHead front = front_of_head(sphere_of({0.02, 0.1, 0.0}, radius));
  const double cell = 0.2 / 90;
  EXPECT_NEAR(front.outline.min().y(), 0.1 - radius * std::sqrt(0.75), 1.5 * cell);
  EXPECT_NEAR(front.outline.max().y(), 0.2, 1.5 * cell);
  EXPECT_NEAR(front.outline.min().x(), 0.02 - radius, 1.5 * cell);
  EXPECT_NEAR(front.outline.max().x(), 0.02 + radius, 1.5 * cell);
  EXPECT_GT(front.face.size(), 4000u);
  for (const Vec3& at : front.face) {
    EXPECT_NEAR((at - Vec3(0.02, 0.1, 0.0)).norm(), radius, 0.001);
    EXPECT_GT(at.z(), -1e-9);
  }
}

TEST(TheFrontOfAHead, IsEmptyBehindTheJoint) {
  EXPECT_TRUE(front_of_head(sphere_of({0.0, 0.1, -0.2}, 0.1)).face.empty());
  EXPECT_TRUE(front_of_head({}).face.empty());
}

}  // namespace
}  // namespace mien::scenes
