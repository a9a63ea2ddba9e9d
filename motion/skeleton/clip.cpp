#include "motion/skeleton/clip.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "motion/math/cubic_spline.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/clip_markers.h"
#include "motion/skeleton/recorded_hands.h"

namespace mien::motion {

namespace {

/// Frame `frame` of the endless motion: loops go on, others stay at their ends.
Vec3 root_at_frame(const Clip& clip, long frame) {
  const long count = clip.frame_count();
  if (!clip.loops) {
    return clip.poses[static_cast<size_t>(std::clamp(frame, 0L, count - 1))].root_position;
  }
  const long cycle = frame >= 0 ? frame / count : -((-frame + count - 1) / count);
  return clip.poses[static_cast<size_t>(frame - cycle * count)].root_position +
         static_cast<double>(cycle) * clip.cycle_displacement;
}

const Pose& pose_at_frame(const Clip& clip, long frame) {
  const long count = clip.frame_count();
  if (!clip.loops) return clip.poses[static_cast<size_t>(std::clamp(frame, 0L, count - 1))];
  return clip.poses[static_cast<size_t>(((frame % count) + count) % count)];
}

/// Slerp between the frames around `frame`; the root by `root(whole, fraction)`.
template <typename RootAt>
Pose sampled(const Clip& clip, double frame, RootAt root) {
  const double whole = std::floor(frame);
  const auto index = static_cast<long>(whole);
  const double t = frame - whole;
  const Pose& from = pose_at_frame(clip, index);
  Pose pose = t == 0.0 ? from : interpolate(from, pose_at_frame(clip, index + 1), t);
  pose.root_position = root(index, t);
  return pose;
}

}  // namespace

Pose pose_at(const Clip& clip, double seconds) {
  double frame = seconds * clip.frames_per_second;
  // Times that were made by dividing a frame by the rate come back as that frame exactly.
  if (std::abs(frame - std::round(frame)) < 1e-9) frame = std::round(frame);
  if (!clip.loops) frame = std::clamp(frame, 0.0, clip.frame_count() - 1.0);
  return sampled(clip, frame, [&](long index, double t) -> Vec3 {
    if (t == 0.0) return root_at_frame(clip, index);
    return (1.0 - t) * root_at_frame(clip, index) + t * root_at_frame(clip, index + 1);
  });
}

Clip resampled(const Clip& clip, double frames_per_second) {
  if (frames_per_second == clip.frames_per_second) return clip;
  Clip result = clip;
  result.frames_per_second = frames_per_second;
  result.poses.clear();
  const double wanted = clip.duration_seconds() * frames_per_second;
  // A loop keeps its duration as nearly as it can; another clip shows nothing beyond its end.
  const double whole = clip.loops ? std::round(wanted) : std::floor(wanted + 1e-6);
  const auto steps = clip.frame_count() > 1 ? static_cast<long>(std::max(1.0, whole)) : 0L;
  const long count = clip.loops ? steps : steps + 1;
  // A loop must meet its start, so its whole number of frames spans the duration exactly.
  const double step = clip.loops ? clip.frame_count() / static_cast<double>(steps)
                                 : clip.frames_per_second / frames_per_second;
  std::vector<double> frames;
  for (long i = 0; i < count; ++i) {
    double frame = static_cast<double>(i) * step;
    if (std::abs(frame - std::round(frame)) < 1e-9) frame = std::round(frame);
    if (!clip.loops) frame = std::min(frame, clip.frame_count() - 1.0);
    frames.push_back(frame);
    result.poses.push_back(sampled(clip, frame, [&](long index, double t) {
      return catmull_rom(root_at_frame(clip, index - 1), root_at_frame(clip, index),
                         root_at_frame(clip, index + 1), root_at_frame(clip, index + 2), t);
    }));
  }
  carry_markers_at(clip, result, frames);
  return result;
}

Clip repeated(const Clip& loop, int cycles) {
  assert(loop.loops && cycles > 0);
  Clip result = loop;
  result.loops = false;
  result.cycle_displacement = Vec3::Zero();
  result.poses.clear();
  for (int cycle = 0; cycle < cycles; ++cycle) {
    for (Pose pose : loop.poses) {
      pose.root_position += cycle * loop.cycle_displacement;
      result.poses.push_back(std::move(pose));
    }
  }
  std::vector<double> frames(result.poses.size());
  std::iota(frames.begin(), frames.end(), 0.0);
  carry_markers_at(loop, result, frames);
  return result;
}

Clip cut(const Clip& clip, int first, int last) {
  assert(first >= 0 && first <= last && last < clip.frame_count());
  Clip part = clip;
  part.poses.assign(clip.poses.begin() + first, clip.poses.begin() + last + 1);
  std::vector<double> frames(part.poses.size());
  std::iota(frames.begin(), frames.end(), static_cast<double>(first));
  carry_markers_at(clip, part, frames);
  return part;
}

std::vector<std::vector<Vec3>> joint_paths(const Clip& clip) {
  std::vector<std::vector<Vec3>> paths;
  paths.reserve(clip.poses.size());
  for (const Pose& pose : clip.poses) paths.push_back(world_positions(clip.body, pose));
  return paths;
}

Recording to_recording(const Clip& clip) {
  Recording recording;
  recording.name = clip.name;
  recording.skeleton = clip.body;
  recording.frames_per_second = clip.frames_per_second;
  recording.poses = clip.poses;
  if (has_fingers(clip)) add_hands(recording);
  return recording;
}

}  // namespace mien::motion
