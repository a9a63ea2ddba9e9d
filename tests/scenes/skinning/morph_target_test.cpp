// Morph targets: weighted sums of displacements before skinning, and the normals that follow.

#include <random>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"
#include "scenes/skinning/skinned_model.h"

namespace mien::scenes {
namespace {

using motion::Vec3;

/// A flat sheet of 5 x 5 vertices that follows two joints; the middle vertex twice, as at a seam.
SkinnedMesh sheet() {
  SkinnedMesh mesh;
  for (int z = 0; z < 5; ++z) {
    for (int x = 0; x < 5; ++x) {
      mesh.positions.emplace_back(x, 0.0, z);
      mesh.normals.emplace_back(Vec3::UnitY());
      const auto share = static_cast<float>(x) / 4.0f;
      mesh.influences.push_back({{0, 1.0f - share}, {1, share}});
    }
  }
  for (int z = 0; z < 4; ++z) {
    for (int x = 0; x < 4; ++x) {
      const int a = 5 * z + x;
      mesh.triangles.push_back({a, a + 5, a + 1});
      mesh.triangles.push_back({a + 1, a + 5, a + 6});
    }
  }
  mesh.positions.push_back(mesh.positions[12]);
  mesh.normals.push_back(mesh.normals[12]);
  mesh.influences.push_back(mesh.influences[12]);
  mesh.triangles.push_back({25, 17, 13});
  return mesh;
}

MorphTarget moving(int morph, std::vector<int> vertices, const Vec3& move) {
  MorphTarget target;
  target.morph = morph;
  target.positions.assign(vertices.size(), move);
  target.vertices = std::move(vertices);
  return target;
}

JointMotions some_motions() {
  Eigen::Affine3d one(motion::exp(Vec3(0.4, -0.2, 0.7)));
  Eigen::Affine3d other(motion::exp(Vec3(-0.1, 0.5, 0.2)));
  return {Eigen::Translation3d(0.1, 0.2, 0.3) * one, Eigen::Translation3d(-0.5, 1.0, 0.4) * other};
}

TEST(AMorphTarget, OfWeightZeroLeavesEveryByte) {
  SkinnedMesh mesh = sheet();
  const render::Mesh plain = linear_blend_skinned(mesh, some_motions());
  mesh.morphs = {moving(0, {3, 7, 12}, Vec3(0.1, 0.2, -0.1))};
  complete_morph_normals(mesh);
  for (const std::vector<double>& weights : {std::vector<double>{}, {0.0}, {0.0, 1.0}}) {
    EXPECT_FALSE(is_morphed(mesh, weights));
    const render::Mesh same = morphed_and_skinned(mesh, some_motions(), weights);
    EXPECT_EQ(same.positions, plain.positions);
    EXPECT_EQ(same.normals, plain.normals);
  }
}

TEST(AMorphTarget, MovesInProportionToItsWeightAndAddsToOthers) {
  SkinnedMesh mesh = sheet();
  const Vec3 one(0.1, 0.2, -0.1), other(-0.3, 0.0, 0.05);
  mesh.morphs = {moving(1, {3, 7, 12}, one), moving(0, {7, 8}, other)};
  complete_morph_normals(mesh);
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> share(-1.0, 2.0);
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<double> weights = {share(random), share(random)};
    const MeshShape shape = morphed_shape(mesh, weights);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      Vec3 expected = mesh.positions[v];
      if (v == 3 || v == 7 || v == 12) expected += weights[1] * one;
      if (v == 7 || v == 8) expected += weights[0] * other;
      EXPECT_LT((shape.positions[v] - expected).norm(), 1e-12) << v;
      EXPECT_NEAR(shape.normals[v].norm(), 1.0, 1e-12);
    }
  }
}

