#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::scenes {

/// Joints of a face that turn on the head.
enum class FaceJoint { jaw, left_eye, right_eye };
inline constexpr std::size_t face_joint_count = 3;

/// How the joints of a face are turned from the bind pose: axis × angle of each, radians, in the
/// head's axes: x to its left, y up, z to its front.
struct FaceTurns {
  std::array<motion::Vec3, face_joint_count> joints = {motion::Vec3::Zero(), motion::Vec3::Zero(),
                                                       motion::Vec3::Zero()};

  motion::Vec3& operator[](FaceJoint joint) { return joints[static_cast<std::size_t>(joint)]; }
  const motion::Vec3& operator[](FaceJoint joint) const {
    return joints[static_cast<std::size_t>(joint)];
  }
  friend bool operator==(const FaceTurns&, const FaceTurns&) = default;
};

/// An expression, a morph target or a turn of a joint, by whose weight the face of a character is
/// changed.
struct FaceControl {
  std::string name;
  /// Morphs (MorphTarget::morph) with what weight 1 adds to the weight of each.
  std::vector<std::pair<int, double>> morphs;
  bool is_binary = false;  ///< weights above 0.5 count as 1, others as 0 (VRM)
  FaceTurns turns;         ///< what weight 1 adds to the rotation of each joint
  bool is_angle = false;   ///< the weight is an angle of a recording in radians
};

/// The morphs of a character's meshes and the joints of its face, and the controls that change
/// them.
struct FaceControls {
  int morph_count = 0;
  std::array<int, face_joint_count> joints = {-1, -1, -1};  ///< of the rig; −1: it has none
  /// Expressions of VRM, then morph targets, with the names of the file, then what turns joints
  /// (face_joints.h). Of several with one name the first counts.
  std::vector<FaceControl> controls;
};

/// The names of a face's controls, each once, in their order, without those whose weights are
/// angles of a recording.
std::vector<std::string> face_names(const FaceControls& face);

/// The control of a name: the first that has it exactly, or else the first that differs only in
/// upper and lower case or in how the side is written ("eyeBlink_L" for "EyeBlinkLeft"); what
/// stands before the last "." of a control's name need not be given ("head.eyeBlink_L"). None if
/// there is none.
const FaceControl* control_named(const FaceControls& face, std::string_view name);

}  // namespace mien::scenes
