#include "motion/measures/features/motion_summary.h"

#include "motion/math/filter.h"
#include "motion/rig/body_mapping.h"
#include "motion/skeleton/recorded_hands.h"

namespace mien::motion {

namespace {

std::vector<JointSummary> joints_of(const Recording& recording, const BodyMapping& mapping) {
  std::vector<JointSummary> joints;
  for (int j = 0; j < body_joint_count; ++j) {
    const MappedJoint& mapped = mapping.joints[j];
    JointSummary summary{
        std::string(name_of(BodyJoint(j))), {}, mapped.confidence, mapped.found_by};
    for (int rig_joint : mapped.group) {
      summary.rig_joints.push_back(recording.skeleton.joints[rig_joint].name);
    }
    joints.push_back(std::move(summary));
  }
  return joints;
}

std::vector<HandSummary> hands_of(const Recording& recording, const HandMapping& mapping,
                                  bool is_recorded) {
  std::vector<HandSummary> hands;
  for (const bool left : {true, false}) {
    if (!mapping.has(left)) continue;
    HandSummary& hand = hands.emplace_back();
    hand.is_left = left;
    hand.is_recorded = is_recorded;
    for (int j = 0; j < finger_joint_count; ++j) {
      if (is_left_finger(j) != left) continue;
      const int rig_joint = mapping.joints[static_cast<size_t>(j)];
      if (rig_joint < 0) {
        hand.missing.push_back(finger_joint_name(j));
        continue;
      }
      hand.joints.push_back(
          {finger_joint_name(j), recording.skeleton.joints[static_cast<size_t>(rig_joint)].name});
    }
  }
  return hands;
}

/// Length of the pelvis' path on the floor, without the sway of single steps, by its duration.
double mean_speed(const Clip& clip) {
  if (clip.frame_count() < 2) return 0.0;
  std::vector<Vec3> path;
  for (const Pose& pose : clip.poses) {
    path.push_back({pose.root_position.x(), 0.0, pose.root_position.z()});
  }
  path = low_pass(path, 1.0, clip.frames_per_second);
  double length = 0.0;
  for (size_t t = 1; t < path.size(); ++t) length += (path[t] - path[t - 1]).norm();
  return length / clip.duration_seconds();
}

void add_gait(MotionSummary& summary, const Clip& clip) {
  if (clip.frame_count() < 2) return;
  summary.cycles = gait_cycles(clip);
  const auto best = steadiest_cycle(clip);
  if (!best) return;
  for (size_t i = 0; i < summary.cycles.size(); ++i) {
    if (summary.cycles[i].start_frame == best->start_frame) summary.steadiest = static_cast<int>(i);
  }
  if (summary.steadiest < 0) {
    summary.cycles.push_back(*best);
    summary.steadiest = static_cast<int>(summary.cycles.size()) - 1;
  }
  summary.warnings.insert(summary.warnings.end(), best->warnings.begin(), best->warnings.end());
}

}  // namespace

MotionSummary summarise(const Recording& recording) {
  MotionSummary summary;
  summary.frames = recording.frame_count();
  summary.frames_per_second = recording.frames_per_second;
  summary.takes = recording.takes;
  summary.take = recording.take;
  summary.duration_seconds = (summary.frames - 1) / recording.frames_per_second;
  for (const Joint& joint : recording.skeleton.joints) summary.joint_names.push_back(joint.name);
  const RigAnalysis rig = analyse_rig(recording);
  summary.is_human = rig.human.has_value();
  summary.up = rig.up;
  summary.unit_m = rig.metres_per_unit;
  if (!rig.human) {
    summary.rig = "unknown";
    summary.warnings = rig.warnings;
    return summary;
  }
  const Clip clip = to_body(recording, *rig.human);
  summary.rig = rig.human->rig;
  summary.confidence = rig.human->confidence;
  summary.joints = joints_of(recording, *rig.human);
  summary.hands = hands_of(recording, rig.human->hands, has_fingers(clip));
  summary.height_m = standing_height(rig.human->body);
  summary.warnings = rig.human->warnings;
  summary.speed_m_s = mean_speed(clip);
  add_gait(summary, clip);
  return summary;
}

}  // namespace mien::motion
