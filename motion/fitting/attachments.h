#pragma once

#include <optional>
#include <span>
#include <vector>

#include "motion/fitting/initial_poses.h"
#include "motion/fitting/point_tracks.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// Where a point of the recording is on the body: fixed in the frame of a joint.
struct Attachment {
  int point = 0;  ///< of the recording
  BodyJoint joint = Pelvis;
  Vec3 place = Vec3::Zero();  ///< in the joint's frame, metres
};

/// The attachments of all points whose role is known and that are seen in the range. Joint centres
/// are at the joints of the body. Other points are where they are in most frames: at the median of
/// their places in the frame of their segment.
std::vector<Attachment> attachments(const PointTracks& points, const Skeleton& body,
                                    std::span<const Pose> poses, const FrameRange& range);

}  // namespace mien::motion
