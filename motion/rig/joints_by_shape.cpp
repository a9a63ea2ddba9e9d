#include "motion/rig/joints_by_shape.h"

#include <algorithm>
#include <array>
#include <span>

#include "motion/rig/joint_word.h"

namespace mien::motion {

namespace {

using Slot = int KeyLimbs::*;

constexpr std::array<Slot, 3> arm_slots = {&KeyLimbs::upper_arm, &KeyLimbs::forearm,
                                           &KeyLimbs::wrist};
constexpr std::array<Slot, 4> leg_slots = {&KeyLimbs::thigh, &KeyLimbs::shank, &KeyLimbs::ankle,
                                           &KeyLimbs::toe};

/// A limb with gaps, and its counterpart on the other side.
struct GappedLimb {
  const BoneTree& tree;
  std::span<const Slot> slots;
  KeyLimbs& limbs;
  const KeyLimbs& other;

  const Skeleton& rig() const { return tree.rig; }
  int at(size_t slot) const { return limbs.*slots[slot]; }

  /// Joints from slot `upper` down to slot `lower` on the other side; 0 if unknown.
  size_t steps_on_other_side(size_t upper, size_t lower) const {
    const int from = other.*slots[upper];
    const int to = other.*slots[lower];
    return from < 0 || to < 0 ? 0 : path_down(rig(), from, to).size();
  }

  /// The joint strictly between two slots that divides the chain best.
  int between(size_t upper, size_t slot, size_t lower) const {
    std::vector<int> way = path_down(rig(), at(upper), at(lower));
    if (way.size() < 2) return -1;
    way.pop_back();
    const size_t steps = steps_on_other_side(upper, slot);
    if (steps > 0 && steps <= way.size()) return way[steps - 1];
    double whole = tree.bone[at(lower)];
    for (const int joint : way) whole += tree.bone[joint];
    int best = way.front();
    double farthest = -1.0;
    double above = 0.0;
    for (const int joint : way) {
      above += tree.bone[joint];
      const double shorter = std::min(above, whole - above);
      if (shorter <= farthest) continue;
      farthest = shorter;
      best = joint;
    }
    return best;
  }

  /// The joint above a known slot by as many joints as on the other side, on this limb alone.
  int above(size_t slot, size_t lower) const {
    size_t steps = steps_on_other_side(slot, lower);
    if (steps == 0) steps = lower - slot;
    int joint = at(lower);
    for (; steps > 0 && joint >= 0; --steps) joint = rig().joints[joint].parent;
    if (joint < 0) return -1;
    for (const Slot one : slots) {
      const int across = other.*one;
      if (across >= 0 && common_ancestor(rig(), joint, across) == joint) return -1;
    }
    return joint;
  }

  /// Whether a joint may be the end of the bone that begins at the slot before it.
  bool is_end_of_bone(size_t slot, int joint, double length) const {
    const std::string_view name = rig().joints[joint].name;
    const std::string word = joint_word(name).word;
    if (word.find("twist") != std::string::npos || word.find("roll") != std::string::npos)
      return false;
    // Against the bone before: a forearm, shank or foot is no fraction and no multiple of it.
    const bool is_toe = slots[slot] == &KeyLimbs::toe;
    const double before = tree.bone[at(slot - 1)];
    if (before <= 0.0) return true;
    return is_toe ? length > 0.08 * before && length < before
                  : length > 0.4 * before && length < 2.5 * before;
  }

  int below(size_t slot) const {
    const size_t steps = std::max<size_t>(1, steps_on_other_side(slot - 1, slot));
    int joint = at(slot - 1);
    double length = 0.0;
    for (size_t i = 0; i < steps && joint >= 0; ++i) {
      joint = main_child_of(tree, joint);
      if (joint >= 0) length += tree.bone[joint];
    }
    if (joint < 0 || !is_end_of_bone(slot, joint, length)) return -1;
    return joint;
  }

  int found_by_shape(size_t slot) const {
    size_t lower = slot + 1;
    while (lower < slots.size() && at(lower) < 0) ++lower;
    const bool ends_here = lower == slots.size();
    if (slot == 0) return ends_here ? -1 : above(slot, lower);
    if (at(slot - 1) < 0) return -1;
    return ends_here ? below(slot) : between(slot - 1, slot, lower);
  }

