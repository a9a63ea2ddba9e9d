#include "scenes/character/placed_mesh.h"

#include <utility>

namespace mien::scenes {

namespace {

using motion::Mat3;
using motion::Vec3;

/// Area-weighted means of the triangles' normals.
std::vector<Vec3> normals_of(const SkinnedMesh& mesh) {
  std::vector<Vec3> normals(mesh.positions.size(), Vec3::Zero());
  for (const auto& t : mesh.triangles) {
    const auto at = [&](size_t k) { return mesh.positions[static_cast<size_t>(t[k])]; };
    const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0));
    for (const int vertex : t) normals[static_cast<size_t>(vertex)] += normal;
  }
  return normals;
}

Vec3 turned(const Mat3& linear, const Vec3& normal) {
  Mat3 cofactors;
  cofactors.col(0) = linear.col(1).cross(linear.col(2));
  cofactors.col(1) = linear.col(2).cross(linear.col(0));
  cofactors.col(2) = linear.col(0).cross(linear.col(1));
  return cofactors * normal;
}

void make_unit(std::vector<Vec3>& normals) {
  for (Vec3& normal : normals) {
    const double length = normal.norm();
    normal = length > 1e-30 ? Vec3(normal / length) : Vec3::UnitY();
  }
}

/// Changes of normals become relative to the unit normals that `make_unit` will leave.
void scale_morph_normals(SkinnedMesh& mesh) {
  for (MorphTarget& target : mesh.morphs) {
    for (size_t i = 0; i < target.normals.size(); ++i) {
      const double length = mesh.normals[static_cast<size_t>(target.vertices[i])].norm();
      target.normals[i] = length > 1e-30 ? Vec3(target.normals[i] / length) : Vec3::Zero();
    }
  }
}

/// Moves morph targets with the linear part of each vertex's transform.
void place_morphs(const std::vector<Mat3>& linear, SkinnedMesh& mesh) {
  for (MorphTarget& target : mesh.morphs) {
    for (size_t i = 0; i < target.vertices.size(); ++i) {
      const Mat3& of_vertex = linear[static_cast<size_t>(target.vertices[i])];
      target.positions[i] = of_vertex * target.positions[i];
      if (!target.normals.empty()) target.normals[i] = turned(of_vertex, target.normals[i]);
    }
  }
}

}  // namespace

void place_mesh(const BindPoseRig& rig, const std::vector<int>& skin_joints,
                const std::vector<Eigen::Affine3d>& to_world, SkinnedMesh& mesh) {
  std::vector<Mat3> of_vertices;
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    Eigen::Matrix<double, 3, 4> blend = Eigen::Matrix<double, 3, 4>::Zero();
    for (Influence& influence : mesh.influences[v]) {
      const auto joint = static_cast<size_t>(influence.joint);
      blend += static_cast<double>(influence.weight) * to_world[joint].matrix().topRows<3>();
      influence.joint = rig.joint_of_node[static_cast<size_t>(skin_joints[joint])];
    }
    const Mat3 linear = blend.leftCols<3>();
    mesh.positions[v] = linear * mesh.positions[v] + blend.col(3);
    if (!mesh.normals.empty()) mesh.normals[v] = turned(linear, mesh.normals[v]);
    if (!mesh.morphs.empty()) of_vertices.push_back(linear);
  }
  place_morphs(of_vertices, mesh);
  if (to_world.front().linear().determinant() >= 0.0) return;
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  for (Vec3& normal : mesh.normals) normal = -normal;
  for (MorphTarget& target : mesh.morphs)
    for (Vec3& normal : target.normals) normal = -normal;
}

void complete_normals(SkinnedMesh& mesh) {
  if (mesh.normals.empty()) {
    mesh.normals = normals_of(mesh);
    for (MorphTarget& target : mesh.morphs) target.normals.clear();
  }
  scale_morph_normals(mesh);
  make_unit(mesh.normals);
  complete_morph_normals(mesh);
}

}  // namespace mien::scenes
