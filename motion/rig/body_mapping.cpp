#include "motion/rig/body_mapping.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "motion/rig/calibration.h"
#include "motion/rig/proportions.h"
#include "motion/rig/rig_motion.h"
#include "motion/rig/rig_names.h"
#include "motion/rig/rig_topology.h"
#include "motion/rig/toe_bend.h"
#include "motion/rig/unit_guess.h"
#include "motion/skeleton/floor.h"

namespace mien::motion {

namespace {

std::string axis_name(const Vec3& axis) {
  int largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return std::string(axis[largest] < 0 ? "-" : "+") + "XYZ"[largest];
}

struct Found {
  std::string rig;
  MappedJoints joints;
  std::vector<std::string> warnings;
};

/// By names, else by topology; empty when neither gives a human.
std::optional<Found> find_joints(const Recording& recording,
                                 const std::vector<JointTransforms>& world) {
  const Skeleton& rig = recording.skeleton;
  if (const auto keys = key_joints_by_name(rig)) {
    Found found{rig_family(rig), groups_of(rig, *keys, 1.0, "name"), {}};
    if (forward_votes(recording, world, *keys) < -1.0) {
      found.warnings.push_back(
          "Toes, knees and elbows point backwards by the joint names: left and right may be "
          "exchanged in the file.");
    }
    return found;
  }
  if (const auto guess = key_joints_by_topology(recording, world)) {
    Found found{"by topology", groups_of(rig, guess->keys, guess->confidence, "topology"), {}};
    if (guess->confidence < 0.6) {
      found.warnings.push_back("Left and right are hard to tell apart in this rig.");
    }
    return found;
  }
  return std::nullopt;
}

/// How far arms and trunk go along with the legs, −1 to 1, mean over the frames. Those of a human's
/// trunk point away from them; who goes on all fours has the trunk across them and the arms along.
struct LimbDirections {
  double trunk = 0.0;
  double arms = 0.0;
};

LimbDirections limb_directions(const RigMotion& motion) {
  LimbDirections mean;
  const BodyJoint top = motion.has(Chest) ? Chest : LeftShoulder;
  for (const JointTransforms& frame : motion.frames) {
    const auto between = [&](BodyJoint from, BodyJoint to) -> Vec3 {
      return (motion.point(frame, to) - motion.point(frame, from)).normalized();
    };
    const Vec3 legs = between(LeftHip, LeftAnkle) + between(RightHip, RightAnkle);
    const Vec3 arms = between(LeftShoulder, LeftElbow) + between(RightShoulder, RightElbow);
    mean.trunk += between(Pelvis, top).dot(legs.normalized());
    mean.arms += arms.normalized().dot(legs.normalized());
  }
  const auto frames = static_cast<double>(motion.frames.size());
  return {mean.trunk / frames, mean.arms / frames};
}

/// A dog has a human's joints, but not a human's ways.
void warn_of_all_fours(BodyMapping& mapping, const RigMotion& motion) {
  const LimbDirections limbs = limb_directions(motion);
  if (limbs.trunk < -0.5 || limbs.arms < 0.5) return;
  mapping.confidence *= 0.5;
  mapping.warnings.push_back(
      "The figure goes on all fours: unless it is a human who crawls, it is an animal, and what is "
      "said of its body does not hold.");
}

void warn_of_missing(BodyMapping& mapping) {
  std::string missing;
  for (int j = 0; j < body_joint_count; ++j) {
    if (mapping.joints[j].position >= 0) continue;
    missing += missing.empty() ? "" : ", ";
    missing += name_of(BodyJoint(j));
  }
  if (missing.empty()) return;
  mapping.warnings.push_back("The rig has no joint for " + missing +
                             "; filled in by average proportions.");
}

double mean_confidence(const MappedJoints& joints) {
  double sum = 0.0;
  for (const MappedJoint& joint : joints) sum += joint.confidence;
  return sum / body_joint_count;
}

Error not_human(const Recording& recording) {
  return Error(Place{recording.name},
               "its " + std::to_string(recording.skeleton.size()) +
                   " joints are not recognised as a human figure (two legs of at least thigh and "
                   "shank, two arms of at least upper arm and forearm)",
               "name the joints in a common way (LeftUpLeg, LeftLeg, LeftFoot, LeftArm, …) or draw "
               "it as a stick figure");
}

void check_frames(const Recording& recording) {
  if (!recording.poses.empty()) return;
  throw Error(Place{recording.name}, "it holds no frames",
              "give a recording of at least one frame");
}

void set_scale(BodyMapping& mapping, const std::string& format) {
  const UnitGuess unit = guess_unit(standing_height(mapping.body), format);
  mapping.metres_per_unit = unit.metres;
  if (!unit.warning.empty()) mapping.warnings.push_back(unit.warning);
  for (Joint& joint : mapping.body.joints) {
    joint.offset *= unit.metres;
    if (joint.tip) *joint.tip *= unit.metres;
  }
}

std::vector<Quat> local_rotations(const RigMotion& motion, const JointTransforms& frame,
                                  const BodyMapping& mapping) {
  std::vector<Quat> global(body_joint_count, Quat::Identity());
  std::vector<Quat> local(body_joint_count, Quat::Identity());
  for (int j = 0; j < body_joint_count; ++j) {
    const auto joint = BodyJoint(j);
    const int parent = body_parents[j];
    const Quat above = parent < 0 ? Quat::Identity() : global[parent];
    global[j] = motion.turns(joint)
                    ? canonical_rotation(motion, frame, joint, mapping.calibration[j])
                    : above;
    local[j] = (above.conjugate() * global[j]).normalized();
  }
  return local;
}

/// The canonical body where the rig is: the floor neither levelled nor at y = 0.
Clip as_recorded(const Recording& recording, const BodyMapping& mapping) {
  const RigMotion motion = rig_motion(recording, mapping.joints, mapping.to_y_up);
  Clip clip;
  clip.name = recording.name;
  clip.body = mapping.body;
  clip.frames_per_second = recording.frames_per_second;
  for (const JointTransforms& frame : motion.frames) {
    Pose pose;
    pose.root_position = mapping.metres_per_unit * motion.point(frame, Pelvis);
    pose.rotations = local_rotations(motion, frame, mapping);
    clip.poses.push_back(std::move(pose));
  }
  return clip;
}

void check_joints(const Recording& recording, const BodyMapping& mapping) {
  for (const MappedJoint& joint : mapping.joints) {
    for (int rig_joint : joint.group) {
      if (rig_joint < recording.skeleton.size()) continue;
      throw Error(Place{recording.name}, "it has other joints than the rig that was calibrated",
                  "recognise this recording by itself");
    }
  }
}

void warn_of_sloping_floor(BodyMapping& mapping, const Recording& recording) {
  const double slope =
      angle_between(Quat::Identity(), floor_levelling(as_recorded(recording, mapping)));
  if (slope == 0.0) return;
  char degrees[32];
  std::snprintf(degrees, sizeof degrees, "%.1f", slope / radians_per_degree);
  mapping.warnings.push_back("The floor of " + recording.name + " slopes by " + degrees +
                             "°; it is levelled.");
}

void make_continuous(std::vector<Pose>& poses) {
  for (size_t t = 1; t < poses.size(); ++t) {
    for (int j = 0; j < body_joint_count; ++j) {
      poses[t].rotations[j] = in_hemisphere_of(poses[t - 1].rotations[j], poses[t].rotations[j]);
    }
  }
}

}  // namespace

bool same_rig(const Skeleton& a, const Skeleton& b) {
  if (a.size() != b.size()) return false;
  for (int j = 0; j < a.size(); ++j) {
    const Joint& p = a.joints[j];
    const Joint& q = b.joints[j];
    const double length = std::max(p.offset.norm(), q.offset.norm());
    if (p.name != q.name || p.parent != q.parent) return false;
    if ((p.offset - q.offset).norm() > 1e-3 * length) return false;
  }
  return true;
}

BodyMapping recognise(std::span<const Recording> recordings) {
  const Recording& first = recordings.front();
  for (const Recording& recording : recordings) {
    check_frames(recording);
    if (same_rig(first.skeleton, recording.skeleton)) continue;
    throw Error(Place{recording.name}, "its rig is not that of " + first.name,
                "calibrate recordings of different rigs apart");
  }
  const std::vector<JointTransforms> world = world_frames(first);
  std::optional<Found> found = find_joints(first, world);
  if (!found) throw not_human(first);
  BodyMapping mapping;
  mapping.rig = found->rig;
  mapping.joints = found->joints;
  mapping.warnings = found->warnings;
  const UpAxis up = up_axis(world, mapping.joints);
  mapping.up = axis_name(up.axis);
  mapping.to_y_up = turn_to_y_up(up.axis);
  if (up.clearness < 0.7) {
    mapping.warnings.push_back("The figure is seldom upright: " + mapping.up +
                               " as the up axis is a guess.");
  }
  std::vector<RigMotion> motions;
  for (const Recording& recording : recordings) {
    motions.push_back(rig_motion(recording, mapping.joints, mapping.to_y_up));
  }
  const Calibration calibration = calibrate(motions);
  mapping.calibration = calibration.to_body;
  mapping.body = calibration.body;
  set_scale(mapping, first.format);
  warn_of_missing(mapping);
  for (const Recording& recording : recordings) warn_of_sloping_floor(mapping, recording);
  mapping.confidence = mean_confidence(mapping.joints);
  warn_of_all_fours(mapping, motions.front());
  return mapping;
}

BodyMapping recognise(const Recording& recording) { return recognise(std::span(&recording, 1)); }

Clip to_body(const Recording& recording, const BodyMapping& mapping) {
  check_frames(recording);
  check_joints(recording, mapping);
  Clip clip = as_recorded(recording, mapping);
  const Quat levelling = floor_levelling(clip);
  for (Pose& pose : clip.poses) {
    pose.root_position = levelling * pose.root_position;
    pose.rotations[Pelvis] = (levelling * pose.rotations[Pelvis]).normalized();
  }
  make_continuous(clip.poses);
  const double floor = floor_height(clip);
  for (Pose& pose : clip.poses) pose.root_position.y() -= floor;
  for (const BodyJoint toe : {LeftToe, RightToe}) bend_toes_at_floor(clip, toe);
  return clip;
}

Clip to_body(const Recording& recording) { return to_body(recording, recognise(recording)); }

RigSketch sketch(const Recording& recording) {
  check_frames(recording);
  RigSketch result;
  try {
    result.human = recognise(recording);
    result.to_y_up = result.human->to_y_up;
    result.up = result.human->up;
    result.metres_per_unit = result.human->metres_per_unit;
  } catch (const Error& error) {
    result.why_not = error.what();
  }
  double lowest = 0.0;
  double largest = 0.0;
  const std::vector<JointTransforms> world = world_frames(recording);
  for (size_t t = 0; t < world.size(); ++t) {
    Eigen::AlignedBox3d box;
    for (const Vec3& position : world[t].positions) box.extend(result.to_y_up * position);
    lowest = t == 0 ? box.min().y() : std::min(lowest, box.min().y());
    largest = std::max(largest, box.sizes().maxCoeff());
  }
  if (!result.human && largest > 0.0) result.metres_per_unit = 1.7 / largest;
  result.floor = lowest * result.metres_per_unit;
  return result;
}

}  // namespace mien::motion
