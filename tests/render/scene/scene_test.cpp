#include "render/scene/scene.h"

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

Scene scene_with_mesh() {
  Scene scene;
  scene.materials.emplace_back();
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.normals.assign(4, Vec3::UnitY());
  mesh.uv.assign(4, {0.5f, 0.5f});
  mesh.triangles = {{0, 1, 2}, {1, 2, 3}};
  mesh.triangle_parts = {0, 0};
  scene.solids.meshes.push_back(mesh);
  return scene;
}

TEST(Scene, OfAFaultyMeshIsRefusedByTheNameOfItsMember) {
  EXPECT_NO_THROW(validate(scene_with_mesh()));
  const float none = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  const struct {
    std::function<void(Mesh&)> damage;
    std::string message;
  } faults[] = {
      {[&](Mesh& mesh) { mesh.positions[3].z() = none; }, "positions: not finite"},
      {[&](Mesh& mesh) { mesh.positions[0].x() = -infinite; }, "positions: not finite"},
      {[&](Mesh& mesh) { mesh.normals[2].y() = infinite; }, "normals: not finite"},
      {[](Mesh& mesh) { mesh.normals.pop_back(); }, "normals: not one per vertex"},
      {[&](Mesh& mesh) { mesh.uv[1][1] = none; }, "uv: not within ±1e6"},
      {[](Mesh& mesh) { mesh.triangles[1][2] = 4; }, "triangles: a vertex is out of range"},
      {[](Mesh& mesh) { mesh.triangles[0][0] = -1; }, "triangles: a vertex is out of range"},
      {[](Mesh& mesh) { mesh.triangle_parts[1] = 1; }, "triangle_parts: out of range"},
      {[](Mesh& mesh) { mesh.material = 1; }, "material: out of range"}};
  for (const auto& [damage, message] : faults) {
    Scene scene = scene_with_mesh();
    damage(scene.solids.meshes[0]);
    try {
      validate(scene);
      ADD_FAILURE() << message;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), "meshes[0]." + message);
    }
  }
}

}  // namespace
}  // namespace mien::render
