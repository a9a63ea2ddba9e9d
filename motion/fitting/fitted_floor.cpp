#include "motion/fitting/fitted_floor.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/fitting/feet_without_points.h"
#include "motion/fitting/hip_origin.h"
#include "motion/rig/toe_bend.h"
#include "motion/skeleton/floor.h"

namespace mien::motion {

namespace {

void raise_motion(const std::vector<double>& lifts, FittedMotion& fitted) {
  for (std::size_t frame = 0; frame < fitted.clip.poses.size(); ++frame) {
    fitted.clip.poses[frame].root_position.y() += lifts[frame];
    fitted.raised_by_frame[frame] += lifts[frame];
  }
}

void raise_motion(double lift, FittedMotion& fitted) {
  raise_motion(std::vector<double>(fitted.clip.poses.size(), lift), fitted);
}

/// Puts ankles that stand where they are in standing. If the file has its floor at 0, the feet are
/// as high as the ankles tell; then both feet stand on it although one ankle is higher.
void put_ankles_on_floor(FittedMotion& fitted) {
  Clip& clip = fitted.clip;
  if (fitted.is_relative_to_hips) {
    std::vector<std::vector<double>> heights;
    for (const std::vector<Vec3>& joints : joint_paths(clip))
      heights.push_back({joints[LeftAnkle].y() - ankle_height_on_floor(clip.body, true),
                         joints[RightAnkle].y() - ankle_height_on_floor(clip.body, false)});
    raise_motion(smooth_lifts(heights, clip.frames_per_second), fitted);
    return;
  }
  const double left = standing_ankle_height(clip, true);
  const double right = standing_ankle_height(clip, false);
  const double lower = std::min(left, right);
  const bool is_from_floor = fitted.axes.floor == 0.0 && lower > 0.02;
  if (is_from_floor) set_ankle_height(lower, left == lower, clip.body);
  raise_motion(ankle_height_on_floor(clip.body, left == lower) - lower, fitted);
  const double higher = std::max(left, right) + fitted.raised_by_frame.front();
  set_ankle_height(higher, left != lower, clip.body);
}

/// Moves the motion by the little that the bend of its toes changes, so that its floor is at 0 as
/// readers of skeletons find it: written and read again, it stays where it is.
void settle_on_floor(const BodyTracks& tracks, FittedMotion& fitted) {
  constexpr int most_rounds = 3;
  for (int round = 0; round < most_rounds; ++round) {
    Clip bent = fitted.clip;
    bend_unknown_toes(tracks, bent);
    const double floor = floor_height(bent);
    raise_motion(-floor, fitted);
    if (std::abs(floor) < 1e-6) break;
  }
}

}  // namespace

void bend_unknown_toes(const BodyTracks& tracks, Clip& clip) {
  for (const BodyJoint toe : {LeftToe, RightToe})
    if (!is_known(tracks.tips[toe])) bend_toes_at_floor(clip, toe);
}

void put_on_floor(const BodyTracks& tracks, FittedMotion& fitted) {
  const bool has_left = is_known(tracks.joints[LeftToe]);
  const bool has_right = is_known(tracks.joints[RightToe]);
  Clip& clip = fitted.clip;
  if (!has_left && !has_right)
    put_ankles_on_floor(fitted);
  else if (fitted.is_relative_to_hips)
    raise_motion(smooth_lifts(sole_heights(clip), clip.frames_per_second), fitted);
  else
    raise_motion(-floor_height(clip), fitted);
  if (!has_left) turn_foot_by_floor(clip, true);
  if (!has_right) turn_foot_by_floor(clip, false);
  if (fitted.is_relative_to_hips)
    raise_motion(smooth_lifts(sole_heights(clip), clip.frames_per_second), fitted);
  else
    settle_on_floor(tracks, fitted);
}

}  // namespace mien::motion
