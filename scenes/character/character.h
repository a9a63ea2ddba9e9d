#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/rig/body_mapping.h"
#include "motion/skeleton/clip.h"
#include "render/scene/scene.h"
#include "scenes/character/character_fingers.h"
#include "scenes/character/face_control.h"
#include "scenes/skinning/skinned_model.h"

namespace mien::scenes {

/// A skinned character from a glTF or FBX file, driven by motions of the canonical body.
///
/// Everything is in its bind pose: +Y up, joint frames parallel to the world's.
struct Character {
  std::string name;
  motion::Skeleton rig;         ///< its own joints; joint 0 is positioned at its offset
  motion::MappedJoints joints;  ///< the rig joints that correspond to each joint of the body
  motion::Skeleton body;        ///< the canonical body with the character's bone lengths, metres
  std::vector<SkinnedMesh> meshes;  ///< influences refer to joints of the rig
  std::vector<render::Material> materials;
  std::vector<render::Texture> textures;
  FaceControls face;  ///< the morphs of the meshes, jaw and eyes

  /// Rotation of each joint of the body in the bind pose, world space; identities if that is a
  /// T-pose.
  std::array<motion::Quat, motion::body_joint_count> bind_rotations;

  CharacterFingers fingers;

  /// Depth of the mesh's soles below those of the body (motion/skeleton/sole.h) in the rest pose,
  /// metres.
  double sole_depth = 0.0;

  std::vector<std::string> warnings;  ///< on what is not rendered and on the rig, as sentences
};

/// File name endings that `read_character` supports.
inline constexpr std::string_view character_endings[] = {".gltf", ".glb", ".vrm", ".fbx"};

/// Whether a path has one of these endings, in upper or lower case.
bool is_character_file(const std::filesystem::path& path);

/// Reads a text or binary glTF 2.0 file, or an FBX file of version 6.1 to 7.7, with its buffers and
/// pictures.
///
/// - All triangle primitives are read, of skinned meshes and of meshes without a skin that are
///   attached to a joint, with base colour factors, textures and normal maps (PNG, JPEG, WebP).
///   Vertex colours and transparency are omitted with a warning.
/// - Morph targets of glTF files and the expressions of VRM are read (gltf_morphs.h,
///   vrm_expressions.h); those of FBX files are omitted with a warning. Jaw and eyes that are
///   joints are found in files of all formats (face_joints.h).
/// - Joints are identified by the names of common rigs (motion/rig/rig_names.h), by the humanoid
///   bones of VRM 0 and 1, or else by the shape of their tree. The bind pose, a T-pose or an
///   A-pose, determines the orientation of the joints relative to the bones.
/// - The bind pose is that of the inverse bind matrices. The pose of the file's nodes
///   determines only the orientation of the whole, and the positions of skins that share no joint,
///   of joints without such a matrix and of meshes without a skin.
/// - In FBX files the joints are those of the file's motion (motion/formats/fbx/fbx.h). Pictures
///   are in the file, or beside it under their relative name or in its folder; surfaces whose
///   picture is missing or of another kind get their plain colour, with a warning.
///
/// Throws mien::Error, naming the file, if it does not contain such a character: no skin, no human
/// figure, indices out of range, numbers that are not finite, cycles, missing pictures.
Character read_character(const std::filesystem::path& path);

/// As `read_character`, but from a file in memory with all buffers and pictures embedded.
Character parse_character(std::string_view bytes, const std::string& file_name);

/// The external files of a character, buffers and pictures, in the order of the file: of glTF
/// whether or not they exist, of FBX those pictures that exist. Throws mien::Error when it cannot
/// be read.
std::vector<std::filesystem::path> files_of_character(const std::filesystem::path& path);

/// The character, scaled uniformly to the leg length of `body`, so that steps keep their length.
Character scaled_to_body(Character character, const motion::Skeleton& body);

/// The motion retargeted to the character's body, with the same rotations and with soles on the
/// floor.
motion::Clip retargeted_to(const Character& character, const motion::Clip& clip);

/// World transforms of the rig's joints in a pose of the character's body; rotations are relative
/// to the bind pose. Rig joints that correspond to a joint of the body rotate with it; all others
/// follow their parent, and those above the pelvis follow the pelvis. The twist of toes, head and
/// hands is limited (leaf_twist.h). Fingers have those of the pose, or that of the bind pose if it
/// has none; jaw and eyes turn on the head by `turns`.
motion::JointTransforms rig_pose(const Character& character, const motion::Pose& pose,
                                 const FaceTurns& turns = {});

/// World transforms of the rig's joints in the bind pose, as by `rig_pose`: all rotations are the
/// identity.
motion::JointTransforms rig_bind_pose(const Character& character);

/// The joint of the body that each joint of the rig follows: its own, or that of its nearest
/// ancestor that has one, else the pelvis.
std::vector<int> body_joint_of(const Character& character);

/// The meshes in a pose of the character's body, after their morph targets (linear blend skinning);
/// materials are the character's. `weights` has one for each morph (FaceControls); empty: all 0.
std::vector<render::Mesh> posed(const Character& character, const motion::Pose& pose,
                                std::span<const double> weights = {}, const FaceTurns& turns = {});

/// Appends the posed character to a scene, with its materials and textures, as part of the scene's
/// last figure. Its parts are named like the body's joints. The character must outlive the scene.
void add_character(render::Scene& scene, const Character& character, const motion::Pose& pose,
                   std::span<const double> weights = {}, const FaceTurns& turns = {});

}  // namespace mien::scenes
