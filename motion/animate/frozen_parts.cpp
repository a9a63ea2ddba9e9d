#include "motion/animate/frozen_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "motion/error.h"
#include "motion/gait/contact.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/hand.h"

namespace mien::motion {

namespace {

constexpr std::array leg_joints = {Pelvis,   LeftHip,   LeftKnee,   LeftAnkle, LeftToe,
                                   RightHip, RightKnee, RightAnkle, RightToe};
constexpr std::array trunk_joints = {Spine, Chest};
constexpr std::array head_joints = {Neck, Head};
constexpr std::array left_arm_joints = {LeftClavicle, LeftShoulder, LeftElbow, LeftWrist};
constexpr std::array right_arm_joints = {RightClavicle, RightShoulder, RightElbow, RightWrist};

struct PartOfBody {
  std::span<const BodyJoint> joints;
  const char* stays;  ///< "the head does not move"
};

/// By FrozenPart.
constexpr std::array<PartOfBody, 5> parts_of_body = {
    {{leg_joints, "the legs do not move"},
     {trunk_joints, "the trunk does not move"},
     {head_joints, "the head does not move"},
     {left_arm_joints, "the left arm does not move"},
     {right_arm_joints, "the right arm does not move"}}};

const PartOfBody& part_of_body(FrozenPart part) {
  return parts_of_body[static_cast<std::size_t>(part)];
}

std::span<const BodyJoint> frozen_joints(FrozenPart part) { return part_of_body(part).joints; }

/// The rotation of a joint; of the pelvis without its direction about the vertical.
Quat posture_of(const Pose& pose, BodyJoint joint) {
  const Quat& rotation = pose.rotations[static_cast<std::size_t>(joint)];
  if (joint != Pelvis) return rotation;
  Vec3 ahead = rotation * Vec3::UnitZ();
  ahead.y() = 0.0;
  if (ahead.norm() < 1e-9) return rotation;
  return Quat::FromTwoVectors(ahead.normalized(), Vec3::UnitZ()) * rotation;
}

/// The mean of rotations that are not far from each other: of quaternions on one side.
Quat mean_posture(const Clip& clip, BodyJoint joint) {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (const Pose& pose : clip.poses) {
    const Eigen::Vector4d one = posture_of(pose, joint).coeffs();
    sum += sum.dot(one) < 0.0 ? Eigen::Vector4d(-one) : one;
  }
  return sum.norm() < 1e-9 ? posture_of(clip.poses.front(), joint) : Quat(sum.normalized());
}

/// Whether both feet are on the floor, by frame.
std::vector<bool> frames_on_both_feet(const Clip& clip) {
  std::vector<bool> both = foot_contact(clip, true).foot;
  const std::vector<bool> right = foot_contact(clip, false).foot;
  for (std::size_t f = 0; f < both.size(); ++f) both[f] = both[f] && right[f];
  return both;
}

/// The fingers of an arm, if there are any.
void hold_fingers(FrozenPart part, const Pose& held, Pose& pose) {
  if (part != FrozenPart::left_arm && part != FrozenPart::right_arm) return;
  for (std::size_t j = 0; j < pose.fingers.size(); ++j)
    if (is_left_finger(static_cast<int>(j)) == (part == FrozenPart::left_arm))
      pose.fingers[j] = held.fingers[j];
}

std::size_t most_typical_frame(const Clip& clip, FrozenPart part) {
  std::vector<double> distances(clip.poses.size(), 0.0);
  for (const BodyJoint joint : frozen_joints(part)) {
    const Quat mean = mean_posture(clip, joint);
    for (std::size_t f = 0; f < clip.poses.size(); ++f)
      distances[f] += std::pow(mean.angularDistance(posture_of(clip.poses[f], joint)), 2);
  }
  if (part == FrozenPart::legs) {
    const std::vector<bool> both = frames_on_both_feet(clip);
    if (std::ranges::find(both, true) != both.end())
      for (std::size_t f = 0; f < both.size(); ++f)
        if (!both[f]) distances[f] = std::numeric_limits<double>::infinity();
  }
  return static_cast<std::size_t>(std::ranges::min_element(distances) - distances.begin());
}

}  // namespace

bool is_frozen(const Freezing& freezing, BodyJoint joint) {
  return std::ranges::any_of(freezing.parts, [&](FrozenPart part) {
    return std::ranges::find(frozen_joints(part), joint) != frozen_joints(part).end();
  });
}

AnimatedClip with_frozen(const Clip& clip, const Freezing& freezing) {
  if (!is_body(clip.body))
    throw Error("parts can be frozen only on the canonical body", "map the motion to it first");
  AnimatedClip frozen{clip, {}, {}};
  for (const FrozenPart part : freezing.parts) {
    const double seconds =
        freezing.at ? seconds_within(*freezing.at, clip, "parts are frozen at")
                    : static_cast<double>(most_typical_frame(clip, part)) / clip.frames_per_second;
    const Pose held = pose_at(clip, seconds);
    for (Pose& pose : frozen.clip.poses) {
      for (const BodyJoint joint : frozen_joints(part))
        pose.rotations[static_cast<std::size_t>(joint)] =
            held.rotations[static_cast<std::size_t>(joint)];
      if (part == FrozenPart::legs) pose.root_position = held.root_position;
      hold_fingers(part, held, pose);
    }
    if (part == FrozenPart::legs) frozen.clip.cycle_displacement = Vec3::Zero();
    frozen.remarks.push_back(std::string(part_of_body(part).stays) + ", in the pose at " +
                             seconds_in_words(seconds));
  }
  return frozen;
}

}  // namespace mien::motion
