#include "scenes/face/hidden_face.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "motion/error.h"
#include "scenes/face/front_of_head.h"

namespace mien::scenes {

namespace {

using motion::Mat3;
using motion::Vec3;

constexpr double margin = 1.04;    // of the oval's axes
constexpr double flattest = 0.15;  // its least half-axis to the front, of that to the side
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

/// The triangles of which all corners follow the head mainly.
HeadTriangles triangles_of_head(const Character& character, const std::vector<int>& owner,
                                const Vec3& joint, const Mat3& axes) {
  HeadTriangles head;
  for (const SkinnedMesh& mesh : character.meshes) {
    const auto follows_head = [&](int vertex) {
      const int mainly = mesh.influences[static_cast<std::size_t>(vertex)].front().joint;
      return owner[static_cast<std::size_t>(mainly)] == motion::Head;
    };
    const auto place = [&](int vertex) -> Vec3 {
      return axes.transpose() * (mesh.positions[static_cast<std::size_t>(vertex)] - joint);
    };
    for (const auto& [a, b, c] : mesh.triangles)
      if (follows_head(a) && follows_head(b) && follows_head(c))
        head.push_back({place(a), place(b), place(c)});
  }
  return head;
}

/// Where an ellipsoid of one depth reaches all points: its centre and its half-axis to the front.
struct Depth {
  double centre, half;
};

/// The smallest |z − centre| / reach of all points is convex in the centre, so that a
/// golden-section search finds it. `reaches` are the shares of the half-axis that the ellipsoid has
/// at each point.
Depth least_depth(const std::vector<Vec3>& points, const std::vector<double>& reaches) {
  const auto half_at = [&](double centre) {
    double half = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
      half = std::max(half, std::abs(points[i].z() - centre) / reaches[i]);
    return half;
  };
  const auto [back, front] =
      std::ranges::minmax_element(points, {}, [](auto& at) { return at.z(); });
  double low = back->z(), high = front->z();
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  while (high - low > 1e-6) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (half_at(a) <= half_at(b) ? high : low) = half_at(a) <= half_at(b) ? b : a;
  }
  const double centre = 0.5 * (low + high);
  return {centre, half_at(centre)};
}

/// The ellipsoid around the face whose outline from the front is that of the head.
Oval oval_around(const FrontOfHead& front, const Vec3& joint, const Mat3& axes) {
  constexpr double least_m = 0.01;
  const Eigen::Vector2d middle = front.outline.center();
  const Eigen::Vector2d half = margin * (0.5 * front.outline.sizes()).cwiseMax(least_m);
  std::vector<double> reaches;
  for (const Vec3& at : front.face) {
    const Eigen::Vector2d place = (Eigen::Vector2d(at.head<2>()) - middle).cwiseQuotient(half);
    reaches.push_back(std::sqrt(1.0 - place.squaredNorm()));
  }
  const Depth depth = least_depth(front.face, reaches);
  const double thick = std::max(margin * depth.half, flattest * half.minCoeff());
  return {joint + axes * Vec3(middle.x(), middle.y(), depth.centre),
          Vec3(half.x(), half.y(), thick), axes};
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
  const FrontOfHead front = front_of_head(triangles_of_head(character, owner, place, axes));
  if (joint < 0 || front.face.empty())
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
