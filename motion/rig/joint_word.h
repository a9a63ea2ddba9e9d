#pragma once

#include <span>
#include <string>
#include <string_view>

namespace mien::motion {

/// What a joint's name says, whatever rig it comes from.
struct JointWord {
  enum class Side { middle, left, right };
  Side side = Side::middle;
  std::string word;  ///< lower case, without side, name space, numbers and padding: "upleg", "hips"
};

/// Reads a joint name in the spellings of common rigs: "LeftUpLeg", "mixamorig:LeftUpLeg",
/// "UpperLeg_L", "lfemur", "Bip01 L Thigh", "J_Bip_L_UpperLeg", "thigh.L", "left_hip".
JointWord joint_word(std::string_view name);

/// What a name says of where its joint belongs.
enum class BodyPart { other, head, arm, leg };

/// By the beginning of the word, so that "handthumb" and "upperarmtwist" are of the arm. Joints of
/// the trunk, and those whose names say nothing, are of another part.
BodyPart body_part_of(const JointWord& joint);

/// Whether a name says that its joint is but the end of the bone before it: "HeadTop_End",
/// "ToeNub".
bool names_an_end(std::string_view name);

/// The words that joints are known by.
namespace joint_words {

using Words = std::span<const std::string_view>;

inline constexpr std::string_view pelvis_words[] = {"hips", "hip", "pelvis", "root", "reference"};
inline constexpr std::string_view head_words[] = {"head"};
inline constexpr std::string_view upper_arm_words[] = {"upperarm", "uparm", "arm", "humerus"};
inline constexpr std::string_view shoulder_words[] = {"shoulder"};
inline constexpr std::string_view forearm_words[] = {"forearm", "lowerarm", "loarm",
                                                     "lowarm",  "radius",   "elbow"};
inline constexpr std::string_view wrist_words[] = {"wrist", "hand", "palm"};
inline constexpr std::string_view thigh_words[] = {"upleg", "upperleg", "thigh", "femur"};
inline constexpr std::string_view hip_words[] = {"hip"};
inline constexpr std::string_view shank_words[] = {"leg",  "lowerleg", "loleg", "lowleg",
                                                   "shin", "calf",     "tibia", "knee"};
inline constexpr std::string_view ankle_words[] = {"ankle"};
inline constexpr std::string_view foot_words[] = {"foot"};
inline constexpr std::string_view toe_words[] = {"toe", "toes", "toebase", "ball"};
inline constexpr std::string_view clavicle_words[] = {"clavicle", "collar"};

}  // namespace joint_words

bool is_among(joint_words::Words words, std::string_view word);

}  // namespace mien::motion