TEST(AMorphTarget, IsAppliedBeforeSkinning) {
  SkinnedMesh mesh = sheet();
  const Vec3 move(0.1, 0.2, -0.1);
  mesh.morphs = {moving(0, {6, 7}, move)};
  const JointMotions motions = some_motions();
  const std::vector<double> weights = {0.5};
  const render::Mesh skinned = morphed_and_skinned(mesh, motions, weights);
  for (const std::size_t v : {std::size_t{6}, std::size_t{7}}) {
    const double share = static_cast<double>(mesh.influences[v][1].weight);
    const Vec3 at = mesh.positions[v] + 0.5 * move;
    const Vec3 expected = (1.0 - share) * (motions[0] * at) + share * (motions[1] * at);
    EXPECT_LT((skinned.positions[v].cast<double>() - expected).norm(), 1e-6);
  }
}

TEST(AMorphTarget, TurnsNormalsAsTheSurfaceTurns) {
  SkinnedMesh mesh = sheet();
  // The whole sheet is sheared to the slope 1 along x.
  MorphTarget slope;
  for (int v = 0; v < 26; ++v) {
    slope.vertices.push_back(v);
    slope.positions.emplace_back(0.0, mesh.positions[static_cast<std::size_t>(v)].x(), 0.0);
  }
  mesh.morphs = {slope};
  complete_morph_normals(mesh);
  const MeshShape whole = morphed_shape(mesh, std::vector<double>{1.0});
  for (const Vec3& normal : whole.normals)
    EXPECT_LT((normal - Vec3(-1.0, 1.0, 0.0).normalized()).norm(), 1e-12);
}

TEST(AMorphTarget, TurnsTheNeighboursOfWhatItMovesAndBothSidesOfASeam) {
  SkinnedMesh mesh = sheet();
  mesh.morphs = {moving(0, {12, 25}, Vec3(0.0, 0.5, 0.0))};
  complete_morph_normals(mesh);
  const MorphTarget& target = mesh.morphs.front();
  // The vertices around the middle one turn though they do not move; those of the rim do not.
  EXPECT_NE(std::find(target.vertices.begin(), target.vertices.end(), 7), target.vertices.end());
  EXPECT_EQ(std::find(target.vertices.begin(), target.vertices.end(), 0), target.vertices.end());
  const MeshShape shape = morphed_shape(mesh, std::vector<double>{1.0});
  EXPECT_EQ(shape.positions[7], mesh.positions[7]);
  EXPECT_GT((shape.normals[7] - Vec3::UnitY()).norm(), 0.1);
  EXPECT_EQ(shape.normals[12], shape.normals[25]);
  EXPECT_EQ(shape.normals[0], Vec3(Vec3::UnitY()));
}

TEST(AMorphTarget, KeepsTheNormalsOfItsFile) {
  SkinnedMesh mesh = sheet();
  mesh.morphs = {moving(0, {12}, Vec3(0.0, 0.5, 0.0))};
  mesh.morphs.front().normals = {Vec3(1.0, -1.0, 0.0)};
  complete_morph_normals(mesh);
  EXPECT_EQ(mesh.morphs.front().vertices.size(), 1u);
  const MeshShape shape = morphed_shape(mesh, std::vector<double>{1.0});
  EXPECT_EQ(shape.normals[12], Vec3(Vec3::UnitX()));
}

TEST(AMorphTarget, IsValidated) {
  const auto wrong = [](const MorphTarget& target) {
    SkinnedMesh mesh = sheet();
    mesh.morphs = {target};
    EXPECT_THROW(validate(mesh, 2), std::invalid_argument);
  };
  SkinnedMesh good = sheet();
  good.morphs = {moving(0, {3, 7}, Vec3::UnitX())};
  EXPECT_NO_THROW(validate(good, 2));
  wrong(moving(0, {7, 3}, Vec3::UnitX()));
  wrong(moving(0, {26}, Vec3::UnitX()));
  wrong(moving(0, {-1}, Vec3::UnitX()));
  wrong(moving(0, {3}, Vec3(1e7, 0.0, 0.0)));
  MorphTarget few = moving(0, {3, 7}, Vec3::UnitX());
  few.positions.pop_back();
  wrong(few);
}

}  // namespace
}  // namespace mien::scenes
