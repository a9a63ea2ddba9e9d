#include "motion/points/rig_joint_roles.h"

#include <initializer_list>
#include <string_view>

#include "motion/rig/joint_word.h"

namespace mien::motion {

namespace {

using namespace joint_words;
using enum Landmark;

constexpr std::string_view hips_words[] = {"hips", "hip", "pelvis"};
constexpr std::string_view neck_words[] = {"neck", "lowerneck"};
constexpr std::string_view hand_words[] = {"hand", "palm"};
constexpr std::string_view toe_end_words[] = {"toeend", "toesend", "toebaseend", "toenub"};
constexpr std::string_view head_end_words[] = {"headtop", "headtopend", "headend", "headnub"};

// Joints of the back, from low to high.
constexpr std::string_view low_back_words[] = {"lowerback", "ab", "abdomen", "waist"};
constexpr std::string_view spine_words[] = {"spine"};
constexpr std::string_view chest_words[] = {"upperback", "torso", "chest"};
constexpr std::string_view upper_chest_words[] = {"thorax", "upperchest"};

class RigJoints {
 public:
  explicit RigJoints(std::span<const std::string> names) : roles_(names.size()) {
    for (const std::string& name : names) words_.push_back(joint_word(name));
  }

  /// Gives the role to the first point with one of the words, unless it has another role already.
  bool give(JointWord::Side side, Words wanted, Landmark landmark) {
    for (std::size_t point = 0; point < words_.size(); ++point) {
      if (words_[point].side != side || !is_among(wanted, words_[point].word)) continue;
      if (roles_[point]) continue;
      roles_[point] = Role{landmark, side_of(side)};
      return true;
    }
    return false;
  }

  /// Whether all joints that a rig needs on a side are there.
  bool give_limbs(JointWord::Side side) {
    const bool has_arm = give(side, upper_arm_words, shoulder);
    const bool has_forearm = give(side, forearm_words, elbow);
    if (!give(side, clavicle_words, clavicle) && has_arm) give(side, shoulder_words, clavicle);
    const bool has_shoulder = has_arm || give(side, shoulder_words, shoulder);
    constexpr std::string_view wrist_word[] = {"wrist"};
    if (!give(side, wrist_word, wrist)) give(side, hand_words, wrist);
    give(side, hand_words, hand);
    const bool has_thigh = give(side, thigh_words, hip) || give(side, hip_words, hip);
    const bool has_shank = give(side, shank_words, knee);
    const bool has_foot = give(side, ankle_words, ankle) || give(side, foot_words, ankle);
    if (!give(side, toe_words, toe)) give(side, foot_words, toe);
    give(side, toe_end_words, toe_tip);
    return has_shoulder && has_forearm && has_thigh && has_shank && has_foot;
  }

  void give_trunk() {
    constexpr JointWord::Side middle = JointWord::Side::middle;
    give(middle, hips_words, pelvis);
    give(middle, neck_words, neck);
    give(middle, head_words, head);
    give(middle, head_end_words, head_top);
    std::vector<std::size_t> back;
    for (const Words words : {Words(low_back_words), Words(spine_words), Words(chest_words),
                              Words(upper_chest_words)}) {
      for (std::size_t point = 0; point < words_.size(); ++point) {
        if (words_[point].side == middle && is_among(words, words_[point].word))
          back.push_back(point);
      }
    }
    if (back.empty()) return;
    if (back.size() > 1) roles_[back.front()] = Role{spine, Side::middle};
    const std::size_t chest_joint = back.size() == 1 ? 0 : (back.size() + 1) / 2;
    roles_[back[chest_joint]] = Role{chest, Side::middle};
  }

  const std::vector<std::optional<Role>>& roles() const { return roles_; }

 private:
  static Side side_of(JointWord::Side side) {
    if (side == JointWord::Side::middle) return Side::middle;
    return side == JointWord::Side::left ? Side::left : Side::right;
  }

  std::vector<JointWord> words_;
  std::vector<std::optional<Role>> roles_;
};

}  // namespace

std::vector<std::optional<Role>> rig_joint_roles(std::span<const std::string> names) {
  RigJoints joints(names);
  for (const JointWord::Side side : {JointWord::Side::left, JointWord::Side::right}) {
    if (!joints.give_limbs(side)) return std::vector<std::optional<Role>>(names.size());
  }
  joints.give_trunk();
  return joints.roles();
}

}  // namespace mien::motion
