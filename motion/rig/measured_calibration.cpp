#include "motion/rig/measured_calibration.h"

#include <cmath>
#include <functional>

#include "motion/math/rotation.h"
#include "motion/rig/foot_rest.h"

namespace mien::motion {

namespace {

using FrameVector = std::function<Vec3(const RigMotion&, const JointTransforms&)>;

/// All that the steps share: the recordings and the constants found so far.
struct Measuring {
  std::span<const RigMotion> motions;
  MeasuredCalibration found;
  double leg = 1.0;
  bool axes_mean_something = false;  ///< the rig lays its limbs along axes of their joint frames

  const RigMotion& rig() const { return motions.front(); }

  /// A world direction of a canonical frame that is already calibrated.
  Vec3 direction(const RigMotion& motion, const JointTransforms& frame, BodyJoint joint,
                 const Vec3& axis) const {
    return motion.rotation(frame, joint) * (found.constants[joint] * axis);
  }
};

/// Mean over all frames of a world vector as the frame of the joint sees it. Zero vectors count as
/// nothing seen.
Vec3 mean_in_joint(const Measuring& measuring, BodyJoint joint, const FrameVector& vector) {
  Vec3 sum = Vec3::Zero();
  double count = 0.0;
  for (const RigMotion& motion : measuring.motions) {
    for (const JointTransforms& frame : motion.frames) {
      const Vec3 seen = vector(motion, frame);
      if (seen.isZero()) continue;
      sum += motion.rotation(frame, joint).conjugate() * seen;
      count += 1.0;
    }
  }
  return count > 0 ? Vec3(sum / count) : Vec3(Vec3::Zero());
}

/// The axis of the joint's own frame nearest to `direction`, when within `degrees` of it after both
/// are made perpendicular to the bone; else `direction` itself, and so where the rig's axes mean
/// nothing.
Vec3 snapped(const Measuring& measuring, const Vec3& direction, const Vec3& bone,
             double degrees = 20.0) {
  if (!measuring.axes_mean_something) return direction;
  const auto across = [&](const Vec3& v) { return Vec3(v - v.dot(bone) * bone); };
  const Vec3 wanted = across(direction).normalized();
  Vec3 best = direction;
  double nearest = std::cos(degrees * radians_per_degree);
  for (int axis = 0; axis < 6; ++axis) {
    const Vec3 own = Vec3::Unit(axis % 3) * (axis < 3 ? 1.0 : -1.0);
    const Vec3 level = across(own);
    if (level.norm() < std::sin(50 * radians_per_degree)) continue;
    if (level.normalized().dot(wanted) > nearest) {
      nearest = level.normalized().dot(wanted);
      best = level;
    }
  }
  return best;
}

/// A_j that lays `rest_bone` on `bone` exactly and `rest_reference` towards `reference`.
Quat laid(const Vec3& rest_bone, const Vec3& bone, const Vec3& rest_reference,
          const Vec3& reference) {
  return (frame_from(bone, reference) * frame_from(rest_bone, rest_reference).conjugate())
      .normalized();
}

/// Mean direction of the joint's bone in its own frame; zero when the rig gives it no length.
Vec3 bone_in_joint(const Measuring& measuring, BodyJoint joint) {
  for (auto next = next_present(measuring.rig(), joint); next;
       next = next_present(measuring.rig(), *next)) {
    const Vec3 bone =
        mean_in_joint(measuring, joint, [&](const RigMotion& motion, const JointTransforms& frame) {
          return Vec3(motion.point(frame, *next) - motion.point(frame, joint));
        });
    if (bone.norm() > 0.02 * measuring.leg) return bone.normalized();
  }
  return Vec3::Zero();
}

/// Whether thighs, shanks, upper arms and forearms all lie along an axis of their joint's frame, to
/// 3°.
bool lays_limbs_along_axes(const Measuring& measuring) {
  for (const BodyJoint joint : {LeftHip, LeftKnee, RightHip, RightKnee, LeftShoulder, LeftElbow,
                                RightShoulder, RightElbow}) {
    if (!measuring.rig().turns(joint)) continue;
    const Vec3 bone = bone_in_joint(measuring, joint);
    if (!bone.isZero() && bone.cwiseAbs().maxCoeff() < std::cos(3 * radians_per_degree))
      return false;
  }
  return true;
}

/// Lays the joint on its bone, its twist by `reference` (a world vector for each frame) or the axis
/// of the joint's own frame within `snap_degrees` of it.
void lay(Measuring& measuring, BodyJoint joint, const Vec3& bone, const Vec3& rest_reference,
         const FrameVector& reference, double snap_degrees = 20.0) {
  const Vec3 seen = mean_in_joint(measuring, joint, reference);
  measuring.found.constants[joint] = laid(rest_direction(joint), bone, rest_reference,
                                          snapped(measuring, seen, bone, snap_degrees));
}

/// Pelvis or chest: across by the line between two joints that hang on it, up by the bone or, when
/// it has none, by the way the trunk points on the average.
void lay_girdle(Measuring& measuring, BodyJoint joint, BodyJoint left, BodyJoint right) {
  if (!measuring.rig().turns(joint)) return;
  Vec3 bone = bone_in_joint(measuring, joint);
  if (bone.isZero()) {
    bone = mean_in_joint(measuring, joint, [](const RigMotion&, const JointTransforms&) {
             return Vec3(Vec3::UnitY());
           }).normalized();
  }
  lay(measuring, joint, bone, Vec3::UnitX(),
      [&](const RigMotion& motion, const JointTransforms& frame) {
        return Vec3(motion.point(frame, left) - motion.point(frame, right));
      });
}

/// The head's bone points to its tip when that lies anywhere above; a head without one is upright
/// like its neighbour on the average.
Vec3 crown_in_head(const Measuring& measuring, BodyJoint head, BodyJoint neighbour) {
  const Vec3 up =
      mean_in_joint(measuring, head, [&](const RigMotion& motion, const JointTransforms& frame) {
        return measuring.direction(motion, frame, neighbour, Vec3::UnitY());
      }).normalized();
  const Vec3 tip = far_end(measuring.rig(), head);
  const bool is_crown = tip.norm() > 0.05 * measuring.leg && tip.normalized().dot(up) > 0.5;
  return is_crown ? Vec3(tip.normalized())
                  : Vec3(snapped(measuring, up, Vec3::Zero()).normalized());
}

/// A joint of the midline that faces, on the average, where its neighbour faces.
void lay_midline(Measuring& measuring, BodyJoint joint, BodyJoint neighbour) {
  if (!measuring.rig().turns(joint) || !measuring.rig().turns(neighbour)) return;
  Vec3 bone = bone_in_joint(measuring, joint);
  if (joint == Head || bone.isZero()) bone = crown_in_head(measuring, joint, neighbour);
  lay(measuring, joint, bone, Vec3::UnitZ(),
      [&](const RigMotion& motion, const JointTransforms& frame) {
        return measuring.direction(motion, frame, neighbour, Vec3::UnitZ());
      });
}

/// Axis about which the limb bends from `upper` to `lower` bone, in the frames where the middle
/// joint is bent more than 15°; zero in the others.
FrameVector hinge(BodyJoint proximal, double sign) {
  return [=](const RigMotion& motion, const JointTransforms& frame) {
    const Vec3 middle = motion.point(frame, BodyJoint(proximal + 1));
    const Vec3 upper = (middle - motion.point(frame, proximal)).normalized();
    const Vec3 lower = (motion.point(frame, BodyJoint(proximal + 2)) - middle).normalized();
    const Vec3 axis = upper.cross(lower);
    const bool bent = upper.dot(lower) < std::cos(15 * radians_per_degree);
    return bent ? Vec3(sign * axis) : Vec3(Vec3::Zero());
  };
}

/// Share of the frames in which the limb is bent.
double bent_share(const Measuring& measuring, const FrameVector& axis) {
  double bent = 0.0;
  double all = 0.0;
  for (const RigMotion& motion : measuring.motions) {
    for (const JointTransforms& frame : motion.frames) {
      bent += axis(motion, frame).isZero() ? 0.0 : 1.0;
      all += 1.0;
    }
  }
  return bent / all;
}

/// Both bones of an arm or leg: twist by the hinge between them, else by the girdle's attitude.
void lay_limb(Measuring& measuring, BodyJoint proximal, BodyJoint girdle,
              const Vec3& rest_hinge_axis, double sign, const Vec3& girdle_axis) {
  const auto middle = BodyJoint(proximal + 1);
  const bool is_whole = measuring.rig().has(BodyJoint(proximal + 2));
  const FrameVector bending = is_whole ? hinge(proximal, sign) : FrameVector();
  for (const BodyJoint joint : {proximal, middle}) {
    const Vec3 bone = bone_in_joint(measuring, joint);
    if (!measuring.rig().turns(joint) || bone.isZero()) continue;
    if (bending && bent_share(measuring, bending) > 0.05) {
      lay(measuring, joint, bone, rest_hinge_axis, bending);
      measuring.found.has_evidence[joint] = true;
    } else if (measuring.rig().turns(girdle)) {
      lay(
          measuring, joint, bone, girdle_axis,
          [&](const RigMotion& motion, const JointTransforms& frame) {
            return measuring.direction(motion, frame, girdle, girdle_axis);
          },
          35.0);
    }
  }
}

void lay_clavicle(Measuring& measuring, BodyJoint clavicle) {
  if (!measuring.rig().turns(clavicle) || !measuring.rig().turns(Chest)) return;
  const Vec3 bone = bone_in_joint(measuring, clavicle);
  if (bone.isZero()) return;
  lay(measuring, clavicle, bone, Vec3::UnitY(),
      [&](const RigMotion& motion, const JointTransforms& frame) {
        return measuring.direction(motion, frame, Chest, Vec3::UnitY());
      });
}

/// The hand's end in the frame of its joint, if it goes on from the forearm on the average (wrists
/// rest bent by some 25°); else zero.
Vec3 fingertips(const Measuring& measuring, BodyJoint wrist, const Vec3& along) {
  const Vec3 tip = far_end(measuring.rig(), wrist);
  const bool goes_on = tip.norm() > 0.02 * measuring.leg && tip.normalized().dot(along) > 0.5;
  return goes_on ? Vec3(tip.normalized()) : Vec3(Vec3::Zero());
}

/// A hand points to its tip when that goes on from the forearm, else along the axis of its own
/// frame that does so on the average. It is turned as the forearm is.
void lay_hand(Measuring& measuring, BodyJoint wrist) {
  const auto elbow = BodyJoint(wrist - 1);
  if (!measuring.rig().turns(wrist)) return;
  const auto forearm = [&](const Vec3& axis) {
    return [&measuring, elbow, axis](const RigMotion& motion, const JointTransforms& frame) {
      return measuring.direction(motion, frame, elbow, axis);
    };
  };
  const Vec3 along = mean_in_joint(measuring, wrist, forearm(rest_direction(elbow))).normalized();
  const Vec3 tip = fingertips(measuring, wrist, along);
  const Vec3 bone = tip.isZero() ? snapped(measuring, along, Vec3::Zero(), 35.0) : tip;
  lay(measuring, wrist, bone.normalized(), Vec3::UnitY(), forearm(Vec3::UnitY()));
  // Some rigs have level arms but hanging hands when all rotations are zero: no straight wrist.
  const JointTransforms zero = zero_pose(measuring.rig().rig);
  const Vec3 lower = measuring.rig().point(zero, wrist) - measuring.rig().point(zero, elbow);
  const Vec3 hand = zero.rotations[measuring.rig().joints[wrist].rotation()] * tip;
  measuring.found.has_evidence[wrist] = !tip.isZero() && hand.dot(lower) < 0.5 * lower.norm();
}

/// Foot and toes: up as the world is when the foot stands flat, forward to the toes.
void lay_foot(Measuring& measuring, BodyJoint ankle) {
  if (!measuring.rig().turns(ankle)) return;
  const FootRest rest = foot_rest(measuring.motions, ankle);
  Vec3 forward = rest.forward;
  if (!measuring.rig().has(BodyJoint(ankle + 1))) {
    forward =
        mean_in_joint(measuring, ankle, [&](const RigMotion& motion, const JointTransforms& frame) {
          return measuring.direction(motion, frame, BodyJoint(ankle - 1), Vec3::UnitZ());
        });
  }
  measuring.found.constants[ankle] = laid(Vec3::UnitY(), rest.up, Vec3::UnitZ(), forward);
  measuring.found.has_evidence[ankle] = rest.frames > 2;
  const auto toe = BodyJoint(ankle + 1);
  if (!measuring.rig().turns(toe)) return;
  measuring.found.constants[toe] =
      laid(Vec3::UnitY(), snapped(measuring, rest.toe_up, Vec3::Zero()).normalized(), Vec3::UnitZ(),
           snapped(measuring, rest.toe_forward, rest.toe_up.normalized()));
}

/// Forearm, hand and head take over the constant of the joint above where the rig, all rotations
/// zero, has them in line with it: so pronation and bent wrists, which are style, stay in the
/// motion. Kept only when the measured constant is within `degrees`, else the rig's frames are
/// unrelated.
void follow_parent(Measuring& measuring, BodyJoint joint, BodyJoint parent, double degrees) {
  if (!measuring.axes_mean_something) return;
  if (!measuring.rig().turns(joint) || !measuring.rig().turns(parent)) return;
  auto& constants = measuring.found.constants;
  if (angle_between(constants[parent], constants[joint]) < degrees * radians_per_degree) {
    constants[joint] = constants[parent];
  }
}

/// Whether upper arm and forearm lie in one line when all rotations are zero.
bool straight_at_zero(const RigMotion& motion, BodyJoint shoulder) {
  const auto elbow = BodyJoint(shoulder + 1);
  const auto wrist = BodyJoint(shoulder + 2);
  if (!motion.has(wrist)) return false;
  const JointTransforms zero = zero_pose(motion.rig);
  const Vec3 upper = motion.point(zero, elbow) - motion.point(zero, shoulder);
  const Vec3 lower = motion.point(zero, wrist) - motion.point(zero, elbow);
  return upper.normalized().dot(lower.normalized()) > std::cos(20 * radians_per_degree);
}

}  // namespace

MeasuredCalibration measured_calibration(std::span<const RigMotion> motions) {
  Measuring measuring{motions, {}, leg_length(motions.front()), false};
  measuring.axes_mean_something = lays_limbs_along_axes(measuring);
  measuring.found.constants.fill(Quat::Identity());
  lay_girdle(measuring, Pelvis, LeftHip, RightHip);
  lay_girdle(measuring, Chest, LeftShoulder, RightShoulder);
  lay_midline(measuring, Spine, measuring.rig().turns(Chest) ? Chest : Pelvis);
  lay_midline(measuring, Neck, Chest);
  lay_midline(measuring, Head, Chest);
  follow_parent(measuring, Head, Neck, 45.0);
  for (const auto& [hip, sign] : {std::pair(LeftHip, 1.0), std::pair(RightHip, 1.0)}) {
    lay_limb(measuring, hip, Pelvis, Vec3::UnitX(), sign, Vec3::UnitX());
    lay_foot(measuring, BodyJoint(hip + 2));
  }
  // Bent elbows bring the forearm forward: from +X to +Z about −Y on the left, mirrored on the
  // right.
  for (const auto& [shoulder, sign] :
       {std::pair(LeftShoulder, -1.0), std::pair(RightShoulder, 1.0)}) {
    lay_clavicle(measuring, BodyJoint(shoulder - 1));
    lay_limb(measuring, shoulder, Chest, Vec3::UnitY(), sign, Vec3::UnitZ());
    const bool straight = straight_at_zero(measuring.rig(), shoulder);
    const auto elbow = BodyJoint(shoulder + 1);
    const auto wrist = BodyJoint(shoulder + 2);
    if (straight) follow_parent(measuring, elbow, shoulder, 100.0);
    lay_hand(measuring, wrist);
    if (straight && !measuring.found.has_evidence[wrist])
      follow_parent(measuring, wrist, elbow, 100.0);
  }
  return measuring.found;
}

}  // namespace mien::motion
