#pragma once

#include <vector>

#include "motion/points/marker_sets.h"
#include "motion/points/point_recording.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Whether a file has its positions relative to the hips, as keypoints of single images do: their
/// middle, or the pelvis, is within 1 cm of the origin of the file's axes in 99 % of the frames in
/// which it is seen (our decision). Someone who stands still on the floor is not taken for that.
bool has_origin_at_hips(const PointRecording& recording, const MarkerSet& set,
                        double metres_per_unit);

/// How far each frame must be raised so that the lowest of some heights, one list per frame and
/// none empty, is at 0; smooth over time (gait_cutoff_hz), so that single frames do not jerk.
std::vector<double> smooth_lifts(const std::vector<std::vector<double>>& heights,
                                 double frames_per_second);

/// Heights of heels and balls of the feet in each frame, metres. Toes are left out: they bend.
std::vector<std::vector<double>> sole_heights(const Clip& clip);

}  // namespace mien::motion
