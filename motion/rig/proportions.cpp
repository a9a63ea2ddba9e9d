#include "motion/rig/proportions.h"

#include "motion/math/percentile.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

constexpr double leg_per_stature = 0.491;    // thigh .245 + shank .246 (Winter 2009, after Drillis)
constexpr double stature_of_offsets = 1.75;  // metres: stature that the filled-in offsets belong to

/// Fills in the offsets of one body.
struct BodyFitter {
  std::span<const RigMotion> motions;
  const std::array<Quat, body_joint_count>& constants;
  double stature;  ///< rig units
  Skeleton body;

  const RigMotion& rig() const { return motions.front(); }
  double scaled(double metres) const { return metres * stature / stature_of_offsets; }
  Vec3& offset(BodyJoint joint) { return body.joints[joint].offset; }
};

/// The canonical joint above that the rig really turns; offsets are measured in its frame. Joints
/// between are still on it.
BodyJoint turning_parent(const RigMotion& motion, BodyJoint joint) {
  int parent = body_parents[joint];
  while (parent > Pelvis && !motion.turns(BodyJoint(parent))) parent = body_parents[parent];
  return BodyJoint(parent);
}

/// Mean offset of `joint` from `base` in the canonical frame of `base`.
Vec3 mean_offset(const BodyFitter& fitter, BodyJoint base, BodyJoint joint) {
  Vec3 sum = Vec3::Zero();
  double count = 0.0;
  for (const RigMotion& motion : fitter.motions) {
    for (const JointTransforms& frame : motion.frames) {
      const Quat frame_of_base = canonical_rotation(motion, frame, base, fitter.constants[base]);
      sum += frame_of_base.conjugate() * (motion.point(frame, joint) - motion.point(frame, base));
      count += 1.0;
    }
  }
  return sum / count;
}

/// Sum of the offsets already given to the joints strictly between `base` and `joint`.
Vec3 offset_between(const BodyFitter& fitter, BodyJoint base, BodyJoint joint) {
  Vec3 given = Vec3::Zero();
  for (int j = body_parents[joint]; j != base; j = body_parents[j]) {
    given += fitter.body.joints[j].offset;
  }
  return given;
}

void fit_present(BodyFitter& fitter, BodyJoint joint) {
  const BodyJoint base = turning_parent(fitter.rig(), joint);
  fitter.offset(joint) = mean_offset(fitter, base, joint) - offset_between(fitter, base, joint);
}

void fit_missing(BodyFitter& fitter, BodyJoint joint) {
  const RigMotion& rig = fitter.rig();
  const Vec3 along = rest_direction(BodyJoint(body_parents[joint]));
  switch (joint) {
    case Neck:
      fitter.offset(joint) = rig.has(Head)
                                 ? Vec3(0.7 * mean_offset(fitter, turning_parent(rig, joint), Head))
                                 : Vec3(fitter.scaled(0.24) * along);
      break;
    case Head:
      fitter.offset(joint) = fitter.scaled(0.10) * along;
      break;
    case LeftClavicle:
    case RightClavicle: {
      const auto shoulder = BodyJoint(joint + 1);
      const Vec3 whole = mean_offset(fitter, turning_parent(rig, joint), shoulder);
      fitter.offset(joint) = Vec3(0.1 * whole.x(), whole.y(), whole.z());
      break;
    }
    case LeftWrist:
    case RightWrist:
      fitter.offset(joint) = fitter.scaled(0.265) * along;
      break;
    case LeftToe:
    case RightToe:
      fitter.offset(joint) =
          Vec3(0.0, -ankle_height(fitter.motions, BodyJoint(joint - 1)), fitter.scaled(0.13));
      break;
    default:
      fitter.offset(joint) = Vec3::Zero();
  }
}

/// The end of the head, a hand or a foot: the rig's own when it has one of plausible length within
/// 60° of the rest direction, else `metres` along that. Toes are laid flat, as they stand.
void fit_tip(BodyFitter& fitter, BodyJoint joint, double metres) {
  const Vec3 along = rest_direction(joint);
  Vec3 tip = fitter.scaled(metres) * along;
  if (fitter.rig().turns(joint)) {
    const Vec3 end = fitter.constants[joint].conjugate() * far_end(fitter.rig(), joint);
    const bool plausible_length = end.norm() > 0.25 * tip.norm() && end.norm() < 2.0 * tip.norm();
    if (plausible_length && end.normalized().dot(along) > 0.5) {
      tip = joint == LeftToe || joint == RightToe ? Vec3(end.norm() * along) : end;
    }
  }
  fitter.body.joints[joint].tip = tip;
}

}  // namespace

bool is_aimed(const MappedJoint& joint) {
  return joint.rotation() >= 0 && joint.position != joint.rotation();
}

Quat canonical_rotation(const RigMotion& motion, const JointTransforms& frame, BodyJoint joint,
                        const Quat& constant) {
  const Quat turned = motion.rotation(frame, joint) * constant;
  if (!is_aimed(motion.joints[joint])) return turned;
  const auto next = next_present(motion, joint);
  if (!next) return turned;
  const Vec3 bone = motion.point(frame, *next) - motion.point(frame, joint);
  const Vec3 axis = turned * rest_direction(joint);
  // A bone of no length, or one that points backwards, cannot be aimed.
  if (bone.norm() < 1e-9 || bone.normalized().dot(axis) < 0.0) return turned;
  return (turn_between(axis, bone) * turned).normalized();
}

double ankle_height(std::span<const RigMotion> motions, BodyJoint ankle) {
  const RigMotion& motion = motions.front();
  const double stature = leg_length(motion) / leg_per_stature;
  std::vector<double> heights;
  for (const JointTransforms& frame : motion.frames) {
    heights.push_back(motion.point(frame, ankle).y());
  }
  const double lowest = percentile(heights, 5) / stature;
  return stature * (lowest > 0.02 && lowest < 0.07 ? lowest : 0.04);
}

Skeleton proportions(std::span<const RigMotion> motions,
                     const std::array<Quat, body_joint_count>& constants) {
  BodyFitter fitter{motions, constants, leg_length(motions.front()) / leg_per_stature,
                    standard_body()};
  for (int j = Spine; j < body_joint_count; ++j) {
    const auto joint = BodyJoint(j);
    if (fitter.rig().has(joint)) {
      fit_present(fitter, joint);
    } else {
      fit_missing(fitter, joint);
    }
  }
  fit_tip(fitter, Head, 0.17);
  fit_tip(fitter, LeftWrist, 0.17);
  fit_tip(fitter, RightWrist, 0.17);
  fit_tip(fitter, LeftToe, 0.06);
  fit_tip(fitter, RightToe, 0.06);
  return fitter.body;
}

}  // namespace mien::motion
