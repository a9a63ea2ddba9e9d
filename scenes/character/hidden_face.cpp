#include "scenes/character/hidden_face.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "motion/error.h"

namespace mien::scenes {

namespace {

using motion::Mat3;
using motion::Vec3;

constexpr double margin = 1.02;      // of the oval's axes
constexpr double chin_share = 0.35;  // of the height of the head's joint below the crown
constexpr int meridians = 48;
constexpr int parallels = 24;

const render::Material oval_material{render::Color(0.35f, 0.35f, 0.35f), 0.03f, 0.6f};

struct Oval {
  Vec3 centre;
  Vec3 half_axes;  ///< to the left, up and to the front
  Mat3 axes;       ///< these directions
};

/// The first joint of the rig that turns with the head; −1 without one.
int head_joint(const std::vector<int>& owner) {
  const auto found = std::ranges::find(owner, static_cast<int>(motion::Head));
  return found == owner.end() ? -1 : static_cast<int>(found - owner.begin());
}

/// The vertices of triangles, each once.
std::set<std::size_t> drawn_vertices(const SkinnedMesh& mesh) {
  std::set<std::size_t> drawn;
  for (const auto& triangle : mesh.triangles)
    for (const int vertex : triangle) drawn.insert(static_cast<std::size_t>(vertex));
  return drawn;
}

/// The vertices that follow the head mainly, seen from its joint.
std::vector<Vec3> vertices_of_head(const Character& character, const std::vector<int>& owner,
                                   const Vec3& joint, const Mat3& axes) {
  std::vector<Vec3> vertices;
  for (const SkinnedMesh& mesh : character.meshes) {
    for (const std::size_t v : drawn_vertices(mesh)) {
      const auto follows = static_cast<std::size_t>(mesh.influences[v].front().joint);
      if (owner[follows] == motion::Head)
        vertices.emplace_back(axes.transpose() * (mesh.positions[v] - joint));
    }
  }
  return vertices;
}

/// Those of the face: in front of the joint and above the neck.
std::vector<Vec3> front_of(std::vector<Vec3> vertices) {
  double crown = 0.0;
  for (const Vec3& at : vertices) crown = std::max(crown, at.y());
  std::erase_if(vertices,
                [&](const Vec3& at) { return at.z() < 0.0 || at.y() < -chin_share * crown; });
  return vertices;
}

/// The smallest ellipsoid around the points with the proportions of their box.
Oval oval_around(const std::vector<Vec3>& front, const Vec3& joint, const Mat3& axes) {
  Eigen::AlignedBox3d box;
  for (const Vec3& at : front) box.extend(at);
  Vec3 centre = box.center();
  centre.z() = 0.0;
  constexpr double least_m = 0.01;
  const Vec3 half =
      Vec3(0.5 * box.sizes().x(), 0.5 * box.sizes().y(), box.max().z()).cwiseMax(least_m);
  double scale = 1.0;
  for (const Vec3& at : front) scale = std::max(scale, (at - centre).cwiseQuotient(half).norm());
  return {joint + axes * centre, margin * scale * half, axes};
}

SkinnedMesh mesh_of_oval(const Oval& oval, int joint, int material) {
  SkinnedMesh mesh;
  mesh.material = material;
  const auto add_vertex = [&](double latitude, double longitude) {
    const Vec3 direction(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                         std::cos(latitude) * std::cos(longitude));
    mesh.positions.push_back(oval.centre + oval.axes * direction.cwiseProduct(oval.half_axes));
    mesh.normals.push_back(oval.axes * direction.cwiseQuotient(oval.half_axes).normalized());
    mesh.influences.push_back({{joint, 1.0f}});
  };
  for (int row = 0; row <= parallels; ++row)
    for (int column = 0; column < meridians; ++column)
      add_vertex(motion::pi * (static_cast<double>(row) / parallels - 0.5),
                 2.0 * motion::pi * column / meridians);
  const auto vertex = [](int row, int column) { return row * meridians + column % meridians; };
  for (int row = 0; row < parallels; ++row) {
    for (int column = 0; column < meridians; ++column) {
      const int a = vertex(row, column), b = vertex(row, column + 1);
      const int c = vertex(row + 1, column + 1), d = vertex(row + 1, column);
      if (row > 0) mesh.triangles.push_back({a, b, c});
      if (row + 1 < parallels) mesh.triangles.push_back({a, c, d});
    }
  }
  mesh.triangle_parts.assign(mesh.triangles.size(), motion::Head);
  return mesh;
}

}  // namespace

Character with_hidden_face(Character character) {
  const std::vector<int> owner = body_joint_of(character);
  const int joint = head_joint(owner);
  const Mat3 axes = character.bind_rotations[motion::Head].toRotationMatrix();
  const Vec3 place = joint < 0
                         ? Vec3(Vec3::Zero())
                         : rig_bind_pose(character).positions[static_cast<std::size_t>(joint)];
  const std::vector<Vec3> front = front_of(vertices_of_head(character, owner, place, axes));
  if (joint < 0 || front.empty())
    throw Error({character.name},
                "no part of its mesh in front follows the head, so there is no "
                "face to hide",
                "omit face: hidden");
  SkinnedMesh oval = mesh_of_oval(oval_around(front, place, axes), joint,
                                  static_cast<int>(character.materials.size()));
  cluster_triangles(oval);
  character.materials.push_back(oval_material);
  character.meshes.push_back(std::move(oval));
  return character;
}

}  // namespace mien::scenes
