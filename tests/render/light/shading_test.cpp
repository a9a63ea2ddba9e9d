// What is known of a point of a surface.

#include "render/light/shading.h"

#include <gtest/gtest.h>

namespace mien::render {
namespace {

/// A square of two triangles before a camera on +z: u goes right or, mirrored, left; v goes down.
struct Square {
  Texture map;
  Scene scene;

  explicit Square(const Vec3& bend, bool mirrored = false) {
    map = {1, 1, {0.5f * (bend.array() + 1.0f)}};
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.normals.assign(4, Vec3::UnitZ());
    for (const Vec3& p : mesh.positions)
      mesh.uv.push_back({mirrored ? 1.0f - p.x() : p.x(), 1.0f - p.y()});
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.textures = {&map};
    scene.materials = {{.normal_map = 0}};
    scene.solids.meshes = {mesh};
  }

  Vec3 normal(int triangle, const Vec3& direction) const {
    return surface_at(scene, scene.solids, nullptr, figure_shapes(scene), triangle,
                      {0.5f, 0.5f, 0.0f}, direction, 0.0f)
        .normal;
  }
};

const Vec3 onto_front = -Vec3::UnitZ();
const Vec3 onto_back = Vec3::UnitZ();

TEST(NormalMap, TurnsTheNormalAlongGrowingUAndFallingV) {
  for (const int triangle : {0, 1}) {
    for (const bool mirrored : {false, true}) {
      const float right = mirrored ? -1.0f : 1.0f;
      const Vec3 sideways = Square({0.6f, 0.0f, 0.8f}, mirrored).normal(triangle, onto_front);
      EXPECT_LT((sideways - Vec3(0.6f * right, 0.0f, 0.8f)).norm(), 1e-5f);
      const Vec3 upwards = Square({0.0f, 0.6f, 0.8f}, mirrored).normal(triangle, onto_front);
      EXPECT_LT((upwards - Vec3(0.0f, 0.6f, 0.8f)).norm(), 1e-5f);
    }
  }
}

TEST(NormalMap, BendsTheBackAsTheFront) {
  const Vec3 seen = Square({0.6f, 0.0f, 0.8f}).normal(0, onto_back);
  EXPECT_LT((seen + Vec3(0.6f, 0.0f, 0.8f)).norm(), 1e-5f);
}

TEST(NormalMap, LeavesTheSurfaceAloneWhereItIsFlatOrSaysNothing) {
  EXPECT_LT((Square({0.0f, 0.0f, 1.0f}).normal(0, onto_front) - Vec3::UnitZ()).norm(), 1e-6f);
  EXPECT_LT((Square({0.0f, 0.0f, 0.0f}).normal(0, onto_front) - Vec3::UnitZ()).norm(), 1e-6f);
  Square nowhere({0.6f, 0.0f, 0.8f});
  nowhere.scene.solids.meshes[0].uv.assign(4, {0.3f, 0.3f});
  EXPECT_LT((nowhere.normal(0, onto_front) - Vec3::UnitZ()).norm(), 1e-6f);
}

TEST(NormalMap, NeverTurnsTheNormalAwayFromTheEye) {
  const Vec3 grazing = Vec3(1.0f, 0.0f, -0.05f).normalized();
  const Vec3 normal = Square({0.99f, 0.0f, 0.14f}).normal(0, grazing);
  EXPECT_GT(normal.dot(-grazing), 0.0f);
  EXPECT_NEAR(normal.norm(), 1.0f, 1e-5f);
}

}  // namespace
}  // namespace mien::render
