#include "scenes/skinning/morph_target.h"

#include <algorithm>
#include <array>
#include <map>

#include "scenes/skinning/skinned_model.h"

namespace mien::scenes {

namespace {

using motion::Vec3;

double weight_of(const MorphTarget& target, std::span<const double> weights) {
  const auto morph = static_cast<std::size_t>(target.morph);
  return morph < weights.size() ? weights[morph] : 0.0;
}

/// For each vertex, the first one at its place with its normal.
std::vector<int> first_alike(const SkinnedMesh& mesh) {
  std::map<std::array<double, 6>, int> first;
  std::vector<int> alike;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& at = mesh.positions[v];
    const Vec3& normal = mesh.normals[v];
    const std::array<double, 6> key = {at.x(), at.y(), at.z(), normal.x(), normal.y(), normal.z()};
    alike.push_back(first.try_emplace(key, static_cast<int>(v)).first->second);
  }
  return alike;
}

/// The area-weighted means of the triangles' normals at these positions, unit; vertices that are
/// alike have the same.
std::vector<Vec3> smooth_normals(const SkinnedMesh& mesh, const std::vector<int>& alike,
                                 const std::vector<Vec3>& positions) {
  std::vector<Vec3> normals(positions.size(), Vec3::Zero());
  for (const auto& corners : mesh.triangles) {
    const auto at = [&](std::size_t k) { return positions[static_cast<std::size_t>(corners[k])]; };
    const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0));
    for (const int corner : corners)
      normals[static_cast<std::size_t>(alike[static_cast<std::size_t>(corner)])] += normal;
  }
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const auto first = static_cast<std::size_t>(alike[v]);
    if (first < v) {
      normals[v] = normals[first];
    } else if (const double length = normals[v].norm(); length > 1e-30) {
      normals[v] /= length;
    }
  }
  return normals;
}

/// The target with its normals, also of vertices that it does not move but turns.
MorphTarget completed(const SkinnedMesh& mesh, const std::vector<int>& alike,
                      const std::vector<Vec3>& before, const MorphTarget& target) {
  std::vector<Vec3> moves(mesh.positions.size(), Vec3::Zero());
  std::vector<Vec3> positions = mesh.positions;
  for (std::size_t i = 0; i < target.vertices.size(); ++i) {
    const auto vertex = static_cast<std::size_t>(target.vertices[i]);
    moves[vertex] = target.positions[i];
    positions[vertex] += target.positions[i];
  }
  const std::vector<Vec3> after = smooth_normals(mesh, alike, positions);
  MorphTarget whole;
  whole.morph = target.morph;
  for (std::size_t v = 0; v < moves.size(); ++v) {
    const Vec3 turn = after[v] - before[v];
    if (moves[v] == Vec3::Zero() && turn == Vec3::Zero()) continue;
    whole.vertices.push_back(static_cast<int>(v));
    whole.positions.push_back(moves[v]);
    whole.normals.push_back(turn);
  }
  return whole;
}

}  // namespace

bool is_morphed(const SkinnedMesh& mesh, std::span<const double> weights) {
  return std::ranges::any_of(
      mesh.morphs, [&](const MorphTarget& target) { return weight_of(target, weights) != 0.0; });
}

MeshShape morphed_shape(const SkinnedMesh& mesh, std::span<const double> weights) {
  MeshShape shape{mesh.positions, mesh.normals};
  std::vector<bool> turned(mesh.positions.size(), false);
  for (const MorphTarget& target : mesh.morphs) {
    const double weight = weight_of(target, weights);
    if (weight == 0.0) continue;
    for (std::size_t i = 0; i < target.vertices.size(); ++i) {
      const auto vertex = static_cast<std::size_t>(target.vertices[i]);
      shape.positions[vertex] += weight * target.positions[i];
      if (target.normals.empty()) continue;
      shape.normals[vertex] += weight * target.normals[i];
      turned[vertex] = true;
    }
  }
  for (std::size_t v = 0; v < turned.size(); ++v) {
    if (!turned[v]) continue;
    const double length = shape.normals[v].norm();
    shape.normals[v] = length > 1e-9 ? Vec3(shape.normals[v] / length) : mesh.normals[v];
  }
  return shape;
}

void complete_morph_normals(SkinnedMesh& mesh) {
  const auto lacks = [](const MorphTarget& target) { return target.normals.empty(); };
  if (std::ranges::none_of(mesh.morphs, lacks)) return;
  const std::vector<int> alike = first_alike(mesh);
  const std::vector<Vec3> before = smooth_normals(mesh, alike, mesh.positions);
  for (MorphTarget& target : mesh.morphs)
    if (lacks(target)) target = completed(mesh, alike, before, target);
}

}  // namespace mien::scenes
