#pragma once

#include <span>
#include <string>
#include <string_view>

#include "motion/skeleton/skeleton.h"

namespace mien::test {

/// A joint and its parent by name.
struct NamedJoint {
  std::string_view name;
  std::string_view parent;
};

inline constexpr NamedJoint cmu_like[] = {
    {"Hips", ""},
    {"LHipJoint", "Hips"},
    {"LeftUpLeg", "LHipJoint"},
    {"LeftLeg", "LeftUpLeg"},
    {"LeftFoot", "LeftLeg"},
    {"LeftToeBase", "LeftFoot"},
    {"RHipJoint", "Hips"},
    {"RightUpLeg", "RHipJoint"},
    {"RightLeg", "RightUpLeg"},
    {"RightFoot", "RightLeg"},
    {"RightToeBase", "RightFoot"},
    {"LowerBack", "Hips"},
    {"Spine", "LowerBack"},
    {"Spine1", "Spine"},
    {"Neck", "Spine1"},
    {"Neck1", "Neck"},
    {"Head", "Neck1"},
    {"LeftShoulder", "Spine1"},
    {"LeftArm", "LeftShoulder"},
    {"LeftForeArm", "LeftArm"},
    {"LeftHand", "LeftForeArm"},
    {"LThumb", "LeftHand"},
    {"RightShoulder", "Spine1"},
    {"RightArm", "RightShoulder"},
    {"RightForeArm", "RightArm"},
    {"RightHand", "RightForeArm"},
};

inline constexpr NamedJoint xsens_like[] = {
    {"Hips", ""},
    {"Chest", "Hips"},
    {"Chest2", "Chest"},
    {"Chest3", "Chest2"},
    {"Chest4", "Chest3"},
    {"Neck", "Chest4"},
    {"Head", "Neck"},
    {"RightCollar", "Chest4"},
    {"RightShoulder", "RightCollar"},
    {"RightElbow", "RightShoulder"},
    {"RightWrist", "RightElbow"},
    {"LeftCollar", "Chest4"},
    {"LeftShoulder", "LeftCollar"},
    {"LeftElbow", "LeftShoulder"},
    {"LeftWrist", "LeftElbow"},
    {"RightHip", "Hips"},
    {"RightKnee", "RightHip"},
    {"RightAnkle", "RightKnee"},
    {"RightToe", "RightAnkle"},
    {"LeftHip", "Hips"},
    {"LeftKnee", "LeftHip"},
    {"LeftAnkle", "LeftKnee"},
    {"LeftToe", "LeftAnkle"},
};

inline constexpr NamedJoint smpl_like[] = {
    {"pelvis", ""},
    {"left_hip", "pelvis"},
    {"left_knee", "left_hip"},
    {"left_ankle", "left_knee"},
    {"left_foot", "left_ankle"},
    {"right_hip", "pelvis"},
    {"right_knee", "right_hip"},
    {"right_ankle", "right_knee"},
    {"right_foot", "right_ankle"},
    {"spine1", "pelvis"},
    {"spine2", "spine1"},
    {"spine3", "spine2"},
    {"neck", "spine3"},
    {"head", "neck"},
    {"left_collar", "spine3"},
    {"left_shoulder", "left_collar"},
    {"left_elbow", "left_shoulder"},
    {"left_wrist", "left_elbow"},
    {"left_hand", "left_wrist"},
    {"right_collar", "spine3"},
    {"right_shoulder", "right_collar"},
    {"right_elbow", "right_shoulder"},
    {"right_wrist", "right_elbow"},
    {"right_hand", "right_wrist"},
};

inline constexpr NamedJoint biped_like[] = {
    {"Bip01", ""},
    {"Bip01 Pelvis", "Bip01"},
    {"Bip01 Spine", "Bip01 Pelvis"},
    {"Bip01 L Thigh", "Bip01 Spine"},
    {"Bip01 L Calf", "Bip01 L Thigh"},
    {"Bip01 L Foot", "Bip01 L Calf"},
    {"Bip01 L Toe0", "Bip01 L Foot"},
    {"Bip01 R Thigh", "Bip01 Spine"},
    {"Bip01 R Calf", "Bip01 R Thigh"},
    {"Bip01 R Foot", "Bip01 R Calf"},
    {"Bip01 R Toe0", "Bip01 R Foot"},
    {"Bip01 Spine1", "Bip01 Spine"},
    {"Bip01 Spine2", "Bip01 Spine1"},
    {"Bip01 Neck", "Bip01 Spine2"},
    {"Bip01 Head", "Bip01 Neck"},
    {"Bip01 L Clavicle", "Bip01 Neck"},
    {"Bip01 L UpperArm", "Bip01 L Clavicle"},
    {"Bip01 L Forearm", "Bip01 L UpperArm"},
    {"Bip01 L Hand", "Bip01 L Forearm"},
    {"Bip01 L Finger0", "Bip01 L Hand"},
    {"Bip01 R Clavicle", "Bip01 Neck"},
    {"Bip01 R UpperArm", "Bip01 R Clavicle"},
    {"Bip01 R Forearm", "Bip01 R UpperArm"},
    {"Bip01 R Hand", "Bip01 R Forearm"},
    {"Bip01 R Finger0", "Bip01 R Hand"},
};

inline constexpr NamedJoint acclaim_like[] = {
    {"root", ""},
    {"lhipjoint", "root"},
    {"lfemur", "lhipjoint"},
    {"ltibia", "lfemur"},
    {"lfoot", "ltibia"},
    {"ltoes", "lfoot"},
    {"rhipjoint", "root"},
    {"rfemur", "rhipjoint"},
    {"rtibia", "rfemur"},
    {"rfoot", "rtibia"},
    {"rtoes", "rfoot"},
    {"lowerback", "root"},
    {"upperback", "lowerback"},
    {"thorax", "upperback"},
    {"lowerneck", "thorax"},
    {"upperneck", "lowerneck"},
    {"head", "upperneck"},
    {"lclavicle", "thorax"},
    {"lhumerus", "lclavicle"},
    {"lradius", "lhumerus"},
    {"lwrist", "lradius"},
    {"lhand", "lwrist"},
    {"lfingers", "lhand"},
    {"lthumb", "lwrist"},
    {"rclavicle", "thorax"},
    {"rhumerus", "rclavicle"},
    {"rradius", "rhumerus"},
    {"rwrist", "rradius"},
    {"rhand", "rwrist"},
    {"rfingers", "rhand"},
    {"rthumb", "rwrist"},
};

/// The tree alone; offsets are zero.
inline motion::Skeleton rig_of(std::span<const NamedJoint> joints) {
  motion::Skeleton rig;
  for (const NamedJoint& joint : joints) {
    motion::Joint added;
    added.name = std::string(joint.name);
    added.parent = motion::find_joint(rig, joint.parent);
    rig.joints.push_back(added);
  }
  return rig;
}

}  // namespace mien::test
