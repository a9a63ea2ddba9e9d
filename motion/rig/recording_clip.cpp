#include "motion/rig/recording_clip.h"

#include "motion/rig/body_mapping.h"
#include "motion/skeleton/clip_markers.h"

namespace mien::motion {

Recording in_metres(Recording recording) {
  const RigAnalysis rig = analyse_rig(recording);
  if (!rig.human) return recording;  // nothing tells its unit and axes
  to_metres(rig.metres_per_unit, rig.to_y_up, recording.skeleton, recording.poses);
  return recording;
}

void to_metres(double metres_per_unit, const Quat& to_y_up, Skeleton& body,
               std::vector<Pose>& poses) {
  for (Joint& joint : body.joints) {
    joint.offset *= metres_per_unit;
    if (joint.tip) *joint.tip *= metres_per_unit;
  }
  for (Pose& pose : poses) {
    pose.root_position = to_y_up * (metres_per_unit * pose.root_position);
    pose.rotations.front() = to_y_up * pose.rotations.front();
    for (Vec3& offset : pose.offsets) offset *= metres_per_unit;
  }
}

Clip clip_of(const Recording& recording) {
  const RigAnalysis rig = analyse_rig(recording);
  if (rig.human) return to_body(recording, *rig.human);
  Clip clip;
  clip.name = recording.name;
  clip.body = recording.skeleton;
  clip.frames_per_second = recording.frames_per_second;
  clip.poses = recording.poses;
  to_metres(rig.metres_per_unit, rig.to_y_up, clip.body, clip.poses);
  for (Pose& pose : clip.poses) pose.root_position.y() -= rig.floor;
  if (recording.markers) attach(clip, *recording.markers);
  return clip;
}

}  // namespace mien::motion
