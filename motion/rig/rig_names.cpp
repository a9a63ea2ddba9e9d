#include "motion/rig/rig_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <vector>

namespace mien::motion {

namespace {

using Side = JointWord::Side;
using Words = std::span<const std::string_view>;

constexpr std::string_view pelvis_words[] = {"hips", "hip", "pelvis", "root", "reference"};
constexpr std::string_view head_words[] = {"head"};
constexpr std::string_view upper_arm_words[] = {"upperarm", "uparm", "arm", "humerus"};
constexpr std::string_view shoulder_words[] = {"shoulder"};
constexpr std::string_view forearm_words[] = {"forearm", "lowerarm", "loarm",
                                              "lowarm",  "radius",   "elbow"};
constexpr std::string_view wrist_words[] = {"wrist", "hand", "palm"};
constexpr std::string_view thigh_words[] = {"upleg", "upperleg", "thigh", "femur"};
constexpr std::string_view hip_words[] = {"hip"};
constexpr std::string_view shank_words[] = {"leg",  "lowerleg", "loleg", "lowleg",
                                            "shin", "calf",     "tibia", "knee"};
constexpr std::string_view ankle_words[] = {"ankle"};
constexpr std::string_view foot_words[] = {"foot"};
constexpr std::string_view toe_words[] = {"toe", "toes", "toebase", "ball"};
constexpr std::string_view clavicle_words[] = {"clavicle", "collar"};

/// Parts of a name that say nothing about the joint.
constexpr std::string_view padding[] = {"bip",  "j",   "c",    "jnt",   "joint", "bone", "def",
                                        "bind", "org", "jbip", "biped", "skel",  "char"};

bool contains(Words words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_body_word(std::string_view word) {
  for (Words words : {Words(pelvis_words), Words(head_words), Words(upper_arm_words),
                      Words(shoulder_words), Words(forearm_words), Words(wrist_words),
                      Words(thigh_words), Words(hip_words), Words(shank_words), Words(ankle_words),
                      Words(foot_words), Words(toe_words), Words(clavicle_words)}) {
    if (contains(words, word)) return true;
  }
  return word == "hipjoint";
}

bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool is_lower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Splits at everything that is no letter, at "aB" and before the last capital of "ABc".
std::vector<std::string> tokens_of(std::string_view name) {
  std::vector<std::string> tokens;
  bool open = false;
  for (size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (!is_letter(c)) {
      open = false;
      continue;
    }
    const bool after_lower = i > 0 && is_lower(name[i - 1]);
    const bool before_lower = i + 1 < name.size() && is_lower(name[i + 1]);
    const bool after_upper = i > 0 && is_upper(name[i - 1]);
    if (!open || (is_upper(c) && (after_lower || (after_upper && before_lower)))) {
      tokens.emplace_back();
    }
    open = true;
    tokens.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return tokens;
}

Side side_of(std::string_view token) {
  if (token == "left" || token == "l" || token == "lft") return Side::left;
  if (token == "right" || token == "r" || token == "rgt" || token == "rt") return Side::right;
  return Side::middle;
}

/// "lfemur", "rightfoot": the side is stuck to the word.
void unstick_side(JointWord& joint) {
  for (std::string_view prefix : {"left", "right", "l", "r"}) {
    if (!joint.word.starts_with(prefix)) continue;
    const std::string rest = joint.word.substr(prefix.size());
    if (!is_body_word(rest)) continue;
    joint.side = prefix.front() == 'l' ? Side::left : Side::right;
    joint.word = rest;
    return;
  }
}

/// The joints of a rig with what their names say.
struct NamedRig {
  const Skeleton& rig;
  std::vector<JointWord> words;

  /// First joint of that side with one of the words; −1 when there is none.
  int find(Side side, Words wanted) const {
    for (int j = 0; j < rig.size(); ++j) {
      if (words[j].side == side && contains(wanted, words[j].word)) return j;
    }
    return -1;
  }
};

int first_found(std::initializer_list<int> joints) {
  for (int joint : joints) {
    if (joint >= 0) return joint;
  }
  return -1;
}

bool is_below(const Skeleton& rig, int ancestor, int descendant) {
  return ancestor >= 0 && descendant >= 0 && ancestor != descendant &&
         common_ancestor(rig, ancestor, descendant) == ancestor;
}

/// The joint only when it lies below `above`.
int if_below(const Skeleton& rig, int above, int joint) {
  return is_below(rig, above, joint) ? joint : -1;
}

KeyLimbs limbs_of(const NamedRig& named, Side side) {
  KeyLimbs limbs;
  limbs.upper_arm =
      first_found({named.find(side, upper_arm_words), named.find(side, shoulder_words)});
  limbs.forearm = named.find(side, forearm_words);
  limbs.wrist = if_below(named.rig, limbs.forearm, named.find(side, wrist_words));
  limbs.thigh = first_found({named.find(side, thigh_words), named.find(side, hip_words)});
  limbs.shank = named.find(side, shank_words);
  limbs.ankle = first_found({named.find(side, ankle_words), named.find(side, foot_words)});
  limbs.toe = first_found({named.find(side, toe_words), named.find(side, foot_words)});
  limbs.toe = if_below(named.rig, limbs.ankle, limbs.toe);
  return limbs;
}

bool is_complete(const Skeleton& rig, const KeyLimbs& limbs) {
  return is_below(rig, limbs.upper_arm, limbs.forearm) && is_below(rig, limbs.thigh, limbs.shank) &&
         (limbs.ankle < 0 ? rig.joints[limbs.shank].tip.has_value()
                          : is_below(rig, limbs.shank, limbs.ankle));
}

/// A joint called pelvis from which both legs hang, the lowest such; else where the legs part.
int pelvis_of(const NamedRig& named, int left_thigh, int right_thigh) {
  const int parting = common_ancestor(named.rig, left_thigh, right_thigh);
  for (int j = parting; j >= 0; j = named.rig.joints[j].parent) {
    const bool called_so = named.words[j].side == Side::middle &&
                           (named.words[j].word == "hips" || named.words[j].word == "hip" ||
                            named.words[j].word == "pelvis");
    if (called_so) return j;
  }
  return parting;
}

}  // namespace

JointWord joint_word(std::string_view name) {
  if (const size_t colon = name.rfind(':'); colon != std::string_view::npos) {
    name.remove_prefix(colon + 1);
  }
  if (name.starts_with("mixamorig")) name.remove_prefix(9);
  JointWord joint;
  std::string padded;
  for (const std::string& token : tokens_of(name)) {
    padded += token;
    if (const Side side = side_of(token); side != Side::middle && joint.side == Side::middle) {
      joint.side = side;
    } else if (!contains(padding, token)) {
      joint.word += token;
    }
  }
  if (joint.word.empty()) joint.word = padded;
  if (joint.side == Side::middle) unstick_side(joint);
  return joint;
}

std::optional<KeyJoints> key_joints_by_name(const Skeleton& rig) {
  NamedRig named{rig, {}};
  for (const Joint& joint : rig.joints) named.words.push_back(joint_word(joint.name));
  KeyJoints keys;
  keys.left = limbs_of(named, Side::left);
  keys.right = limbs_of(named, Side::right);
  if (!is_complete(rig, keys.left) || !is_complete(rig, keys.right)) return std::nullopt;
  keys.pelvis = pelvis_of(named, keys.left.thigh, keys.right.thigh);
  keys.chest = common_ancestor(rig, keys.left.upper_arm, keys.right.upper_arm);
  keys.head = if_below(rig, keys.chest, named.find(Side::middle, head_words));
  const bool is_upright = keys.chest == keys.pelvis || is_below(rig, keys.pelvis, keys.chest);
  if (!is_upright) return std::nullopt;
  return keys;
}

std::string rig_family(const Skeleton& rig) {
  struct Family {
    std::string_view name;
    std::array<std::string_view, 3> joints;
  };
  constexpr Family families[] = {
      {"mien", {"LeftClavicle", "LeftShoulder", "Pelvis"}},
      {"cmu-bvh", {"LHipJoint", "LowerBack", "LeftUpLeg"}},
      {"acclaim", {"lfemur", "lhumerus", "lowerback"}},
      {"bandai-namco", {"joint_Root", "UpperLeg_L", "Shoulder_L"}},
      {"xsens", {"Chest4", "LeftCollar", "LeftElbow"}},
      {"optitrack-arena", {"Ab", "LeftCollar", "LeftWrist"}},
      {"motionbuilder", {"LeftUpLeg", "LeftForeArm", "LeftFoot"}},
      {"vrm", {"J_Bip_C_Hips", "J_Bip_L_UpperLeg", "J_Bip_L_LowerArm"}},
      {"smpl", {"left_hip", "left_collar", "spine3"}},
      {"biped", {"Bip01 L Thigh", "Bip01 L UpperArm", "Bip01 Pelvis"}},
  };
  for (const Joint& joint : rig.joints) {
    if (joint.name.starts_with("mixamorig")) return "mixamo";
  }
  for (const Family& family : families) {
    const bool all = std::all_of(family.joints.begin(), family.joints.end(),
                                 [&](std::string_view name) { return find_joint(rig, name) >= 0; });
    if (all) return std::string(family.name);
  }
  return "by names";
}

}  // namespace mien::motion
