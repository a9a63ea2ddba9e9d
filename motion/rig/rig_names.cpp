#include "motion/rig/rig_names.h"

#include <algorithm>
#include <array>
#include <vector>

#include "motion/rig/joints_by_shape.h"

namespace mien::motion {

namespace {

using Side = JointWord::Side;
using namespace joint_words;

/// The joints of a rig with what their names say.
struct NamedRig {
  const Skeleton& rig;
  std::vector<JointWord> words;

  /// First joint of that side with one of the words; −1 when there is none.
  int find(Side side, Words wanted) const {
    for (int j = 0; j < rig.size(); ++j) {
      if (words[j].side == side && is_among(wanted, words[j].word)) return j;
    }
    return -1;
  }

  bool has(Side side, const std::string& word) const {
    return find(side, std::array<std::string_view, 1>{word}) >= 0;
  }
};

/// Length of what all names begin with, up to a separator: "Anna_" of "Anna_Hips", "Anna_LeftArm".
size_t common_prefix(const Skeleton& rig) {
  if (rig.size() < 2) return 0;
  std::string_view prefix = rig.joints.front().name;
  for (const Joint& joint : rig.joints) {
    const auto parted =
        std::mismatch(prefix.begin(), prefix.end(), joint.name.begin(), joint.name.end());
    prefix = prefix.substr(0, static_cast<size_t>(parted.first - prefix.begin()));
  }
  const size_t separator = prefix.find_last_of("_:.- ");
  return separator == std::string_view::npos ? 0 : separator + 1;
}

NamedRig named_rig(const Skeleton& rig) {
  NamedRig named{rig, {}};
  const size_t prefix = common_prefix(rig);
  for (const Joint& joint : rig.joints)
    named.words.push_back(joint_word(std::string_view(joint.name).substr(prefix)));
  return named;
}

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

/// The joint only when it lies below `above`; where nothing is known above, as it is.
int if_below(const Skeleton& rig, int above, int joint) {
  return above < 0 || is_below(rig, above, joint) ? joint : -1;
}

KeyLimbs limbs_of(const NamedRig& named, Side side) {
  KeyLimbs limbs;
  limbs.upper_arm =
      first_found({named.find(side, upper_arm_words), named.find(side, shoulder_words)});
  limbs.forearm = named.find(side, forearm_words);
  limbs.wrist = named.find(side, wrist_words);
  limbs.thigh = first_found({named.find(side, thigh_words), named.find(side, hip_words)});
  limbs.shank = named.find(side, shank_words);
  limbs.ankle = first_found({named.find(side, ankle_words), named.find(side, foot_words)});
  limbs.toe = first_found({named.find(side, toe_words), named.find(side, foot_words)});
  return limbs;
}

/// A word means the same on both sides. Where one side has lost the name of a joint, the word of
/// the next one would be taken for it: "LeftShoulder" for the upper arm of a rig whose other side
/// has RightShoulder and RightArm.
void settle_meanings(const NamedRig& named, KeyLimbs& left, KeyLimbs& right) {
  for (int KeyLimbs::*const slot :
       {&KeyLimbs::upper_arm, &KeyLimbs::forearm, &KeyLimbs::wrist, &KeyLimbs::thigh,
        &KeyLimbs::shank, &KeyLimbs::ankle, &KeyLimbs::toe}) {
    if (left.*slot < 0 || right.*slot < 0) continue;
    const std::string& left_word = named.words[left.*slot].word;
    const std::string& right_word = named.words[right.*slot].word;
    if (left_word == right_word) continue;
    if (named.has(Side::right, left_word)) {
      left.*slot = -1;
    } else if (named.has(Side::left, right_word)) {
      right.*slot = -1;
    }
  }
}

/// Leaves out what hangs elsewhere, such as a foot that a robot steers by itself.
void keep_ends_below(const Skeleton& rig, KeyLimbs& limbs) {
  limbs.wrist = if_below(rig, first_found({limbs.forearm, limbs.upper_arm}), limbs.wrist);
  limbs.ankle = if_below(rig, first_found({limbs.shank, limbs.thigh}), limbs.ankle);
  limbs.toe = if_below(rig, first_found({limbs.ankle, limbs.shank, limbs.thigh}), limbs.toe);
}

bool is_complete(const Skeleton& rig, const KeyLimbs& limbs) {
  return is_below(rig, limbs.upper_arm, limbs.forearm) && is_below(rig, limbs.thigh, limbs.shank) &&
         (limbs.ankle < 0 ? rig.joints[limbs.shank].tip.has_value()
                          : is_below(rig, limbs.shank, limbs.ankle));
}

/// A joint called pelvis from which both legs hang, the lowest such; else where the legs and the
/// trunk part, but never a joint called spine.
int pelvis_of(const NamedRig& named, const KeyJoints& keys) {
  const Skeleton& rig = named.rig;
  const int parting = common_ancestor(rig, keys.left.thigh, keys.right.thigh);
  for (int j = parting; j >= 0; j = rig.joints[j].parent) {
    const bool called_so = named.words[j].side == Side::middle &&
                           (named.words[j].word == "hips" || named.words[j].word == "hip" ||
                            named.words[j].word == "pelvis");
    if (called_so) return j;
  }
  const int trunk = common_ancestor(rig, parting, keys.chest);
  const bool is_spine = named.words[trunk].word.starts_with("spine");
  return is_spine && rig.joints[trunk].parent >= 0 ? rig.joints[trunk].parent : trunk;
}

}  // namespace

std::optional<KeyJoints> key_joints_by_name(const BoneTree& tree) {
  const Skeleton& rig = tree.rig;
  const NamedRig named = named_rig(rig);
  KeyJoints keys;
  keys.left = limbs_of(named, Side::left);
  keys.right = limbs_of(named, Side::right);
  settle_meanings(named, keys.left, keys.right);
  keep_ends_below(rig, keys.left);
  keep_ends_below(rig, keys.right);
  fill_limbs_by_shape(tree, keys);
  if (!is_complete(rig, keys.left) || !is_complete(rig, keys.right)) return std::nullopt;
  keys.chest = common_ancestor(rig, keys.left.upper_arm, keys.right.upper_arm);
  keys.pelvis = pelvis_of(named, keys);
  const bool is_upright = keys.chest == keys.pelvis || is_below(rig, keys.pelvis, keys.chest);
  if (!is_upright) return std::nullopt;
  const int head = named.find(Side::middle, head_words);
  if (is_below(rig, keys.chest, head)) {
    keys.head = head;
  } else {
    find_head_by_shape(tree, keys);
  }
  if (!are_disjoint(groups_of(rig, keys, 1.0, "name"))) return std::nullopt;
  return keys;
}

std::optional<KeyJoints> key_joints_by_name(const Skeleton& rig) {
  return key_joints_by_name(bone_tree(rig, {}));
}

int other_figure_in(const Skeleton& rig, const KeyJoints& keys) {
  const NamedRig named = named_rig(rig);
  int other = -1;
  for (const KeyLimbs& limbs : {keys.left, keys.right}) {
    for (const int own : {limbs.upper_arm, limbs.forearm, limbs.thigh, limbs.shank}) {
      const JointWord& word = named.words[own];
      int twin = -1;
      for (int j = 0; j < rig.size() && twin < 0; ++j) {
        const bool is_same = named.words[j].side == word.side && named.words[j].word == word.word;
        if (is_same && j != own && !is_below(rig, keys.pelvis, j)) twin = j;
      }
      if (twin < 0 || word.side == Side::middle) return -1;
      if (other < 0) other = twin;
    }
  }
  return other;
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
      {"xsens-mvn", {"T12", "T8", "LeftForeArm"}},
      {"optitrack-arena", {"Ab", "LeftCollar", "LeftWrist"}},
      {"motionbuilder", {"LeftUpLeg", "LeftForeArm", "LeftFoot"}},
      {"vrm", {"J_Bip_C_Hips", "J_Bip_L_UpperLeg", "J_Bip_L_LowerArm"}},
      {"vrm", {"hips", "leftUpperLeg", "leftLowerArm"}},
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
