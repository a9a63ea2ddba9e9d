#include "motion/skeleton/straighten.h"

#include <algorithm>
#include <cassert>

#include "motion/math/filter.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/clip_markers.h"

namespace mien::motion {

namespace {

constexpr double slowest_walk = 0.1;     // m/s
constexpr double straight_metres = 0.3;  // from where an even walk would be

Vec3 displacement(const Clip& clip) {
  if (clip.loops) return horizontal(clip.cycle_displacement);
  return horizontal(clip.poses.back().root_position - clip.poses.front().root_position);
}

/// Where each frame would be from the first at even speed.
std::vector<Vec3> uniform_path(const Clip& clip) {
  const Vec3 step = displacement(clip) / (clip.frame_count() - 1);
  std::vector<Vec3> way;
  for (int t = 0; t < clip.frame_count(); ++t) way.push_back(t * step);
  return way;
}

/// Where each frame is from the first, without what is quicker than 1 Hz.
std::vector<Vec3> smoothed_path(const Clip& clip) {
  std::vector<Vec3> way;
  for (const Pose& pose : clip.poses) {
    way.push_back(horizontal(pose.root_position - clip.poses.front().root_position));
  }
  return low_pass(way, 1.0, clip.frames_per_second);
}

}  // namespace

Clip playback_clip(const Clip& clip, const Playback& playback) {
  if (!clip.loops) return playback.in_place ? kept_in_place(clip) : clip;
  return repeated(playback.in_place ? in_place(clip) : clip, playback.cycles);
}

Vec3 mean_direction(const Clip& clip) {
  const Vec3 travel = displacement(clip);
  if (travel.norm() > slowest_walk * clip.duration_seconds()) return travel.normalized();
  Vec3 facing = Vec3::Zero();
  for (const Pose& pose : clip.poses) facing += horizontal(pose.rotations[Pelvis] * Vec3::UnitZ());
  return facing.norm() > 1e-9 ? Vec3(facing.normalized()) : Vec3(Vec3::UnitZ());
}

Clip straightened(const Clip& clip) {
  Clip result = clip;
  if (clip.poses.empty()) return result;
  const Quat turn = heading(mean_direction(clip)).conjugate();
  double sideways = 0.0;
  for (Pose& pose : result.poses) {
    pose.root_position = turn * pose.root_position;
    pose.rotations[Pelvis] = (turn * pose.rotations[Pelvis]).normalized();
    sideways += pose.root_position.x() / clip.frame_count();
  }
  result.cycle_displacement = turn * clip.cycle_displacement;
  // A turned straight line is straight to rounding; what is left sideways would add up over cycles.
  if (clip.loops) result.cycle_displacement.x() = 0.0;
  const Vec3 start = result.poses.front().root_position;
  const Vec3 origin(clip.loops ? sideways : start.x(), 0.0, start.z());
  for (Pose& pose : result.poses) pose.root_position -= origin;
  carry_markers(clip, result,
                [&](int, const Vec3& place) -> Vec3 { return turn * place - origin; });
  return result;
}

Clip in_place(const Clip& loop) {
  Clip result = travelling(loop, -loop.cycle_displacement);
  result.cycle_displacement = Vec3::Zero();
  return result;
}

Clip kept_in_place(const Clip& clip) {
  if (clip.loops) return in_place(clip);
  Clip result = clip;
  if (clip.frame_count() < 2) return result;
  const std::vector<Vec3> even = uniform_path(clip);
  const std::vector<Vec3> path = smoothed_path(clip);
  double farthest = 0.0;
  for (size_t t = 0; t < path.size(); ++t) {
    farthest = std::max(farthest, (path[t] - even[t]).norm());
  }
  const std::vector<Vec3>& way = farthest < straight_metres ? even : path;
  for (size_t t = 0; t < way.size(); ++t) result.poses[t].root_position -= way[t];
  carry_markers(clip, result, [&](int frame, const Vec3& place) -> Vec3 {
    return place - way[static_cast<size_t>(frame)];
  });
  return result;
}

Clip travelling(const Clip& loop, const Vec3& displacement_per_cycle) {
  assert(loop.loops);
  Clip result = loop;
  const double count = loop.frame_count();
  for (size_t i = 0; i < result.poses.size(); ++i) {
    result.poses[i].root_position += static_cast<double>(i) / count * displacement_per_cycle;
  }
  result.cycle_displacement += displacement_per_cycle;
  carry_markers(loop, result, [&](int frame, const Vec3& place) -> Vec3 {
    return place + frame / count * displacement_per_cycle;
  });
  return result;
}

}  // namespace mien::motion
