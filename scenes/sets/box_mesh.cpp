#include "scenes/sets/box_mesh.h"

namespace mien::scenes {

render::Mesh box_mesh(const Box& box, const Place& place, int material) {
  render::Mesh mesh;
  mesh.material = material;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const motion::Vec3 normal = side * motion::Vec3::Unit(axis);
      const motion::Vec3 u = motion::Vec3::Unit((axis + 1) % 3);
      const motion::Vec3 v = normal.cross(u);
      const auto first = static_cast<int>(mesh.positions.size());
      for (const auto& [a, b] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
        const motion::Vec3 corner = normal + a * u + b * v;
        const motion::Vec3 point = box.centre + 0.5 * box.size.cwiseProduct(corner);
        mesh.positions.push_back(place.at(point).cast<float>());
        mesh.normals.push_back((place.at(normal) - place.centre).cast<float>());
      }
      mesh.triangles.push_back({first, first + 1, first + 2});
      mesh.triangles.push_back({first, first + 2, first + 3});
    }
  }
  return mesh;
}

}  // namespace mien::scenes
