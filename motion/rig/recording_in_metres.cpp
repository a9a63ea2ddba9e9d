#include "motion/rig/recording_in_metres.h"

#include "motion/rig/body_mapping.h"

namespace mien::motion {

Recording in_metres(Recording recording) {
  const RigSketch rig = sketch(recording);
  if (!rig.human) return recording;  // nothing tells its unit and axes
  const double unit = rig.metres_per_unit;
  for (Joint& joint : recording.skeleton.joints) {
    joint.offset *= unit;
    if (joint.tip) *joint.tip *= unit;
  }
  for (Pose& pose : recording.poses) {
    pose.root_position = rig.to_y_up * (unit * pose.root_position);
    pose.rotations.front() = rig.to_y_up * pose.rotations.front();
    for (Vec3& offset : pose.offsets) offset *= unit;
  }
  return recording;
}

}  // namespace mien::motion
