#include "motion/rig/mapped_joint.h"

#include <algorithm>
#include <set>
#include <span>

namespace mien::motion {

namespace {

constexpr double between_factor = 0.9;  // a joint that follows from its neighbours is less certain
constexpr double tip_factor = 0.8;
constexpr double shape_factor = 0.8;  // of a named rig: known by what lies round it

/// Fills in groups of one rig; only carries what every step needs.
struct Grouping {
  const Skeleton& rig;
  double confidence;
  const std::string& found_by;
  MappedJoints& joints;

  void put(BodyJoint joint, std::span<const int> group, int position, double factor) {
    if (group.empty()) return;
    joints[joint] = {{group.begin(), group.end()}, position, false, confidence * factor, found_by};
  }

  void put(BodyJoint joint, int rig_joint) { put(joint, std::span(&rig_joint, 1), rig_joint, 1.0); }

  void put_at_tip(BodyJoint joint, int bone) {
    if (!rig.joints[bone].tip || rig.joints[bone].tip->isZero()) return;
    joints[joint] = {{bone}, bone, true, confidence * tip_factor, "end site"};
  }
};

void group_trunk(Grouping& grouping, const KeyJoints& keys) {
  grouping.put(Pelvis, keys.pelvis);
  const std::vector<int> back = path_down(grouping.rig, keys.pelvis, keys.chest);
  if (back.size() == 1) {
    grouping.put(Chest, back, back[0], 1.0);
  } else if (back.size() > 1) {
    const size_t middle = (back.size() + 1) / 2;
    const std::span joints(back);
    grouping.put(Spine, joints.first(middle), back.front(), between_factor);
    grouping.put(Chest, joints.subspan(middle), back[middle], 1.0);
  }
  if (keys.head < 0) {
    const std::vector<int> neck = path_down(grouping.rig, keys.chest, keys.neck);
    if (!neck.empty()) grouping.put(Neck, neck, neck.front(), between_factor);
    return;
  }
  const std::vector<int> neck = path_down(grouping.rig, keys.chest, keys.head);
  if (neck.empty()) return;
  grouping.put(Head, neck.back());
  if (neck.size() == 1) return;
  grouping.put(Neck, std::span(neck).first(neck.size() - 1), neck.front(), between_factor);
}

void group_arm(Grouping& grouping, int chest, const KeyLimbs& keys, BodyJoint clavicle) {
  std::vector<int> shoulder_girdle = path_down(grouping.rig, chest, keys.upper_arm);
  if (!shoulder_girdle.empty()) shoulder_girdle.pop_back();
  if (!shoulder_girdle.empty()) {
    grouping.put(clavicle, shoulder_girdle, shoulder_girdle.front(), between_factor);
  }
  const auto shoulder = BodyJoint(clavicle + 1);
  const auto elbow = BodyJoint(clavicle + 2);
  const auto wrist = BodyJoint(clavicle + 3);
  grouping.put(shoulder, keys.upper_arm);
  grouping.put(elbow, keys.forearm);
  if (keys.wrist >= 0) {
    grouping.put(wrist, keys.wrist);
  } else {
    grouping.put_at_tip(wrist, keys.forearm);
  }
}

void group_leg(Grouping& grouping, int parting, const KeyLimbs& keys, BodyJoint hip) {
  // Joints between pelvis and thigh are struts that hardly turn: the hip sits at the thigh.
  grouping.put(hip, path_down(grouping.rig, parting, keys.thigh), keys.thigh, 1.0);
  const auto knee = BodyJoint(hip + 1);
  const auto ankle = BodyJoint(hip + 2);
  const auto toe = BodyJoint(hip + 3);
  grouping.put(knee, keys.shank);
  if (keys.ankle < 0) {
    grouping.put_at_tip(ankle, keys.shank);
    return;
  }
  grouping.put(ankle, keys.ankle);
  if (keys.toe >= 0) {
    grouping.put(toe, keys.toe);
  } else {
    grouping.put_at_tip(toe, keys.ankle);
  }
}

}  // namespace

bool are_disjoint(const MappedJoints& joints) {
  std::set<int> taken;
  for (const MappedJoint& joint : joints) {
    if (joint.at_tip) continue;
    for (const int one : joint.group) {
      if (!taken.insert(one).second) return false;
    }
  }
  return true;
}

std::vector<int> path_down(const Skeleton& rig, int ancestor, int descendant) {
  std::vector<int> path;
  for (int j = descendant; j != ancestor; j = rig.joints[j].parent) {
    if (j < 0) return {};
    path.push_back(j);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

int common_ancestor(const Skeleton& rig, int a, int b) {
  // Parents come first, so the larger index can never be an ancestor of the smaller.
  while (a != b) (a > b ? a : b) = rig.joints[std::max(a, b)].parent;
  return a;
}

MappedJoints groups_of(const Skeleton& rig, const KeyJoints& keys, double confidence,
                       const std::string& found_by) {
  MappedJoints joints;
  for (MappedJoint& joint : joints) joint.found_by = "missing";
  Grouping grouping{rig, confidence, found_by, joints};
  group_trunk(grouping, keys);
  group_arm(grouping, keys.chest, keys.left, LeftClavicle);
  group_arm(grouping, keys.chest, keys.right, RightClavicle);
  // In some rigs the legs hang on a joint of the spine.
  const int parting = common_ancestor(rig, keys.left.thigh, keys.right.thigh);
  group_leg(grouping, parting, keys.left, LeftHip);
  group_leg(grouping, parting, keys.right, RightHip);
  for (MappedJoint& joint : joints) {
    const auto found = std::find(keys.by_shape.begin(), keys.by_shape.end(), joint.position);
    if (joint.at_tip || found == keys.by_shape.end()) continue;
    joint.confidence *= shape_factor;
    joint.found_by = "topology";
  }
  return joints;
}

}  // namespace mien::motion
