#include "motion/rig/body_mapping.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "motion/rig/bone_tree.h"
#include "motion/rig/calibration.h"
#include "motion/rig/canonical_rig.h"
#include "motion/rig/proportions.h"
#include "motion/rig/rest_calibration.h"
#include "motion/rig/rig_motion.h"
#include "motion/rig/rig_names.h"
#include "motion/rig/rig_topology.h"
#include "motion/rig/toe_bend.h"
#include "motion/rig/unit_guess.h"
#include "motion/skeleton/clip_markers.h"
#include "motion/skeleton/floor.h"
#include "motion/skeleton/recorded_hands.h"

namespace mien::motion {

namespace {

constexpr std::string_view rig_by_topology = "by topology";

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

/// Bones that only help the figure's own, such as Rigify's, lie on these.
void warn_of_other_figure(const Skeleton& rig, const JointTransforms& world, const KeyJoints& keys,
                          std::vector<std::string>& warnings) {
  const int other = other_figure_in(rig, keys);
  if (other < 0) return;
  const Vec3& arm = world.positions[keys.left.upper_arm];
  const double length = (world.positions[keys.left.forearm] - arm).norm();
  if ((world.positions[other] - arm).norm() < 0.1 * length) return;
  warnings.push_back("The file contains another figure (" + rig.joints[other].name +
                     " …); the one of " + rig.joints[keys.left.upper_arm].name + " is taken.");
}

/// By names, with the shape for what they leave open; else by topology; empty when neither gives a
/// human.
std::optional<Found> find_joints(const Recording& recording,
                                 const std::vector<JointTransforms>& world) {
  const Skeleton& rig = recording.skeleton;
  if (const auto keys = key_joints_by_name(bone_tree(rig, world))) {
    Found found{rig_family(rig), groups_of(rig, *keys, 1.0, "name"), {}};
    if (forward_votes(recording, world, *keys) < -1.0) {
      found.warnings.push_back(
          "Toes, knees and elbows point backwards by the joint names: left and right may be "
          "exchanged in the file.");
    }
    warn_of_other_figure(rig, world.front(), *keys, found.warnings);
    return found;
  }
  if (const auto guess = key_joints_by_topology(recording, world)) {
    Found found{std::string(rig_by_topology),
                groups_of(rig, guess->keys, guess->confidence, "topology"),
                {}};
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

bool goes_on_all_fours(const RigMotion& motion) {
  const LimbDirections limbs = limb_directions(motion);
  return limbs.trunk >= -0.5 && limbs.arms >= 0.5;
}

/// A dog has a human's joints, but not a human's ways.
void warn_of_all_fours(BodyMapping& mapping, const RigMotion& motion) {
  if (!goes_on_all_fours(motion)) return;
  mapping.confidence *= 0.5;
  mapping.warnings.push_back(
      "The figure is on all fours: unless it is a crawling human, it is an animal, and the body "
      "measurements are not valid.");
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
                             "; filled in from average proportions.");
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
               "if it is one, name the joints in a common way (LeftUpLeg, LeftLeg, LeftFoot, "
               "LeftArm, …)");
}

Error on_all_fours(const Recording& recording) {
  return Error(
      Place{recording.name},
      "its " + std::to_string(recording.skeleton.size()) +
          " joints are not recognised as a human figure: the shape is that of a quadruped",
      "name the joints in a common way (LeftUpLeg, LeftLeg, LeftFoot, LeftArm, …) if it is "
      "a human who crawls");
}

/// The up axis: that of the format, otherwise estimated from the figure. Notes where they differ,
/// or where the estimate is uncertain.
UpAxis up_of(const Recording& recording, const std::vector<JointTransforms>& world,
             BodyMapping& mapping) {
  UpAxis up = up_axis(world, mapping.joints);
  if (recording.markers) {  // in the space of a clip
    up.axis = Vec3::UnitY();
    return up;
  }
  if (recording.format != "gltf") {
    if (up.clearness < 0.7) {
      mapping.warnings.push_back("The figure is seldom upright: " + axis_name(up.axis) +
                                 " as the up axis is a guess.");
    }
    return up;
  }
  if (axis_name(up.axis) != "+Y" && up.clearness > 0.7) {
    mapping.warnings.push_back("The figure's head is towards " + axis_name(up.axis) +
                               " of its feet, but +Y is up in glTF: it is shown lying or upside "
                               "down.");
  }
  up.axis = Vec3::UnitY();
  return up;
}

void check_frames(const Recording& recording) {
  if (!recording.poses.empty()) return;
  throw Error(Place{recording.name}, "it holds no frames",
              "give a recording of at least one frame");
}

ZeroPose zero_pose_of(const Recording& recording, const UpAxis& up) {
  // The body that was fitted to points.
  if (recording.markers || is_canonical_rig(recording.skeleton, up.axis)) return ZeroPose::own;
  return recording.format == "smpl" ? ZeroPose::defined : ZeroPose::checked;
}

void set_scale(BodyMapping& mapping, const Recording& recording) {
  if (recording.markers) return;
  const UnitGuess unit = guess_unit(standing_height(mapping.body), recording.format);
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

void map_hands(BodyMapping& mapping, std::span<const RigMotion> motions, ZeroPose zero_pose) {
  const bool is_own = zero_pose == ZeroPose::own;
  const bool is_figure =
      zero_pose != ZeroPose::checked || rest_calibration(motions.front()).has_value();
  mapping.hands = hand_mapping(motions, is_figure, is_own);
  if (is_own && mapping.hands.any()) keep_own_tips(motions.front().rig, mapping.body);
  for (std::string& warning : hand_warnings(mapping.hands))
    mapping.warnings.push_back(std::move(warning));
}

/// The canonical body where the rig is: the floor neither levelled nor at y = 0.
Clip as_recorded(const Recording& recording, const BodyMapping& mapping) {
  const RigMotion motion = rig_motion(recording, mapping.joints, mapping.to_y_up);
  Clip clip;
  clip.name = recording.name;
  clip.body = mapping.body;
  clip.frames_per_second = recording.frames_per_second;
  const bool has_fingers = mapping.hands.any() && !are_fingers_unrecorded(recording, mapping.hands);
  for (const JointTransforms& frame : motion.frames) {
    Pose pose;
    pose.root_position = mapping.metres_per_unit * motion.point(frame, Pelvis);
    pose.rotations = local_rotations(motion, frame, mapping);
    if (has_fingers) pose.fingers = finger_rotations(motion, frame, mapping.hands);
    clip.poses.push_back(std::move(pose));
  }
  if (has_fingers && are_straight_and_still(clip.poses))
    for (Pose& pose : clip.poses) pose.fingers.clear();
  return clip;
}

void check_joints(const Recording& recording, const BodyMapping& mapping) {
  int last = *std::max_element(mapping.hands.joints.begin(), mapping.hands.joints.end());
  for (const MappedJoint& joint : mapping.joints)
    for (const int rig_joint : joint.group) last = std::max(last, rig_joint);
  if (last < recording.skeleton.size()) return;
  throw Error(Place{recording.name}, "its joints differ from those of the calibrated rig",
              "use the recording without calibration");
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

void level(Clip& clip, const Quat& levelling) {
  for (Pose& pose : clip.poses) {
    pose.root_position = levelling * pose.root_position;
    pose.rotations[Pelvis] = (levelling * pose.rotations[Pelvis]).normalized();
  }
}

void follow_hemispheres(const std::vector<Quat>& before, std::vector<Quat>& now) {
  for (size_t j = 0; j < now.size(); ++j) now[j] = in_hemisphere_of(before[j], now[j]);
}

void make_continuous(std::vector<Pose>& poses) {
  for (size_t t = 1; t < poses.size(); ++t) {
    follow_hemispheres(poses[t - 1].rotations, poses[t].rotations);
    follow_hemispheres(poses[t - 1].fingers, poses[t].fingers);
  }
}

}  // namespace

BodyMapping recognise(std::span<const Recording> recordings) {
  const Recording& first = recordings.front();
  for (const Recording& recording : recordings) {
    check_frames(recording);
    if (same_rig(first.skeleton, recording.skeleton)) continue;
    throw Error(Place{recording.name}, "its rig differs from that of " + first.name,
                "calibrate recordings of different rigs separately");
  }
  const std::vector<JointTransforms> world = world_frames(first);
  std::optional<Found> found = find_joints(first, world);
  if (!found) throw not_human(first);
  BodyMapping mapping;
  mapping.rig = found->rig;
  mapping.joints = found->joints;
  mapping.warnings = first.notes;
  mapping.warnings.insert(mapping.warnings.end(), found->warnings.begin(), found->warnings.end());
  const UpAxis up = up_of(first, world, mapping);
  mapping.up = axis_name(up.axis);
  mapping.to_y_up = turn_to_y_up(up.axis);
  std::vector<RigMotion> motions;
  for (const Recording& recording : recordings) {
    motions.push_back(rig_motion(recording, mapping.joints, mapping.to_y_up));
  }
  const bool is_nameless = mapping.rig == rig_by_topology;
  if (is_nameless && goes_on_all_fours(motions.front())) throw on_all_fours(first);
  const ZeroPose zero_pose = zero_pose_of(first, up);
  const Calibration calibration = calibrate(motions, zero_pose);
  mapping.calibration = calibration.to_body;
  mapping.body = calibration.body;
  map_hands(mapping, motions, zero_pose);
  set_scale(mapping, first);
  warn_of_missing(mapping);
  for (const Recording& recording : recordings)
    if (!recording.markers) warn_of_sloping_floor(mapping, recording);
  mapping.confidence = mean_confidence(mapping.joints);
  warn_of_all_fours(mapping, motions.front());
  return mapping;
}

BodyMapping recognise(const Recording& recording) { return recognise(std::span(&recording, 1)); }

RecordedFloor recorded_floor(const Recording& recording, const BodyMapping& mapping) {
  check_frames(recording);
  check_joints(recording, mapping);
  if (recording.markers) return {};
  Clip clip = as_recorded(recording, mapping);
  const Quat levelling = floor_levelling(clip);
  level(clip, levelling);
  return {levelling, floor_height(clip)};
}

Clip to_body(const Recording& recording, const BodyMapping& mapping, const RecordedFloor& floor) {
  check_frames(recording);
  check_joints(recording, mapping);
  Clip clip = as_recorded(recording, mapping);
  level(clip, floor.levelling);
  make_continuous(clip.poses);
  for (Pose& pose : clip.poses) pose.root_position.y() -= floor.height;
  for (const BodyJoint toe : {LeftToe, RightToe}) bend_toes_at_floor(clip, toe);
  if (recording.markers) attach(clip, *recording.markers);
  return clip;
}

Clip to_body(const Recording& recording, const BodyMapping& mapping) {
  return to_body(recording, mapping, recorded_floor(recording, mapping));
}

Clip to_body(const Recording& recording) { return to_body(recording, recognise(recording)); }

namespace {

/// The error as a sentence about the file, which is named before it: "Its 4 joints are not …"
std::string sentence_of(const Error& error) {
  std::string words = error.what();
  const std::string place = to_string(error.place()) + ": ";
  if (words.starts_with(place)) words.erase(0, place.size());
  words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words + ".";
}

}  // namespace

RigAnalysis analyse_rig(const Recording& recording) {
  check_frames(recording);
  RigAnalysis result;
  try {
    result.human = recognise(recording);
    result.to_y_up = result.human->to_y_up;
    result.up = result.human->up;
    result.metres_per_unit = result.human->metres_per_unit;
    result.warnings = result.human->warnings;
  } catch (const Error& error) {
    result.rejection = error.what();
    result.warnings = recording.notes;
    if (recording.markers) return result;  // notes say why; its space is that of a clip
    result.warnings.push_back(sentence_of(error));
    result.warnings.push_back("It is shown as it is: unscaled (1 unit = 1 m), with +Y up.");
  }
  double lowest = 0.0;
  const std::vector<JointTransforms> world = world_frames(recording);
  for (size_t t = 0; t < world.size(); ++t) {
    Eigen::AlignedBox3d box;
    for (const Vec3& position : world[t].positions) box.extend(result.to_y_up * position);
    lowest = t == 0 ? box.min().y() : std::min(lowest, box.min().y());
  }
  result.floor = lowest * result.metres_per_unit;
  return result;
}

}  // namespace mien::motion
