#include "motion/rig/canonical_rig.h"

#include <cmath>

#include "motion/skeleton/body.h"
#include "motion/skeleton/recorded_hands.h"

namespace mien::motion {

namespace {

/// Whether the finger joints of a rig, if it has any, are where those of the canonical hand are at
/// rest, seen from the joint before.
bool has_canonical_fingers(const Skeleton& rig) {
  const double least_cosine = std::cos(1 * radians_per_degree);
  for (int joint = 0; joint < finger_joint_count; ++joint) {
    const int found = find_joint(rig, finger_joint_name(joint));
    if (found < 0) continue;
    const Vec3& own = rig.joints[static_cast<size_t>(found)].offset;
    const Vec3 canonical = finger_offset(joint, 1.0);
    if (own.dot(canonical) < least_cosine * own.norm() * canonical.norm()) return false;
  }
  return true;
}

}  // namespace

bool is_canonical_rig(const Skeleton& whole, const Vec3& up) {
  const double least_cosine = std::cos(3 * radians_per_degree);
  const Skeleton rig = without_fingers(whole);
  if (!is_body(rig) || up != Vec3::UnitY() || !has_canonical_fingers(whole)) return false;
  for (const BodyJoint joint : {LeftHip, LeftKnee, LeftAnkle, RightHip, RightKnee, RightAnkle,
                                LeftShoulder, LeftElbow, RightShoulder, RightElbow}) {
    Vec3 bone = rig.joints[static_cast<size_t>(joint) + 1].offset;
    if (joint == LeftAnkle || joint == RightAnkle) bone.y() = 0.0;
    if (!(bone.norm() > 0.0)) return false;
    if (bone.normalized().dot(rest_direction(joint)) < least_cosine) return false;
  }
  return true;
}

void keep_own_tips(const Skeleton& rig, Skeleton& body) {
  for (const BodyJoint wrist : {LeftWrist, RightWrist}) {
    const int found = find_joint(rig, name_of(wrist));
    if (rig.joints[static_cast<size_t>(found)].tip)
      body.joints[wrist].tip = rig.joints[static_cast<size_t>(found)].tip;
  }
}

}  // namespace mien::motion
