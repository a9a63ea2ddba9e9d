#include "motion/rig/rig_topology.h"

#include <algorithm>
#include <cmath>

#include "motion/math/rotation.h"
#include "motion/rig/bone_tree.h"
#include "motion/rig/joint_word.h"

namespace mien::motion {

namespace {

/// Two chains of one fork with the same bones.
struct Pair {
  int fork = -1;
  std::vector<int> a;
  std::vector<int> b;
  double length = 0.0;
};

bool mirror_like(const BoneTree& tree, const std::vector<int>& a, const std::vector<int>& b) {
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i) {
    const double la = tree.bone[a[i]];
    const double lb = tree.bone[b[i]];
    if (std::abs(la - lb) > 0.15 * std::max(la, lb) + 0.01 * tree.size) return false;
  }
  return true;
}

/// The mirrored pairs long enough to be limbs, longest first.
std::vector<Pair> limb_pairs(const BoneTree& tree) {
  std::vector<Pair> pairs;
  for (int fork = 0; fork < tree.rig.size(); ++fork) {
    const auto& children = tree.children[fork];
    for (size_t i = 0; i < children.size(); ++i) {
      for (size_t k = i + 1; k < children.size(); ++k) {
        Pair pair{fork, longest_chain(tree, children[i]), longest_chain(tree, children[k]),
                  tree.bone[children[i]] + tree.reach[children[i]]};
        const bool long_enough = pair.length > 0.25 * tree.size && pair.a.size() >= 3;
        if (long_enough && mirror_like(tree, pair.a, pair.b)) pairs.push_back(std::move(pair));
      }
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& p, const Pair& q) { return p.length > q.length; });
  return pairs;
}

bool is_leaf_that_never_turns(const Recording& recording, const BoneTree& tree, int joint) {
  if (!tree.children[joint].empty() || tree.rig.joints[joint].tip) return false;
  const Quat& first = recording.poses.front().rotations[joint];
  return std::all_of(recording.poses.begin(), recording.poses.end(), [&](const Pose& pose) {
    return angle_between(first, pose.rotations[joint]) < 1e-6;
  });
}

/// The longest single chain from the fork of the arms that is neither arm nor the way to the legs.
std::vector<int> head_chain(const Recording& recording, const BoneTree& tree, const Pair& arms,
                            int legs_fork) {
  int start = -1;
  for (int child : tree.children[arms.fork]) {
    const bool to_legs = common_ancestor(tree.rig, child, legs_fork) == child;
    if (child == arms.a.front() || child == arms.b.front() || to_legs) continue;
    if (start < 0 || tree.bone[child] + tree.reach[child] > tree.bone[start] + tree.reach[start]) {
      start = child;
    }
  }
  if (start < 0) return {};
  std::vector<int> chain = longest_chain(tree, start);
  if (chain.size() > 2 && is_leaf_that_never_turns(recording, tree, chain.back())) chain.pop_back();
  return chain;
}

/// Index in `a` of the proximal joint of the two longest bones in a row, both off the midline; −1
/// when there are no two. Joints where both chains coincide lie on the midline.
int first_long_bone(const BoneTree& tree, const JointTransforms& world, const Pair& pair) {
  int best = -1;
  double longest = 0.0;
  for (size_t i = 0; i + 2 < pair.a.size() + 1; ++i) {
    const bool on_midline =
        (world.positions[pair.a[i]] - world.positions[pair.b[i]]).norm() < 0.02 * tree.size;
    if (on_midline || i + 1 >= pair.a.size()) continue;
    const double upper = tree.bone[pair.a[i + 1]];
    const bool has_joint_below = i + 2 < pair.a.size();
    const double lower =
        has_joint_below ? tree.bone[pair.a[i + 2]] : tree.tip_length(pair.a[i + 1]);
    if (upper + lower > longest) {
      longest = upper + lower;
      best = static_cast<int>(i);
    }
  }
  return best;
}

int at_or_none(const std::vector<int>& chain, int index) {
  return index >= 0 && index < static_cast<int>(chain.size()) ? chain[index] : -1;
}

void put_arm(KeyLimbs& limbs, const std::vector<int>& chain, int first) {
  limbs.upper_arm = at_or_none(chain, first);
  limbs.forearm = at_or_none(chain, first + 1);
  limbs.wrist = at_or_none(chain, first + 2);
}

void put_leg(KeyLimbs& limbs, const std::vector<int>& chain, int first) {
  limbs.thigh = at_or_none(chain, first);
  limbs.shank = at_or_none(chain, first + 1);
  limbs.ankle = at_or_none(chain, first + 2);
  limbs.toe = at_or_none(chain, first + 3);
}

/// Where the middle joint of a limb lies off the line between its ends, unit; zero when the limb is
/// bent less than 15°.
Vec3 bend_direction(const Vec3& proximal, const Vec3& middle, const Vec3& distal) {
  const Vec3 upper = (middle - proximal).normalized();
  const Vec3 lower = (distal - middle).normalized();
  const bool bent = upper.dot(lower) < std::cos(15 * radians_per_degree);
  return bent ? Vec3((upper - lower).normalized()) : Vec3(Vec3::Zero());
}

/// What one leg and one arm say for `forward`: knees bend forward (±2), toes point there (±1), and
/// elbows bend the other way (±1). 0 where there is nothing to see.
double limb_votes(const Skeleton& rig, const JointTransforms& world, const KeyLimbs& limbs,
                  const Vec3& forward) {
  const auto& p = world.positions;
  double votes = 0.0;
  if (limbs.ankle >= 0) {
    Vec3 foot = Vec3::Zero();
    if (limbs.toe >= 0) foot = p[limbs.toe] - p[limbs.ankle];
    if (limbs.toe < 0 && rig.joints[limbs.ankle].tip) {
      foot = world.rotations[limbs.ankle] * *rig.joints[limbs.ankle].tip;
    }
    const double leg = (p[limbs.ankle] - p[limbs.thigh]).norm();
    if (foot.norm() > 1e-3 * leg) votes += foot.normalized().dot(forward);
    votes += 2.0 * bend_direction(p[limbs.thigh], p[limbs.shank], p[limbs.ankle]).dot(forward);
  }
  if (limbs.wrist >= 0) {
    votes -= bend_direction(p[limbs.upper_arm], p[limbs.forearm], p[limbs.wrist]).dot(forward);
  }
  return votes;
}

/// Puts the arm on the left of the chest that lies to the left of the hips.
void sort_arms(const std::vector<JointTransforms>& world, KeyJoints& keys) {
  double same_side = 0.0;
  for (const JointTransforms& frame : world) {
    const auto& p = frame.positions;
    same_side += (p[keys.left.upper_arm] - p[keys.right.upper_arm])
                     .dot(p[keys.left.thigh] - p[keys.right.thigh]);
  }
  if (same_side >= 0) return;
  std::swap(keys.left.upper_arm, keys.right.upper_arm);
  std::swap(keys.left.forearm, keys.right.forearm);
  std::swap(keys.left.wrist, keys.right.wrist);
}

std::optional<KeyJoints> keys_of(const Recording& recording, const BoneTree& tree,
                                 const JointTransforms& world, const Pair& legs, const Pair& arms) {
  const int first_leg = first_long_bone(tree, world, legs);
  const int first_arm = first_long_bone(tree, world, arms);
  if (first_leg < 0 || first_arm < 0) return std::nullopt;
  KeyJoints keys;
  keys.pelvis = legs.fork;
  keys.chest = arms.fork;
  const std::vector<int> neck = head_chain(recording, tree, arms, legs.fork);
  if (!neck.empty()) keys.head = neck.back();
  put_leg(keys.left, legs.a, first_leg);
  put_leg(keys.right, legs.b, first_leg);
  put_arm(keys.left, arms.a, first_arm);
  put_arm(keys.right, arms.b, first_arm);
  return keys;
}

/// Two pairs at different forks, one above the other, as (legs, arms).
std::optional<std::pair<Pair, Pair>> legs_and_arms(const Recording& recording, const BoneTree& tree,
                                                   const Pair& one, const Pair& other) {
  if (one.fork == other.fork) return std::nullopt;
  const int meeting = common_ancestor(tree.rig, one.fork, other.fork);
  if (meeting != one.fork && meeting != other.fork) return std::nullopt;
  const Pair& upper = meeting == one.fork ? one : other;
  const Pair& lower = meeting == one.fork ? other : one;
  // Usually the root is the pelvis and the neck leaves where the deeper fork is.
  const bool neck_is_deep = !head_chain(recording, tree, lower, upper.fork).empty();
  return neck_is_deep ? std::pair(upper, lower) : std::pair(lower, upper);
}

/// Whether a joint's name states another part of the body.
bool is_contradicted(const Skeleton& rig, int joint, BodyRegion part) {
  if (joint < 0) return false;
  const BodyRegion named = body_region_of(joint_word(rig.joints[joint].name));
  return named != BodyRegion::other && named != part;
}

bool names_contradict(const Skeleton& rig, const KeyJoints& keys) {
  for (const KeyLimbs& limbs : {keys.left, keys.right}) {
    for (const int joint : {limbs.upper_arm, limbs.forearm, limbs.wrist}) {
      if (is_contradicted(rig, joint, BodyRegion::arm)) return true;
    }
    for (const int joint : {limbs.thigh, limbs.shank, limbs.ankle, limbs.toe}) {
      if (is_contradicted(rig, joint, BodyRegion::leg)) return true;
    }
  }
  return is_contradicted(rig, keys.head, BodyRegion::head) ||
         is_contradicted(rig, keys.pelvis, BodyRegion::other) ||
         is_contradicted(rig, keys.chest, BodyRegion::other);
}

/// Whether these joints can be those of a human. The body hangs from the pelvis: a rig rooted at
/// the chest cannot be followed.
bool are_usable(const Skeleton& rig, const KeyJoints& keys) {
  return !path_down(rig, keys.pelvis, keys.chest).empty() && !names_contradict(rig, keys) &&
         are_disjoint(groups_of(rig, keys, 1.0, "topology"));
}

/// The key joints by the longest two pairs of limbs that can be legs and arms.
std::optional<KeyJoints> likeliest_keys(const Recording& recording, const BoneTree& tree,
                                        const JointTransforms& world) {
  constexpr size_t most_tried = 16;
  std::vector<Pair> pairs = limb_pairs(tree);
  if (pairs.size() > most_tried) pairs.resize(most_tried);
  for (size_t i = 0; i < pairs.size(); ++i) {
    for (size_t k = i + 1; k < pairs.size(); ++k) {
      const auto limbs = legs_and_arms(recording, tree, pairs[i], pairs[k]);
      if (!limbs) continue;
      std::optional<KeyJoints> keys = keys_of(recording, tree, world, limbs->first, limbs->second);
      if (keys && are_usable(tree.rig, *keys)) return keys;
    }
  }
  return std::nullopt;
}

}  // namespace