  void fill(std::vector<int>& by_shape) {
    for (size_t slot = 0; slot < slots.size(); ++slot) {
      if (at(slot) >= 0) continue;
      const int joint = found_by_shape(slot);
      if (joint < 0) continue;
      limbs.*slots[slot] = joint;
      by_shape.push_back(joint);
    }
  }
};

bool is_at_or_above(const Skeleton& rig, int joint, int other) {
  return other >= 0 && common_ancestor(rig, joint, other) == joint;
}

/// The child of the chest that leads up: called neck, else with the longest way to go.
int head_side_child(const BoneTree& tree, const KeyJoints& keys) {
  int best = -1;
  for (const int child : tree.children[keys.chest]) {
    const JointWord word = joint_word(tree.rig.joints[child].name);
    const BodyRegion part = body_region_of(word);
    const bool is_limb = is_at_or_above(tree.rig, child, keys.left.upper_arm) ||
                         is_at_or_above(tree.rig, child, keys.right.upper_arm) ||
                         is_at_or_above(tree.rig, child, keys.left.thigh) ||
                         is_at_or_above(tree.rig, child, keys.right.thigh) ||
                         part == BodyRegion::arm || part == BodyRegion::leg;
    if (is_limb || word.side != JointWord::Side::middle) continue;
    if (part == BodyRegion::head) return child;
    if (best < 0 || tree.length_through(child) > tree.length_through(best)) best = child;
  }
  return best;
}

bool is_called_neck(const BoneTree& tree, int joint) {
  return joint_word(tree.rig.joints[joint].name).word.find("neck") != std::string::npos;
}

/// Whether a joint is but the end of the bone before it.
bool is_bare_end(const BoneTree& tree, int joint) {
  const Joint& end = tree.rig.joints[joint];
  return tree.children[joint].empty() && !end.tip && names_an_end(end.name);
}

/// The crown of a head, "HeadTop".
bool is_crown(const BoneTree& tree, int joint) {
  const Joint& end = tree.rig.joints[joint];
  return tree.children[joint].empty() && !end.tip && joint_word(end.name).word.ends_with("top");
}

/// Whether the way up ends at a joint, because what follows is carried by the head: eyes, jaw,
/// hair.
bool is_carrier(const BoneTree& tree, int joint) {
  const std::vector<int>& children = tree.children[joint];
  if (children.empty()) return true;
  if (is_called_neck(tree, joint)) return false;
  if (children.size() == 1) {
    return is_bare_end(tree, children.front()) || is_crown(tree, children.front());
  }
  const auto goes_on = [&](int child) { return !tree.children[child].empty(); };
  const auto has_side = [&](int child) {
    return joint_word(tree.rig.joints[child].name).side != JointWord::Side::middle;
  };
  return children.size() > 2 || std::any_of(children.begin(), children.end(), has_side) ||
         std::count_if(children.begin(), children.end(), goes_on) != 1;
}

}  // namespace

void fill_limbs_by_shape(const BoneTree& tree, KeyJoints& keys) {
  const KeyLimbs left = keys.left;
  const KeyLimbs right = keys.right;
  GappedLimb{tree, arm_slots, keys.left, right}.fill(keys.by_shape);
  GappedLimb{tree, arm_slots, keys.right, left}.fill(keys.by_shape);
  GappedLimb{tree, leg_slots, keys.left, right}.fill(keys.by_shape);
  GappedLimb{tree, leg_slots, keys.right, left}.fill(keys.by_shape);
}

void find_head_by_shape(const BoneTree& tree, KeyJoints& keys) {
  int joint = head_side_child(tree, keys);
  if (joint < 0) return;
  while (!is_carrier(tree, joint)) {
    const int next = main_child_of(tree, joint);
    if (is_bare_end(tree, next)) break;
    joint = next;
  }
  // Of two joints called neck the upper one does the turns of the head.
  const bool is_lone_neck =
      is_called_neck(tree, joint) && tree.rig.joints[joint].parent == keys.chest;
  (is_lone_neck ? keys.neck : keys.head) = joint;
  keys.by_shape.push_back(joint);
}

}  // namespace mien::motion
