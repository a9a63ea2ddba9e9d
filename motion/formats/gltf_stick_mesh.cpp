#include "motion/formats/gltf_stick_mesh.h"

namespace mien::motion {

namespace {

void add_bone(const Vec3& head, const Vec3& bone, int joint, StickMesh& mesh) {
  const double length = bone.norm();
  if (!(length > 1e-9)) return;
  const Vec3 along = bone / length;
  const Vec3 u = along.unitOrthogonal();
  const Vec3 v = along.cross(u);
  const Vec3 middle = head + 0.15 * bone;
  const double radius = 0.08 * length;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vec3& position :
       {head, Vec3(head + bone), Vec3(middle + radius * u), Vec3(middle + radius * v),
        Vec3(middle - radius * u), Vec3(middle - radius * v)}) {
    mesh.positions.push_back(position);
    mesh.joints.push_back(joint);
  }
  for (std::uint32_t side = 0; side < 4; ++side) {
    const std::uint32_t one = first + 2 + side;
    const std::uint32_t next = first + 2 + (side + 1) % 4;
    mesh.triangles.push_back({first + 1, one, next});
    mesh.triangles.push_back({first, next, one});
  }
}

}  // namespace

std::vector<Vec3> bind_positions(const Skeleton& skeleton) {
  std::vector<Vec3> positions;
  positions.reserve(skeleton.joints.size());
  for (const Joint& joint : skeleton.joints) {
    const bool is_root = joint.parent < 0;
    positions.push_back(is_root ? joint.offset
                                : positions[static_cast<size_t>(joint.parent)] + joint.offset);
  }
  return positions;
}

StickMesh stick_mesh(const Skeleton& skeleton) {
  const std::vector<Vec3> positions = bind_positions(skeleton);
  StickMesh mesh;
  for (int j = 0; j < skeleton.size(); ++j) {
    const Joint& joint = skeleton.joints[static_cast<size_t>(j)];
    if (joint.parent >= 0) {
      add_bone(positions[static_cast<size_t>(joint.parent)], joint.offset, joint.parent, mesh);
    }
    if (joint.tip) add_bone(positions[static_cast<size_t>(j)], *joint.tip, j, mesh);
  }
  if (mesh.positions.empty()) add_bone(positions.front(), {0.0, 0.1, 0.0}, 0, mesh);
  return mesh;
}

}  // namespace mien::motion
