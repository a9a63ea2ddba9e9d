#pragma once

#include <optional>
#include <string_view>

#include "motion/skeleton/pose.h"
#include "scenes/character/character.h"
#include "scenes/character/face_control.h"

namespace mien::scenes {

/// The joint of a face that a rig's joint is by its name: "jaw", "mixamorig:Jaw", "lowerJaw",
/// "CC_Base_JawRoot"; "leftEye", "LeftEye", "eye.L", "J_Adj_L_FaceEye", "left_eye_smplhf",
/// "CC_Base_L_Eye" and the same on the right. None for others, such as brows, lids and "JawEnd".
std::optional<FaceJoint> face_joint_named(std::string_view name);

/// Finds jaw and eyes among the joints below the character's head that move vertices, and adds the
/// controls that turn them, where the face has none of that name that moves morphs:
///
/// - "jawOpen": the jaw by 20° about the head's left-right axis, so that the chin goes down and
///   back
/// - "eyeLookInLeft", "eyeLookOutLeft", "eyeLookUpLeft", "eyeLookDownLeft" of ARKit, and the same
///   on the right: one eye by 30° towards or away from the nose, by 25° up or down
/// - "lookLeft", "lookRight", "lookUp", "lookDown" of VRM: both eyes by these angles
/// - "jaw_pose_x", "leye_pose_y" …: the numbers of rotation vectors in files of SMPL-X, in radians
///
/// The angles are near the ends of what people do: jaws open by 20° to 30°, eyes turn by 35° at
/// most. The joints of the character's body must be known.
void add_face_joints(Character& character);

/// Turns jaw and eyes of a rig that is posed by `pose`, whose rotations are relative to the bind
/// pose, and moves what hangs on them. Turns of zero change nothing.
void turn_face(const Character& character, const FaceTurns& turns, motion::JointTransforms& pose);

}  // namespace mien::scenes
