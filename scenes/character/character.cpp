#include "scenes/character/character.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <stdexcept>
#include <utility>

#include "motion/error.h"
#include "motion/rig/joint_word.h"
#include "motion/rig/proportions.h"
#include "motion/rig/retarget.h"
#include "motion/rig/rig_motion.h"
#include "motion/skeleton/sole.h"
#include "motion/text/compressed_file.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"
#include "scenes/character/character_file.h"
#include "scenes/character/character_parts.h"
#include "scenes/character/face_joints.h"
#include "scenes/character/fbx_character.h"
#include "scenes/character/gltf_morphs.h"
#include "scenes/character/leaf_twist.h"

namespace mien::scenes {

namespace {

using motion::BodyJoint;
using motion::Quat;
using motion::Vec3;

constexpr double assumed_extent = 1.7;  // metres: of the joints, while the figure is recognised

/// The bind pose as a motion of one frame.
motion::Recording bind_recording(const CharacterParts& parts) {
  motion::Recording recording;
  recording.name = parts.file;
  recording.format = "bind pose";  // in which no format promises metres or an up axis
  recording.skeleton = parts.rig;
  motion::Pose pose;
  pose.root_position = parts.rig.joints.front().offset;
  pose.rotations.assign(parts.rig.joints.size(), Quat::Identity());
  recording.poses = {pose};
  return recording;
}

/// Longest side of the box round all joints.
double extent_of(const motion::Skeleton& rig) {
  Eigen::AlignedBox3d box;
  for (const Vec3& position : motion::zero_pose(rig).positions) box.extend(position);
  return box.sizes().maxCoeff();
}

/// Turns and scales everything that has a place.
void transform(Character& character, const Quat& turn, double scale) {
  for (motion::Joint& joint : character.rig.joints) joint.offset = scale * (turn * joint.offset);
  for (SkinnedMesh& mesh : character.meshes) {
    for (Vec3& position : mesh.positions) position = scale * (turn * position);
    for (Vec3& normal : mesh.normals) normal = turn * normal;
    for (MorphTarget& target : mesh.morphs) {
      for (Vec3& move : target.positions) move = scale * (turn * move);
      for (Vec3& normal : target.normals) normal = turn * normal;
    }
  }
}

/// Whether the toes point backwards by which hip is called left.
bool toes_point_backwards(const motion::Recording& recording, const motion::BodyMapping& mapping) {
  const motion::RigMotion rig = motion::rig_motion(recording, mapping.joints, mapping.to_y_up);
  const auto at = [&](BodyJoint joint) { return rig.point(rig.frames.front(), joint); };
  if (!rig.has(motion::LeftToe) || !rig.has(motion::RightToe)) return false;
  const Vec3 forward = (at(motion::LeftHip) - at(motion::RightHip)).cross(Vec3::UnitY());
  const Vec3 toes =
      at(motion::LeftToe) - at(motion::LeftAnkle) + at(motion::RightToe) - at(motion::RightAnkle);
  return toes.dot(forward) < 0.0;
}

/// The joints with the sides of their names exchanged.
motion::Recording with_other_sides(motion::Recording recording) {
  using Side = motion::JointWord::Side;
  for (motion::Joint& joint : recording.skeleton.joints) {
    const motion::JointWord word = motion::joint_word(joint.name);
    if (word.side == Side::middle) continue;
    joint.name = (word.side == Side::left ? "Right_" : "Left_") + word.word;
  }
  return recording;
}

/// In the mirror image of a figure the joints called left are those of its right side.
motion::BodyMapping recognised(const motion::Recording& recording, bool is_mirrored,
                               const std::string& name) {
  try {
    motion::BodyMapping mapping = motion::recognise(recording);
    if (!is_mirrored || !toes_point_backwards(recording, mapping)) return mapping;
    return motion::recognise(with_other_sides(recording));
  } catch (const Error&) {
    throw Error(
        {name},
        "its " + std::to_string(recording.skeleton.size()) +
            " joints are not recognised as a human figure",
        "use the joint names of Mixamo, VRM or Rigify (LeftUpLeg, LeftLeg, LeftFoot, LeftArm, …)");
  }
}

/// How each joint of the body is turned in the bind pose, which has identity rotations in the rig.
std::array<Quat, motion::body_joint_count> bind_rotations_of(const motion::Recording& recording,
                                                             const motion::BodyMapping& mapping) {
  const motion::RigMotion rig = motion::rig_motion(recording, mapping.joints, mapping.to_y_up);
  std::array<Quat, motion::body_joint_count> rotations;
  rotations.fill(Quat::Identity());
  for (int j = 0; j < motion::body_joint_count; ++j) {
    const auto joint = BodyJoint(j);
    if (!rig.turns(joint)) continue;
    rotations[joint] =
        motion::canonical_rotation(rig, rig.frames.front(), joint, mapping.calibration[joint]);
  }
  return rotations;
}

void name_parts(Character& character) {
  const std::vector<int> owner = body_joint_of(character);
  for (SkinnedMesh& mesh : character.meshes) {
    for (const auto& triangle : mesh.triangles) {
      const int joint = mesh.influences[static_cast<size_t>(triangle[0])].front().joint;
      mesh.triangle_parts.push_back(owner[static_cast<size_t>(joint)]);
    }
  }
}

/// Standing at rest: a T-pose, feet flat.
motion::Pose rest_pose(const Character& character) {
  motion::Pose pose;
  pose.rotations.assign(character.body.joints.size(), Quat::Identity());
  return pose;
}

Eigen::AlignedBox3f box_of(const std::vector<render::Mesh>& meshes) {
  Eigen::AlignedBox3f box;
  for (const render::Mesh& mesh : meshes) {
    for (const render::Vec3& position : mesh.positions) box.extend(position);
  }
  return box;
}

/// Lets the body reach up to the crown, or hat, of the mesh and says how far the mesh reaches below
/// the body's soles at rest.
void measure_stature(Character& character) {
  const motion::Pose rest = rest_pose(character);
  const motion::JointTransforms world = motion::world_transforms(character.body, rest);
  const Eigen::AlignedBox3f box = box_of(posed(character, rest));
  const double crown = box.max().y() - world.positions[motion::Head].y();
  if (crown > 0.0) character.body.joints[motion::Head].tip = Vec3(0.0, crown, 0.0);
  const double sole = std::min(motion::sole_points(character.body, world, true).ball.y(),
                               motion::sole_points(character.body, world, false).ball.y());
  character.sole_depth = sole - box.min().y();
}

/// Numbers that were finite in the file may be so no more in the bind pose.
void check_meshes(const std::string& file, const Character& character) {
  try {
    for (const SkinnedMesh& mesh : character.meshes) validate(mesh, character.rig.size());
  } catch (const std::invalid_argument& wrong) {
    throw Error({file}, std::string("its meshes are faulty: ") + wrong.what(),
                "export or download the file again");
  }
}

Character character_of(CharacterParts parts) {
  Character character;
  character.name = motion::recording_name(parts.file);
  character.rig = parts.rig;
  character.meshes = std::move(parts.meshes);
  character.materials = std::move(parts.paint.materials);
  character.textures = std::move(parts.paint.textures);
  character.face = std::move(parts.face);
  character.warnings = std::move(parts.warnings);
  const double extent = extent_of(character.rig);
  if (!(extent > 1e-9)) {
    throw Error({parts.file}, "all joints are at the same point",
                "export the figure in its bind pose");
  }
  motion::Recording recording = bind_recording(parts);
  for (motion::Joint& joint : recording.skeleton.joints) joint.offset *= assumed_extent / extent;
  recording.poses.front().root_position *= assumed_extent / extent;
  const motion::BodyMapping mapping = recognised(recording, parts.is_mirrored, parts.file);
  character.warnings.insert(character.warnings.end(), mapping.warnings.begin(),
                            mapping.warnings.end());
  character.joints = mapping.joints;
  character.body = mapping.body;
  character.bind_rotations = bind_rotations_of(recording, mapping);
  character.fingers = character_fingers(mapping);
  transform(character, mapping.to_y_up, mapping.metres_per_unit * assumed_extent / extent);
  check_meshes(parts.file, character);
  for (SkinnedMesh& mesh : character.meshes) cluster_triangles(mesh);
  add_face_joints(character);
  name_parts(character);
  measure_stature(character);
  return character;
}

CharacterParts gltf_parts(const CharacterFile& file) {
  CharacterParts parts;
  parts.file = file.gltf.name;
  const BindPoseRig rig = gltf_rig(file, parts.warnings);
  parts.rig = rig.skeleton;
  parts.is_mirrored = rig.is_mirrored;
  const GltfMorphs morphs = gltf_morphs(file, rig.meshes);
  parts.meshes = gltf_meshes(file, rig, morphs, parts.warnings);
  parts.face = gltf_face(file, rig.meshes, morphs, parts.warnings);
  parts.paint = gltf_materials(file, parts.warnings);
  return parts;
}

std::string lower_case_ending(const std::filesystem::path& path) {
  std::string ending = motion::without_compression(path).extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

bool is_fbx(const std::filesystem::path& path) { return lower_case_ending(path) == ".fbx"; }

std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : ".";
}

std::string contents_of(const std::filesystem::path& path) {
  std::string bytes = motion::read_contents(path);
  motion::require_kind(bytes, path.string(), is_fbx(path) ? "fbx" : "gltf");
  return bytes;
}

CharacterParts parts_of(std::string_view bytes, const std::string& name,
                        const std::optional<std::filesystem::path>& folder) {
  if (is_fbx(name)) return fbx_parts(bytes, name, folder);
  return gltf_parts(parse_character_file(bytes, name, folder));
}

std::vector<std::filesystem::path> files_of_gltf(const CharacterFile& file) {
  std::vector<std::filesystem::path> parts;
  for (const char* list : {"buffers", "images"}) {
    for (const nlohmann::json& entry : list_in(file.json, list)) {
      const auto uri = entry.is_object() ? entry.find("uri") : entry.end();
      if (!entry.is_object() || uri == entry.end() || !uri->is_string()) continue;
      const auto text = uri->get<std::string>();
      if (!text.starts_with("data:"))
        parts.push_back(*file.folder / motion::path_of_gltf_uri(text));
    }
  }
  return parts;
}

}  // namespace

bool is_character_file(const std::filesystem::path& path) {
  return std::ranges::find(character_endings, lower_case_ending(path)) !=
         std::end(character_endings);
}

Character parse_character(std::string_view bytes, const std::string& file_name) {
  return character_of(parts_of(bytes, file_name, std::nullopt));
}

Character read_character(const std::filesystem::path& path) {
  return character_of(parts_of(contents_of(path), path.string(), folder_of(path)));
}

std::vector<std::filesystem::path> files_of_character(const std::filesystem::path& path) {
  const std::string bytes = contents_of(path);
  if (is_fbx(path)) return files_of_fbx(bytes, path.string(), folder_of(path));
  return files_of_gltf(parse_character_file(bytes, path.string(), folder_of(path)));
}

Character scaled_to_body(Character character, const motion::Skeleton& body) {
  const double scale = motion::leg_length(body) / motion::leg_length(character.body);
  transform(character, Quat::Identity(), scale);
  for (motion::Joint& joint : character.body.joints) {
    joint.offset *= scale;
    if (joint.tip) *joint.tip *= scale;
  }
  character.sole_depth *= scale;
  return character;
}

motion::Clip retargeted_to(const Character& character, const motion::Clip& clip) {
  motion::Clip worn = motion::retarget(clip, character.body);
  for (motion::Pose& pose : worn.poses) pose.root_position.y() += character.sole_depth;
  return worn;
}

namespace {

/// How a joint of the body is turned from the bind pose, world space.
Quat turn_from_bind(const Character& character, const motion::JointTransforms& body,
                    BodyJoint joint) {
  const auto turn = [&](BodyJoint j) -> Quat {
    return (body.rotations[j] * character.bind_rotations[j].conjugate()).normalized();
  };
  const double most = max_twist(joint);
  if (most >= motion::pi) return turn(joint);
  const Quat above = turn(BodyJoint(motion::body_parents[joint]));
  const Vec3 bone = character.bind_rotations[joint] * motion::rest_direction(joint);
  return above * clamped_twist(above.conjugate() * turn(joint), bone, most);
}

}  // namespace

/// `zero_pose` would put the root at the origin.
motion::JointTransforms rig_bind_pose(const Character& character) {
  motion::JointTransforms rest = motion::zero_pose(character.rig);
  for (Vec3& position : rest.positions) position += character.rig.joints.front().offset;
  return rest;
}

std::vector<int> body_joint_of(const Character& character) {
  std::vector<int> owner(character.rig.joints.size(), -1);
  for (int b = 0; b < motion::body_joint_count; ++b) {
    for (const int joint : character.joints[static_cast<size_t>(b)].group) {
      if (!character.joints[static_cast<size_t>(b)].at_tip) owner[static_cast<size_t>(joint)] = b;
    }
  }
  for (size_t j = 0; j < owner.size(); ++j) {
    const int parent = character.rig.joints[j].parent;
    if (owner[j] < 0) owner[j] = parent < 0 ? 0 : owner[static_cast<size_t>(parent)];
  }
  return owner;
}

motion::JointTransforms rig_pose(const Character& character, const motion::Pose& pose,
                                 const FaceTurns& turns) {
  const motion::JointTransforms body = motion::world_transforms(character.body, pose);
  const motion::JointTransforms bind = rig_bind_pose(character);
  std::vector<int> turned_by(character.rig.joints.size(), -1);
  for (int b = 0; b < motion::body_joint_count; ++b) {
    const motion::MappedJoint& mapped = character.joints[static_cast<size_t>(b)];
    if (mapped.rotation() < 0) continue;
    turned_by[static_cast<size_t>(mapped.rotation())] = b;
    // Joints of a spine that stand for one turn together.
    if (!motion::is_aimed(mapped)) continue;
    for (const int joint : mapped.group) turned_by[static_cast<size_t>(joint)] = b;
  }
  const auto turn_of = [&](size_t b) { return turn_from_bind(character, body, BodyJoint(b)); };
  motion::JointTransforms now = bind;
  for (size_t j = 0; j < bind.positions.size(); ++j) {
    const auto parent = static_cast<size_t>(std::max(0, character.rig.joints[j].parent));
    // What is above the pelvis goes with it.
    now.rotations[j] = turned_by[j] >= 0 ? turn_of(static_cast<size_t>(turned_by[j]))
                       : j == 0          ? turn_of(motion::Pelvis)
                                         : now.rotations[parent];
    if (j == 0) continue;
    now.positions[j] =
        now.positions[parent] + now.rotations[parent] * character.rig.joints[j].offset;
  }
  const auto pelvis = static_cast<size_t>(character.joints[motion::Pelvis].position);
  const Vec3 shift = body.positions[motion::Pelvis] - now.positions[pelvis];
  for (Vec3& position : now.positions) position += shift;
  bend_fingers(character.fingers, character.rig, pose.fingers, now);
  turn_face(character, turns, now);
  return now;
}

std::vector<render::Mesh> posed(const Character& character, const motion::Pose& pose,
                                std::span<const double> weights, const FaceTurns& turns) {
  const JointMotions motions =
      joint_motions(rig_bind_pose(character), rig_pose(character, pose, turns));
  std::vector<render::Mesh> meshes;
  for (const SkinnedMesh& mesh : character.meshes) {
    meshes.push_back(morphed_and_skinned(mesh, motions, weights));
  }
  return meshes;
}

void add_character(render::Scene& scene, const Character& character, const motion::Pose& pose,
                   std::span<const double> weights, const FaceTurns& turns) {
  const auto first_material = static_cast<int>(scene.materials.size());
  const auto first_texture = static_cast<int>(scene.textures.size());
  const auto first_part = static_cast<int>(scene.parts.size());
  const auto figure = static_cast<int>(scene.figures.size()) - 1;
  for (render::Material material : character.materials) {
    if (material.texture >= 0) material.texture += first_texture;
    if (material.normal_map >= 0) material.normal_map += first_texture;
    scene.materials.push_back(material);
  }
  for (const render::Texture& texture : character.textures) scene.textures.push_back(&texture);
  for (const motion::Joint& joint : character.body.joints) {
    scene.parts.push_back({joint.name, figure});
  }
  for (render::Mesh& mesh : posed(character, pose, weights, turns)) {
    mesh.material += first_material;
    for (int& part : mesh.triangle_parts) part += first_part;
    scene.solids.meshes.push_back(std::move(mesh));
  }
}

}  // namespace mien::scenes
