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

/// The segment, by its joint, that the point moves with as if it were part of it: a marker with the
/// bone under it, a hip joint with the pelvis. None for other joint centres, which may belong to
/// either of two bones.
std::optional<BodyJoint> rigid_segment_of(const Role& role);

/// The attachments of all points whose role is known and that are seen in the range. Joint centres
/// are at the joints of the body. Other points are where they are in most frames: at the median of
/// their places in the frame of their segment.
std::vector<Attachment> attachments(const PointTracks& points, const Skeleton& body,
                                    std::span<const Pose> poses, const FrameRange& range);

}  // namespace mien::motion