double forward_votes(const Recording& recording, const std::vector<JointTransforms>& world,
                     const KeyJoints& keys) {
  double votes = 0.0;
  const size_t stride = std::max<size_t>(1, world.size() / 64);
  int count = 0;
  for (size_t t = 0; t < world.size(); t += stride, ++count) {
    const auto& p = world[t].positions;
    const Vec3 hips = 0.5 * (p[keys.left.thigh] + p[keys.right.thigh]);
    const Vec3 up = (p[keys.chest] - hips).normalized();
    const Vec3 forward = (p[keys.left.thigh] - p[keys.right.thigh]).cross(up).normalized();
    votes += limb_votes(recording.skeleton, world[t], keys.left, forward);
    votes += limb_votes(recording.skeleton, world[t], keys.right, forward);
    const size_t next = std::min(t + stride, world.size() - 1);
    const Vec3 travel = world[next].positions[keys.pelvis] - p[keys.pelvis];
    const double leg =
        (p[keys.left.ankle < 0 ? keys.left.shank : keys.left.ankle] - p[keys.left.thigh]).norm();
    votes += std::clamp(travel.dot(forward) / (0.2 * leg + 1e-12), -1.0, 1.0);
  }
  return votes / std::max(1, count);
}

std::optional<TopologyGuess> key_joints_by_topology(const Recording& recording,
                                                    const std::vector<JointTransforms>& world) {
  // Chains are compared with each other, so the work grows with the square of the joints. Rigs with
  // hands, faces, hair and clothes have a quarter of these.
  constexpr int most_joints = 4096;
  if (world.empty() || recording.skeleton.size() > most_joints) return std::nullopt;
  const BoneTree tree = bone_tree(recording.skeleton, world);
  std::optional<KeyJoints> keys = likeliest_keys(recording, tree, world.front());
  if (!keys) return std::nullopt;
  sort_arms(world, *keys);
  const double votes = forward_votes(recording, world, *keys);
  if (votes < 0) std::swap(keys->left, keys->right);
  return TopologyGuess{*keys, std::clamp(0.5 + 0.15 * std::abs(votes), 0.5, 0.9)};
}

}  // namespace mien::motion
