#pragma once

#include <span>
#include <string>
#include <string_view>

namespace mien::motion {

/// A normalised joint name, independent of the rig's spelling.
struct JointWord {
  enum class Side { middle, left, right };
  Side side = Side::middle;
  std::string word;  ///< in lower case, without side, name space, numbers and prefixes such as
                     ///< "Bip": "upleg", "hips"
};

/// Reads a joint name in the spellings of common rigs: "LeftUpLeg", "mixamorig:LeftUpLeg",
/// "UpperLeg_L", "lfemur", "Bip01 L Thigh", "J_Bip_L_UpperLeg", "thigh.L", "left_hip".
JointWord joint_word(std::string_view name);

/// The region of the body that a joint's name indicates.
enum class BodyRegion { other, head, arm, leg };

/// The region, determined by the beginning of the word, so that "handthumb" and "upperarmtwist"
/// belong to the arm; `other` for joints of the trunk and unknown names.
BodyRegion body_region_of(const JointWord& joint);

/// Whether a name marks its joint as an end site, such as "HeadTop_End" or "ToeNub".
bool names_an_end(std::string_view name);

/// Whether a name is that of a part of the face: jaw, eye, tongue, … in any spelling.
bool names_a_part_of_the_face(std::string_view name);

/// Lists of the words for joints in common rigs.
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
