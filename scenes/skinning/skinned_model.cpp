#include "scenes/skinning/skinned_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

namespace mien::scenes {

namespace {

using motion::Mat3;
using motion::Quat;
using motion::Vec3;

/// Everything of the mesh that does not move.
render::Mesh unmoved(const SkinnedMesh& mesh) {
  render::Mesh result;
  result.positions.resize(mesh.positions.size());
  result.normals.resize(mesh.normals.size());
  result.uv = mesh.uv;
  result.triangles = mesh.triangles;
  result.triangle_parts = mesh.triangle_parts;
  result.material = mesh.material;
  return result;
}

Mat3 cofactors(const Mat3& m) {
  Mat3 result;
  result.col(0) = m.col(1).cross(m.col(2));
  result.col(1) = m.col(2).cross(m.col(0));
  result.col(2) = m.col(0).cross(m.col(1));
  return result;
}

/// A matrix that flattens everything leaves the normal as it was.
Vec3 turned_normal(const Mat3& linear, const Vec3& normal) {
  const Vec3 turned = cofactors(linear) * normal;
  const double length = turned.norm();
  return length > 1e-20 ? Vec3(turned / length) : normal;
}

/// Halves the triangles of a range across the longest side of the box around their centres, to the
/// last eight: the tracer bounds so many together.
void cluster(const std::vector<Vec3>& centres, std::vector<int>::iterator first,
             std::vector<int>::iterator last) {
  constexpr std::ptrdiff_t together = 8;
  const std::ptrdiff_t count = last - first;
  if (count <= together) return std::sort(first, last);  // whatever nth_element left
  const auto centre = [&](int triangle) -> const Vec3& {
    return centres[static_cast<size_t>(triangle)];
  };
  Eigen::AlignedBox3d box;
  for (auto it = first; it != last; ++it) box.extend(centre(*it));
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const auto middle = first + (count / 2 + together - 1) / together * together;
  std::nth_element(first, middle, last, [&](int a, int b) {
    const double x = centre(a)[axis], y = centre(b)[axis];
    return x < y || (x == y && a < b);
  });
  cluster(centres, first, middle);
  cluster(centres, middle, last);
}

/// Linear blend skinning of vertices of the mesh.
render::Mesh blended(const SkinnedMesh& mesh, const JointMotions& motions,
                     const std::vector<Vec3>& positions, const std::vector<Vec3>& normals) {
  render::Mesh result = unmoved(mesh);
  for (size_t v = 0; v < positions.size(); ++v) {
    Eigen::Matrix<double, 3, 4> blend = Eigen::Matrix<double, 3, 4>::Zero();
    for (const Influence& influence : mesh.influences[v]) {
      blend += static_cast<double>(influence.weight) *
               motions[static_cast<size_t>(influence.joint)].matrix().topRows<3>();
    }
    const Mat3 linear = blend.leftCols<3>();
    result.positions[v] = (linear * positions[v] + blend.col(3)).cast<float>();
    result.normals[v] = turned_normal(linear, normals[v]).cast<float>();
  }
  return result;
}

void require(bool holds, const char* wrong) {
  if (!holds) throw std::invalid_argument(wrong);
}

void validate_morphs(const SkinnedMesh& mesh) {
  for (const MorphTarget& target : mesh.morphs) {
    const size_t count = target.vertices.size();
    require(target.positions.size() == count, "morphs: one position per vertex is needed");
    require(target.normals.empty() || target.normals.size() == count,
            "morphs: one normal per vertex is needed");
    for (size_t i = 0; i < count; ++i) {
      const int vertex = target.vertices[i];
      require(vertex >= 0 && static_cast<size_t>(vertex) < mesh.positions.size(),
              "morphs: there is no such vertex");
      require(i == 0 || target.vertices[i - 1] < vertex, "morphs: vertices are not in order");
      require(target.positions[i].allFinite() && target.positions[i].cwiseAbs().maxCoeff() < 1e6,
              "morphs: a number is not finite or too large");
      require(target.normals.empty() || target.normals[i].cwiseAbs().maxCoeff() < 1e6,
              "morphs: a normal is not finite or too large");
    }
  }
}

}  // namespace

DualQuaternion dual_quaternion(const Quat& rotation, const Vec3& translation) {
  const Quat moved = Quat(0.0, translation.x(), translation.y(), translation.z()) * rotation;
  return {rotation.coeffs(), 0.5 * moved.coeffs()};
}

DualQuaternion normalized(const DualQuaternion& sum) {
  const double norm = sum.real.norm();
  const Eigen::Vector4d real = sum.real / norm;
  const Eigen::Vector4d dual = sum.dual / norm;
  return {real, dual - real.dot(dual) * real};
}

Quat rotation_of(const DualQuaternion& rigid) { return Quat(rigid.real); }

Vec3 translation_of(const DualQuaternion& rigid) {
  return 2.0 * (Quat(rigid.dual) * Quat(rigid.real).conjugate()).vec();
}

JointMotions joint_motions(const motion::JointTransforms& bind,
                           const motion::JointTransforms& now) {
  JointMotions motions;
  motions.reserve(bind.positions.size());
  for (size_t j = 0; j < bind.positions.size(); ++j) {
    const Quat turn = now.rotations[j] * bind.rotations[j].conjugate();
    motions.push_back(Eigen::Translation3d(now.positions[j]) * turn *
                      Eigen::Translation3d(-bind.positions[j]));
  }
  return motions;
}

render::Mesh linear_blend_skinned(const SkinnedMesh& mesh, const JointMotions& motions) {
  return blended(mesh, motions, mesh.positions, mesh.normals);
}

render::Mesh morphed_and_skinned(const SkinnedMesh& mesh, const JointMotions& motions,
                                 std::span<const double> weights) {
  if (!is_morphed(mesh, weights)) return linear_blend_skinned(mesh, motions);
  const MeshShape shape = morphed_shape(mesh, weights);
  return blended(mesh, motions, shape.positions, shape.normals);
}

render::Mesh dual_quaternion_skinned(const SkinnedMesh& mesh, const JointMotions& motions) {
  std::vector<DualQuaternion> rigid;
  rigid.reserve(motions.size());
  for (const Eigen::Affine3d& motion : motions) {
    rigid.push_back(
        dual_quaternion(Quat(Mat3(motion.linear())).normalized(), motion.translation()));
  }
  render::Mesh result = unmoved(mesh);
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    const std::vector<Influence>& influences = mesh.influences[v];
    const DualQuaternion& first = rigid[static_cast<size_t>(influences.front().joint)];
    DualQuaternion sum{Eigen::Vector4d::Zero(), Eigen::Vector4d::Zero()};
    for (const Influence& influence : influences) {
      const DualQuaternion& joint = rigid[static_cast<size_t>(influence.joint)];
      const double side = joint.real.dot(first.real) < 0.0 ? -1.0 : 1.0;
      sum.real += side * static_cast<double>(influence.weight) * joint.real;
      sum.dual += side * static_cast<double>(influence.weight) * joint.dual;
    }
    const DualQuaternion blend = normalized(sum);
    const Quat rotation = rotation_of(blend);
    result.positions[v] = (rotation * mesh.positions[v] + translation_of(blend)).cast<float>();
    result.normals[v] = (rotation * mesh.normals[v]).cast<float>();
  }
  return result;
}

