#include "motion/fitting/hip_origin.h"

#include <algorithm>

#include "motion/fitting/point_tracks.h"
#include "motion/math/filter.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

bool is_at_origin(const Track& track, double metres_per_unit) {
  constexpr double radius = 0.01;  // metres
  int seen = 0;
  int near = 0;
  for (const std::optional<Vec3>& place : track) {
    if (!place) continue;
    ++seen;
    if (place->norm() * metres_per_unit < radius) ++near;
  }
  return seen > 0 && near >= 0.99 * seen;
}

}  // namespace

bool has_origin_at_hips(const PointRecording& recording, const MarkerSet& set,
                        double metres_per_unit) {
  using enum Landmark;
  const PointTracks points{recording, set};
  const Track hips = middle_of(points.of(hip, Side::left), points.of(hip, Side::right));
  for (const Track& track : {hips, points.of(pelvis), points.of(mid_hips)})
    if (is_at_origin(track, metres_per_unit)) return true;
  return false;
}

std::vector<double> smooth_lifts(const std::vector<std::vector<double>>& heights,
                                 double frames_per_second) {
  std::vector<double> lifts;
  for (const std::vector<double>& of_frame : heights)
    lifts.push_back(-*std::min_element(of_frame.begin(), of_frame.end()));
  return low_pass(lifts, gait_cutoff_hz(frames_per_second), frames_per_second);
}

std::vector<std::vector<double>> sole_heights(const Clip& clip) {
  std::vector<std::vector<double>> heights(clip.poses.size());
  for (const bool left : {true, false}) {
    const std::vector<SolePoints> path = sole_paths(clip, left);
    for (std::size_t frame = 0; frame < path.size(); ++frame)
      for (const Vec3& point : {path[frame].heel, path[frame].ball})
        heights[frame].push_back(point.y());
  }
  return heights;
}

}  // namespace mien::motion
