#pragma once

#include <vector>

#include "motion/fitting/body_tracks.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// Frames [first, past) of a recording.
struct FrameRange {
  int first = 0;
  int past = 0;
  int size() const { return past - first; }
};

/// The first and the last frame in which the pelvis is known, and those between; empty if it never
/// is.
FrameRange frames_with_pelvis(const BodyTracks& tracks);

/// Poses of the body in the frames of the range, by the directions of its bones: pelvis by hips and
/// spine, trunk by the shoulders, limbs by their plane of bend, head by its points. Frames in which
/// a bone is unknown are interpolated (local rotations), held before the first and after the last
/// known one. Arms that are unknown throughout hang beside the trunk; other bones that are keep
/// their rotation at rest.
std::vector<Pose> initial_poses(const BodyTracks& tracks, const Skeleton& body,
                                const FrameRange& range);

}  // namespace mien::motion
