#include "scenes/character/face_joints.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "motion/math/rotation.h"
#include "motion/rig/joint_word.h"

namespace mien::scenes {

namespace {

using motion::Quat;
using motion::Vec3;
using Side = motion::JointWord::Side;

constexpr double jaw_open = 20.0 * motion::radians_per_degree;
constexpr double look_aside = 30.0 * motion::radians_per_degree;
constexpr double look_up = 25.0 * motion::radians_per_degree;

constexpr std::string_view jaw_names[] = {"jaw", "lowerjaw", "jawroot", "jawbone", "jawmaster"};
constexpr std::string_view eye_names[] = {"eye", "eyeball"};

/// What rigs of VRoid, Character Creator, MetaHuman and SMPL-X add to the word.
constexpr std::string_view face_prefixes[] = {"ccbase", "facial", "adjface", "adj", "face"};
constexpr std::string_view face_suffixes[] = {"smplhf"};

/// Joints below the head, with which vertices move.
std::vector<bool> moving_joints(const Character& character) {
  std::vector<bool> moves(character.rig.joints.size(), false);
  for (const SkinnedMesh& mesh : character.meshes)
    for (const auto& influences : mesh.influences)
      for (const Influence& one : influences) moves[static_cast<std::size_t>(one.joint)] = true;
  for (std::size_t j = moves.size(); j-- > 1;)
    if (moves[j]) moves[static_cast<std::size_t>(character.rig.joints[j].parent)] = true;
  return moves;
}

void find_face_joints(Character& character) {
  const std::vector<int> owner = body_joint_of(character);
  const std::vector<bool> moves = moving_joints(character);
  for (std::size_t j = 1; j < owner.size(); ++j) {
    const auto parent = static_cast<std::size_t>(character.rig.joints[j].parent);
    if (!moves[j] || owner[j] != motion::Head || owner[parent] != motion::Head) continue;
    const std::optional<FaceJoint> known = face_joint_named(character.rig.joints[j].name);
    if (!known) continue;
    int& joint = character.face.joints[static_cast<std::size_t>(*known)];
    if (joint < 0) joint = static_cast<int>(j);
  }
}

class TurnControls {
 public:
  explicit TurnControls(FaceControls& face) : face_(face) {}

  /// Turns that the character's joints cannot make are left out; without any, there is no control.
  void add(const std::string& name, std::initializer_list<std::pair<FaceJoint, Vec3>> turns,
           bool is_angle = false) {
    FaceControl control;
    control.name = name;
    control.is_angle = is_angle;
    for (const auto& [joint, turn] : turns)
      if (face_.joints[static_cast<std::size_t>(joint)] >= 0) control.turns[joint] = turn;
    if (control.turns == FaceTurns()) return;
    const FaceControl* known = control_named(face_, name);
    if (known == nullptr) return face_.controls.push_back(std::move(control));
    // An expression of VRM that only states that the eyes are joints.
    if (known->morphs.empty())
      face_.controls[static_cast<std::size_t>(known - face_.controls.data())].turns = control.turns;
  }

 private:
  FaceControls& face_;
};

void add_turns_of_eyes(TurnControls& controls) {
  const Vec3 up(-look_up, 0.0, 0.0), left(0.0, look_aside, 0.0);
  constexpr FaceJoint left_eye = FaceJoint::left_eye, right_eye = FaceJoint::right_eye;
  controls.add("eyeLookUpLeft", {{left_eye, up}});
  controls.add("eyeLookUpRight", {{right_eye, up}});
  controls.add("eyeLookDownLeft", {{left_eye, -up}});
  controls.add("eyeLookDownRight", {{right_eye, -up}});
  controls.add("eyeLookInLeft", {{left_eye, -left}});
  controls.add("eyeLookInRight", {{right_eye, left}});
  controls.add("eyeLookOutLeft", {{left_eye, left}});
  controls.add("eyeLookOutRight", {{right_eye, -left}});
  controls.add("lookUp", {{left_eye, up}, {right_eye, up}});
  controls.add("lookDown", {{left_eye, -up}, {right_eye, -up}});
  controls.add("lookLeft", {{left_eye, left}, {right_eye, left}});
  controls.add("lookRight", {{left_eye, -left}, {right_eye, -left}});
}

void add_recorded_turns(TurnControls& controls) {
  for (const auto& [joint, name] :
       {std::pair(FaceJoint::jaw, "jaw_pose_"), std::pair(FaceJoint::left_eye, "leye_pose_"),
        std::pair(FaceJoint::right_eye, "reye_pose_")}) {
    for (int axis = 0; axis < 3; ++axis)
      controls.add(
          std::string(name) + "xyz" [axis],
          {
            { joint, Vec3(Vec3::Unit(axis)) }
          },
          true);
  }
}

}  // namespace

std::optional<FaceJoint> face_joint_named(std::string_view name) {
  if (motion::names_an_end(name)) return std::nullopt;
  const motion::JointWord joint = motion::joint_word(name);
  std::string_view word = joint.word;
  for (const std::string_view prefix : face_prefixes)
    if (word.starts_with(prefix) && word != prefix) word.remove_prefix(prefix.size());
  for (const std::string_view suffix : face_suffixes)
    if (word.ends_with(suffix)) word.remove_suffix(suffix.size());
  if (joint.side == Side::middle && motion::is_among(jaw_names, word)) return FaceJoint::jaw;
  if (joint.side == Side::middle || !motion::is_among(eye_names, word)) return std::nullopt;
  return joint.side == Side::left ? FaceJoint::left_eye : FaceJoint::right_eye;
}

void add_face_joints(Character& character) {
  find_face_joints(character);
  TurnControls controls(character.face);
  controls.add("jawOpen", {{FaceJoint::jaw, Vec3(jaw_open, 0.0, 0.0)}});
  add_turns_of_eyes(controls);
  add_recorded_turns(controls);
}

void turn_face(const Character& character, const FaceTurns& turns, motion::JointTransforms& pose) {
  if (turns == FaceTurns()) return;
  const Quat& axes = character.bind_rotations[motion::Head];
  std::vector<Quat> own(character.rig.joints.size(), Quat::Identity());
  std::vector<bool> moves(own.size(), false);
  for (std::size_t f = 0; f < face_joint_count; ++f) {
    if (character.face.joints[f] < 0 || turns.joints[f] == Vec3::Zero()) continue;
    const auto joint = static_cast<std::size_t>(character.face.joints[f]);
    own[joint] = axes * motion::exp(turns.joints[f]) * axes.conjugate();
    moves[joint] = true;
  }
  for (std::size_t j = 1; j < own.size(); ++j) {
    const auto parent = static_cast<std::size_t>(character.rig.joints[j].parent);
    if (!moves[j] && !moves[parent]) continue;
    moves[j] = true;
    pose.positions[j] =
        pose.positions[parent] + pose.rotations[parent] * character.rig.joints[j].offset;
    pose.rotations[j] = (pose.rotations[parent] * own[j]).normalized();
  }
}

}  // namespace mien::scenes