void normalize(std::vector<Influence>& influences) {
  std::stable_sort(influences.begin(), influences.end(),
                   [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
  if (influences.size() > max_influences) influences.resize(max_influences);
  const float least = 1e-3f * influences.front().weight;
  std::erase_if(influences, [&](const Influence& i) { return !(i.weight > least); });
  float sum = 0.0f;
  for (const Influence& influence : influences) sum += influence.weight;
  for (Influence& influence : influences) influence.weight /= sum;
}

void cluster_triangles(SkinnedMesh& mesh) {
  std::vector<Vec3> centres;
  for (const auto& [a, b, c] : mesh.triangles)
    centres.push_back((mesh.positions[static_cast<size_t>(a)] +
                       mesh.positions[static_cast<size_t>(b)] +
                       mesh.positions[static_cast<size_t>(c)]) /
                      3.0);
  std::vector<int> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  cluster(centres, order.begin(), order.end());
  const auto reorder = [&](auto& list) {
    auto ordered = list;
    for (size_t i = 0; i < order.size(); ++i) ordered[i] = list[static_cast<size_t>(order[i])];
    list = std::move(ordered);
  };
  reorder(mesh.triangles);
  if (!mesh.triangle_parts.empty()) reorder(mesh.triangle_parts);
}

void validate(const SkinnedMesh& mesh, int joint_count) {
  const size_t count = mesh.positions.size();
  require(mesh.normals.size() == count, "normals: one per vertex is needed");
  require(mesh.uv.empty() || mesh.uv.size() == count, "uv: one per vertex is needed");
  require(mesh.influences.size() == count, "influences: one list per vertex is needed");
  require(mesh.triangle_parts.empty() || mesh.triangle_parts.size() == mesh.triangles.size(),
          "triangle_parts: one per triangle is needed");
  for (size_t v = 0; v < count; ++v) {
    require(mesh.positions[v].allFinite() && mesh.positions[v].cwiseAbs().maxCoeff() < 1e6,
            "positions: a number is not finite or too large");
    require(mesh.uv.empty() || (std::abs(mesh.uv[v][0]) < 1e6f && std::abs(mesh.uv[v][1]) < 1e6f),
            "uv: a number is too large");
    require(std::abs(mesh.normals[v].norm() - 1.0) < 1e-3, "normals: not of unit length");
    const std::vector<Influence>& influences = mesh.influences[v];
    require(!influences.empty() && influences.size() <= max_influences,
            "influences: a vertex has none or more than eight");
    float sum = 0.0f;
    for (const Influence& influence : influences) {
      require(influence.joint >= 0 && influence.joint < joint_count,
              "influences: there is no such joint");
      require(influence.weight >= 0.0f, "influences: a weight is negative");
      sum += influence.weight;
    }
    require(std::abs(sum - 1.0f) < 1e-4f, "influences: weights do not sum to 1");
  }
  validate_morphs(mesh);
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    for (const int vertex : triangle) {
      require(vertex >= 0 && static_cast<size_t>(vertex) < count,
              "triangles: there is no such vertex");
    }
  }
}

}  // namespace mien::scenes
