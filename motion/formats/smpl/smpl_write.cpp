#include <cmath>

#include "motion/formats/smpl/smpl.h"
#include "motion/formats/smpl/smpl_joints.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/recorded_hands.h"

namespace mien::motion {

namespace {

constexpr std::size_t smplh_joints = 52;

void put(std::vector<double>& numbers, std::size_t index, const Vec3& vector) {
  for (int axis = 0; axis < 3; ++axis)
    numbers[3 * index + static_cast<std::size_t>(axis)] = vector[axis];
}

/// For each joint of AMASS the recording's joint, −1: none.
std::vector<int> sources_of(const Skeleton& skeleton) {
  std::vector<int> sources(smplh_joints, -1);
  for (int j = 0; j < body_joint_count; ++j)
    sources[static_cast<std::size_t>(smpl_joint_of(j))] =
        find_joint(skeleton, name_of(BodyJoint(j)));
  for (int j = 0; j < finger_joint_count; ++j)
    sources[static_cast<std::size_t>(smplh_joint_of_finger(j))] =
        find_joint(skeleton, finger_joint_name(j));
  return sources;
}

void require_body(const Recording& recording) {
  if (!is_body(without_fingers(recording.skeleton)))
    throw Error({recording.name},
                "its joints are not those of the canonical body, of which alone "
                "AMASS files are written",
                "map the motion to the body first");
  if (recording.poses.empty())
    throw Error({recording.name}, "it holds no frames", "give a motion of at least one frame");
}

}  // namespace

std::string to_amass_npz(const Recording& recording) {
  require_body(recording);
  const std::size_t frames = recording.poses.size();
  const std::vector<int> sources = sources_of(recording.skeleton);
  const Quat to_z_up(std::sqrt(0.5), std::sqrt(0.5), 0.0, 0.0);  // +Y to +Z
  std::vector<double> poses(3 * frames * smplh_joints, 0.0);
  std::vector<double> trans(3 * frames);
  for (std::size_t t = 0; t < frames; ++t) {
    const Pose& pose = recording.poses[t];
    put(trans, t, to_z_up * pose.root_position);
    for (std::size_t j = 0; j < smplh_joints; ++j) {
      if (sources[j] < 0) continue;
      const Quat& own = pose.rotations[static_cast<std::size_t>(sources[j])];
      const Quat rotation = sources[j] == Pelvis ? to_z_up * own : own;
      put(poses, t * smplh_joints + j, log(rotation));
    }
  }
  const std::vector<double> betas(16, 0.0);
  const std::vector<double> dmpls(8 * frames, 0.0);
  const std::vector<NamedArray> arrays = {
      {"trans", array_of(trans, {frames, 3})},
      {"gender", array_of_text("neutral")},
      {"mocap_framerate", array_of(std::span(&recording.frames_per_second, 1), {})},
      {"betas", array_of(betas, {16})},
      {"dmpls", array_of(dmpls, {frames, 8})},
      {"poses", array_of(poses, {frames, 3 * smplh_joints})}};
  return to_npz(arrays);
}

}  // namespace mien::motion
