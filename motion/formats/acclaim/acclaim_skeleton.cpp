#include "motion/formats/acclaim/acclaim_skeleton.h"

#include "motion/formats/acclaim/asf_file.h"

namespace mien::motion {

namespace {

Quat rotation_of(const AsfAxis& axis, double radians_per_unit) {
  Quat rotation = Quat::Identity();
  for (const char letter : axis.order) {
    const int i = (letter | 0x20) - 'x';
    rotation = Quat(Eigen::AngleAxisd(axis.angles[i] * radians_per_unit, Vec3::Unit(i))) * rotation;
  }
  return rotation.normalized();
}

/// The files of the CMU database hold inches divided by their unit of length; a file with unit 1
/// does not say what its lengths are.
double metres_per_unit(const AsfFile& file) {
  return file.length_unit == 1.0 ? 1.0 : 0.0254 / file.length_unit;
}

/// From the bone's start to its end, in the file's unit.
Vec3 bone_vector(const AsfBone& bone) {
  if (!bone.length || *bone.length == 0.0) return Vec3::Zero();
  return bone.direction->normalized() * *bone.length;
}

Joint joint_of(const AsfFile& file, const AsfBone& bone, int parent) {
  const double metres = metres_per_unit(file);
  Joint joint;
  joint.name = bone.name;
  joint.parent = parent;
  joint.offset = bone.parent < 0
                     ? Vec3(metres * file.root_position)
                     : Vec3(metres * bone_vector(file.bones[static_cast<size_t>(bone.parent)]));
  if (bone.children.empty() && bone.length) joint.tip = metres * bone_vector(bone);
  return joint;
}

void require_all_reached(const TextCursor& cursor, const AsfFile& file,
                         const std::vector<bool>& reached) {
  for (size_t b = 0; b < file.bones.size(); ++b) {
    if (reached[b]) continue;
    fail(cursor, file.bones[b].place,
         "bone " + in_quotes(file.bones[b].name) + " is not connected to the root",
         "list it in :hierarchy after its parent");
  }
}

}  // namespace

AcclaimSkeleton parse_asf(std::string_view text, const std::string& file_name) {
  TextCursor cursor = start_of(text, file_name);
  const AsfFile file = parse_asf_file(cursor);
  AcclaimSkeleton built;
  built.metres_per_unit = metres_per_unit(file);
  built.radians_per_unit = file.radians_per_unit;
  struct Waiting {
    int bone = 0;
    int parent = -1;
  };
  std::vector<Waiting> waiting = {{0, -1}};
  std::vector<bool> reached(file.bones.size(), false);
  while (!waiting.empty()) {
    const Waiting next = waiting.back();
    waiting.pop_back();
    const AsfBone& bone = file.bones[static_cast<size_t>(next.bone)];
    reached[static_cast<size_t>(next.bone)] = true;
    const int joint = built.skeleton.size();
    built.skeleton.joints.push_back(joint_of(file, bone, next.parent));
    built.bones.push_back({rotation_of(*bone.axis, file.radians_per_unit), bone.freedoms});
    for (auto child = bone.children.rbegin(); child != bone.children.rend(); ++child) {
      waiting.push_back({*child, joint});
    }
  }
  require_all_reached(cursor, file, reached);
  return built;
}

}  // namespace mien::motion
