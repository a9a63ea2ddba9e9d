#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "motion/math/rotation.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/hand.h"
#include "motion/skeleton/hand_tip.h"
#include "motion/skeleton/recording.h"

namespace mien::test {

/// How a family of rigs spells its finger joints. Segment −1 is a metacarpal, 3 the end of a
/// finger; an empty name: the rig has no such joint.
struct HandSpelling {
  std::string family;
  std::function<std::string(bool left, motion::Finger finger, int segment)> name;
};

inline std::string word_of(motion::Finger finger, bool pinky) {
  const char* words[] = {"Thumb", "Index", "Middle", "Ring", pinky ? "Pinky" : "Little"};
  return words[static_cast<int>(finger)];
}

inline std::string in_lower_case(std::string word) {
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

inline std::vector<HandSpelling> hand_spellings() {
  using motion::Finger;
  const auto side = [](bool left) { return std::string(left ? "Left" : "Right"); };
  const auto short_side = [](bool left) { return std::string(left ? "L" : "R"); };
  const auto number = [](Finger finger) { return static_cast<int>(finger); };
  return {
      {"Mixamo",
       [=](bool left, Finger finger, int segment) {
         if (segment < 0) return std::string();
         return "mixamorig:" + side(left) + "Hand" + word_of(finger, true) +
                std::to_string(segment + 1);
       }},
      {"VRM 1.0",
       [=](bool left, Finger finger, int segment) {
         const char* of_thumb[] = {"Metacarpal", "Proximal", "Distal"};
         const char* of_finger[] = {"Proximal", "Intermediate", "Distal"};
         if (segment < 0 || segment > 2) return std::string();
         return (left ? "left" : "right") + word_of(finger, false) +
                (finger == Finger::thumb ? of_thumb : of_finger)[segment];
       }},
      {"VRoid",
       [=](bool left, Finger finger, int segment) {
         if (segment < 0) return std::string();
         const std::string name = "J_Bip_" + short_side(left) + "_" + word_of(finger, false);
         return segment == 3 ? name + "3_end" : name + std::to_string(segment + 1);
       }},
      {"SMPL-X",
       [=](bool left, Finger finger, int segment) {
         if (segment < 0 || segment > 2) return std::string();
         return (left ? "left_" : "right_") + in_lower_case(word_of(finger, true)) +
                std::to_string(segment + 1);
       }},
      {"Rokoko",
       [=](bool left, Finger finger, int segment) {
         const char* of_thumb[] = {"", "Metacarpal", "Proximal", "Distal", "Tip"};
         const char* of_finger[] = {"Metacarpal", "Proximal", "Medial", "Distal", "Tip"};
         const char* word = (finger == Finger::thumb ? of_thumb : of_finger)[segment + 1];
         if (*word == '\0') return std::string();
         return side(left) + "Finger" + std::to_string(number(finger) + 1) + word;
       }},
      {"Perception Neuron",
       [=](bool left, Finger finger, int segment) {
         if (segment > 2 || (segment < 0 && finger == Finger::thumb)) return std::string();
         if (segment < 0) return side(left) + "InHand" + word_of(finger, true);
         return side(left) + "Hand" + word_of(finger, true) + std::to_string(segment + 1);
       }},
      {"MVN",
       [=](bool left, Finger finger, int segment) {
         const char* counts[] = {"First", "Second", "Third", "Fourth", "Fifth"};
         const char* of_thumb[] = {"", "MC", "PP", "DP"};
         const char* of_finger[] = {"MC", "PP", "MP", "DP"};
         if (segment > 2) return std::string();
         const char* bone = (finger == Finger::thumb ? of_thumb : of_finger)[segment + 1];
         return *bone == '\0' ? std::string() : side(left) + counts[number(finger)] + bone;
       }},
      {"Biped",
       [=](bool left, Finger finger, int segment) {
         if (segment < 0) return std::string();
         const std::string name =
             "Bip01 " + short_side(left) + " Finger" + std::to_string(number(finger));
         return segment == 0 ? name : name + (segment == 3 ? "Nub" : std::to_string(segment));
       }},
      {"OptiTrack",
       [=](bool left, Finger finger, int segment) {
         if (segment < 0 || segment > 2) return std::string();
         return short_side(left) + word_of(finger, true) + std::to_string(segment + 1);
       }},
      {"Unreal",
       [=](bool left, Finger finger, int segment) {
         const std::string end = left ? "_l" : "_r";
         const std::string word = in_lower_case(word_of(finger, true));
         if (segment > 2 || (segment < 0 && finger == Finger::thumb)) return std::string();
         return word + (segment < 0 ? "_metacarpal" : "_0" + std::to_string(segment + 1)) + end;
       }},
      {"Rigify",
       [=](bool left, Finger finger, int segment) {
         if (segment < 0 || segment > 2) return std::string();
         return (finger == Finger::thumb ? "" : "f_") + in_lower_case(word_of(finger, true)) +
                ".0" + std::to_string(segment + 1) + "." + short_side(left);
       }},
  };
}

/// A T-pose of the standard body in a rig of that family: canonical hands turned about their
/// forearms by `twist` (of the left and of the right), or not.
struct HandedRig {
  motion::Skeleton skeleton;
  std::array<int, motion::finger_joint_count> joints;       ///< rig joint of each finger joint
  std::array<int, motion::finger_joint_count> metacarpals;  ///< of the finger; −1: none
  std::array<motion::Quat, 2> twist;
};

inline int add_joint(motion::Skeleton& rig, const std::string& name, int parent,
                     const motion::Vec3& offset) {
  rig.joints.push_back({name, parent, offset, std::nullopt});
  return rig.size() - 1;
}

inline HandedRig handed_rig(const HandSpelling& spelling,
                            const std::array<motion::Quat, 2>& twist = {motion::Quat::Identity(),
                                                                        motion::Quat::Identity()}) {
  using namespace motion;
  constexpr const char* names[] = {
      "Hips",      "Spine",       "Spine1",      "Neck",          "Head",        "LeftShoulder",
      "LeftArm",   "LeftForeArm", "LeftHand",    "RightShoulder", "RightArm",    "RightForeArm",
      "RightHand", "LeftUpLeg",   "LeftLeg",     "LeftFoot",      "LeftToeBase", "RightUpLeg",
      "RightLeg",  "RightFoot",   "RightToeBase"};
  HandedRig rig;
  rig.twist = twist;
  rig.skeleton = standard_body();
  const double length = hand_length(rig.skeleton);
  for (int j = 0; j < body_joint_count; ++j) rig.skeleton.joints[size_t(j)].name = names[j];
  rig.metacarpals.fill(-1);
  for (const bool left : {true, false}) {
    const Quat& turn = twist[left ? 0 : 1];
    for (int f = 0; f < fingers_per_hand; ++f) {
      int parent = left ? LeftWrist : RightWrist;
      Vec3 before = Vec3::Zero();
      if (const std::string name = spelling.name(left, Finger(f), -1); !name.empty()) {
        before = 0.3 * finger_offset(finger_joint(left, Finger(f), 0), length);
        parent = add_joint(rig.skeleton, name, parent, turn * before);
        rig.metacarpals[size_t(finger_joint(left, Finger(f), 0))] = parent;
      }
      for (int segment = 0; segment < joints_per_finger; ++segment) {
        const int joint = finger_joint(left, Finger(f), segment);
        const Vec3 offset = finger_offset(joint, length) - before;
        parent =
            add_joint(rig.skeleton, spelling.name(left, Finger(f), segment), parent, turn * offset);
        rig.joints[size_t(joint)] = parent;
        before = Vec3::Zero();
      }
      const Vec3 tip = turn * fingertip_offset(left, Finger(f), length);
      if (const std::string name = spelling.name(left, Finger(f), 3); !name.empty())
        add_joint(rig.skeleton, name, parent, tip);
      else
        rig.skeleton.joints[size_t(parent)].tip = tip;
    }
  }
  return rig;
}

/// A pose of the rig with arms and hands turned at random and these fingers.
inline motion::Pose handed_pose(const HandedRig& rig, const std::vector<motion::Quat>& fingers,
                                std::mt19937_64& random) {
  using namespace motion;
  std::uniform_real_distribution<double> angle(-0.4, 0.4);
  Pose pose;
  pose.root_position = Vec3(0, 0.95, 0);
  pose.rotations.assign(rig.skeleton.joints.size(), Quat::Identity());
  for (const BodyJoint joint : {LeftShoulder, LeftWrist, RightShoulder, RightWrist})
    pose.rotations[joint] = exp(Vec3(angle(random), angle(random), angle(random)));
  for (int joint = 0; joint < finger_joint_count; ++joint) {
    const Quat& turn = rig.twist[is_left_finger(joint) ? 0 : 1];
    pose.rotations[size_t(rig.joints[size_t(joint)])] =
        turn * fingers[size_t(joint)] * turn.conjugate();
  }
  return pose;
}

/// Fingers bent at every joint by angles drawn from 5° to 80°; `degrees` gets them.
inline std::vector<motion::Quat> random_bends(std::mt19937_64& random,
                                              std::vector<double>& degrees) {
  using namespace motion;
  std::uniform_real_distribution<double> bend(5.0, 80.0);
  std::vector<Quat> fingers;
  degrees.clear();
  for (int joint = 0; joint < finger_joint_count; ++joint) {
    degrees.push_back(bend(random));
    fingers.push_back(
        Quat(Eigen::AngleAxisd(degrees.back() * radians_per_degree, flexion_axis(joint))));
  }
  return fingers;
}

inline std::vector<motion::Quat> straight_fingers() {
  return std::vector<motion::Quat>(motion::finger_joint_count, motion::Quat::Identity());
}

/// The same recording on a rig whose joint frames are turned at random, so that its zero pose means
/// nothing.
inline motion::Recording in_random_frames(motion::Recording recording, std::mt19937_64& random) {
  using namespace motion;
  std::normal_distribution<double> normal;
  std::vector<Quat> turns;
  for (int j = 0; j < recording.skeleton.size(); ++j) {
    const double w = normal(random), x = normal(random), y = normal(random);
    turns.push_back(Quat(w, x, y, normal(random)).normalized());
  }
  for (size_t j = 0; j < turns.size(); ++j) {
    Joint& joint = recording.skeleton.joints[j];
    const Quat above =
        joint.parent < 0 ? Quat::Identity() : turns[static_cast<size_t>(joint.parent)];
    if (joint.parent >= 0) joint.offset = above.conjugate() * joint.offset;
    if (joint.tip) *joint.tip = turns[j].conjugate() * *joint.tip;
    for (Pose& pose : recording.poses)
      pose.rotations[j] = above.conjugate() * pose.rotations[j] * turns[j];
  }
  return recording;
}

}  // namespace mien::test
