#include "motion/examples/make_example.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/error.h"
#include "motion/gait/loop.h"
#include "motion/math/filter.h"
#include "motion/math/peaks.h"
#include "motion/skeleton/floor.h"
#include "motion/skeleton/straighten.h"

namespace mien::motion {

namespace {

constexpr double least_end_seconds = 0.2;

constexpr std::array body_ends = {LeftWrist, RightWrist, LeftToe, RightToe};
constexpr double least_peak_metres = 0.02;

/// The ways of hands and feet relative to the pelvis, without what is quicker than 3 Hz.
std::vector<std::vector<Vec3>> end_paths(const Clip& clip) {
  const double rate = clip.frames_per_second;
  const std::vector<std::vector<Vec3>> paths = joint_paths(clip);
  std::vector<std::vector<Vec3>> ends;
  for (const BodyJoint end : body_ends) {
    std::vector<Vec3> path;
    for (const auto& positions : paths) path.push_back(positions[end] - positions[Pelvis]);
    ends.push_back(low_pass(path, std::min(3.0, 0.3 * rate), rate));
  }
  return ends;
}

/// The largest of the four ends' speeds relative to the pelvis, m/s.
std::vector<double> end_speeds(const Clip& clip) {
  std::vector<double> largest(clip.poses.size(), 0.0);
  for (const std::vector<Vec3>& path : end_paths(clip)) {
    const std::vector<Vec3> velocity = derivative(path, clip.frames_per_second);
    for (size_t t = 0; t < largest.size(); ++t) {
      largest[t] = std::max(largest[t], velocity[t].norm());
    }
  }
  return largest;
}

FrameRange all_frames(const Clip& clip) { return {0, clip.frame_count() - 1}; }

PreparedExample whole_example(const Clip& clip) {
  PreparedExample prepared;
  prepared.frames = all_frames(clip);
  prepared.example.name = clip.name;
  prepared.example.clip = straightened(clip);
  std::vector<double>& keytimes = prepared.example.keytimes;
  keytimes.push_back(0.0);
  for (const SpeedMinimum& minimum : speed_minima(clip)) keytimes.push_back(minimum.seconds);
  keytimes.push_back(clip.duration_seconds());
  return prepared;
}

PreparedExample peaked_example(const Clip& clip) {
  const std::optional<double> peak = peak_seconds(clip);
  if (!peak) {
    throw Error(Place{clip.name}, "hands and feet do not move, so there are no peaks",
                "exclude it, or specify its keytimes");
  }
  PreparedExample prepared;
  prepared.frames = all_frames(clip);
  prepared.example.name = clip.name;
  prepared.example.clip = straightened(clip);
  prepared.example.keytimes = {0.0, *peak, clip.duration_seconds()};
  return prepared;
}

void check_keytimes(const Clip& clip, const std::vector<double>& keytimes) {
  const double frame = 1.0 / clip.frames_per_second;
  const auto refuse = [&](const std::string& wrong) {
    throw Error(Place{clip.name}, "its keytimes " + wrong,
                "give at least two times in ascending order from 0 to " +
                    std::to_string(clip.duration_seconds()) + " s, at least one frame apart");
  };
  if (keytimes.size() < 2) refuse("are fewer than two");
  if (keytimes.front() < 0.0 || keytimes.back() > clip.duration_seconds() + 0.5 * frame) {
    refuse("are not within the motion");
  }
  for (size_t k = 1; k < keytimes.size(); ++k) {
    if (keytimes[k] - keytimes[k - 1] < 0.999 * frame) refuse("are less than one frame apart");
  }
}

PreparedExample example_of_keytimes(const Clip& clip, const std::vector<double>& keytimes) {
  check_keytimes(clip, keytimes);
  const double rate = clip.frames_per_second;
  const auto first = std::lround(keytimes.front() * rate);
  const auto last =
      std::clamp(std::lround(keytimes.back() * rate), first + 1, clip.frame_count() - 1L);
  const Clip part = cut(clip, static_cast<int>(first), static_cast<int>(last));
  PreparedExample prepared;
  prepared.frames = {static_cast<int>(first), static_cast<int>(last)};
  prepared.example.name = clip.name;
  prepared.example.clip = straightened(part);
  prepared.example.keytimes = keytimes;
  for (double& keytime : prepared.example.keytimes) {
    keytime -= static_cast<double>(first) / rate;
  }
  prepared.example.keytimes.front() = 0.0;
  prepared.example.keytimes.back() = part.duration_seconds();
  return prepared;
}

/// Keytimes of the cycle in the time of a loop that is a little longer or shorter. Ascending order
/// is kept, since both ends are scaled equally.
std::vector<double> scaled_keytimes(const GaitCycle& cycle, double duration) {
  const double scale = duration / cycle.keytimes.back();
  std::vector<double> keytimes;
  for (double keytime : cycle.keytimes) keytimes.push_back(keytime * scale);
  keytimes.back() = duration;
  return keytimes;
}

/// A cycle's feet may rest elsewhere than those of the whole take did.
Clip on_the_floor(Clip clip) {
  const double floor = floor_height(clip);
  for (Pose& pose : clip.poses) pose.root_position.y() -= floor;
  return clip;
}

PreparedExample looped_example(const Clip& clip, const GaitCycle& cycle, CycleRange cut) {
  const Clip loop = cycle.is_half ? mirrored_loop(clip, cut.start, cut.end)
                                  : closed_loop(clip, cut.start, cut.end);
  const auto to_strike = static_cast<int>(std::lround(cycle.left_strike)) - cut.start;
  PreparedExample prepared;
  prepared.cycle = cycle;
  prepared.frames = {cut.start, cut.end};
  prepared.cycle->start_frame = cut.start;
  prepared.cycle->end_frame = cut.end;
  prepared.example.name = clip.name;
  prepared.example.clip = on_the_floor(straightened(shifted_loop(loop, to_strike)));
  prepared.example.keytimes = scaled_keytimes(cycle, loop.duration_seconds());
  return prepared;
}

Error bad_frames(const Clip& clip, const FrameRange& frames, const std::string& wrong) {
  return Error(
      Place{clip.name},
      "frames " + std::to_string(frames.first) + "–" + std::to_string(frames.last) + " " + wrong,
      "give the frames of two successive strikes of one foot (frames count from 0)");
}

PreparedExample example_of_frames(const Clip& clip, const FrameRange& frames) {
  if (frames.first < 0 || frames.last >= clip.frame_count() || frames.last - frames.first < 8) {
    throw bad_frames(clip, frames,
                     "are not within the clip of " + std::to_string(clip.frame_count()) +
                         " frames with at least 8 between them");
  }
  auto cycle = cycle_of_loop(closed_loop(clip, frames.first, frames.last));
  if (!cycle)
    throw bad_frames(clip, frames, "do not contain a gait cycle of one left and one right step");
  cycle->left_strike += frames.first;
  return looped_example(clip, *cycle, {frames.first, frames.last});
}

/// An example from a loop, which only needs another first frame and direction.
PreparedExample example_of_loop(const Clip& loop) {
  PreparedExample prepared;
  prepared.cycle = cycle_of_loop(loop);
  prepared.frames = all_frames(loop);
  prepared.example.name = loop.name;
  if (!prepared.cycle) {
    prepared.example.clip = straightened(loop);
    prepared.example.keytimes = {0.0, loop.duration_seconds()};
    return prepared;
  }
  const auto to_strike = static_cast<int>(std::lround(prepared.cycle->left_strike));
  prepared.example.clip = straightened(shifted_loop(loop, to_strike));
  prepared.example.keytimes = scaled_keytimes(*prepared.cycle, loop.duration_seconds());
  return prepared;
}

}  // namespace

PreparedExample prepare_example(const Clip& clip, const ExampleOptions& options) {
  if (clip.frame_count() < 2) {
    throw Error(Place{clip.name}, "it holds fewer than two frames", "give a motion, not a pose");
  }
  if (!options.keytimes.empty()) return example_of_keytimes(clip, options.keytimes);
  if (clip.loops) return example_of_loop(clip);
  if (options.frames) return example_of_frames(clip, *options.frames);
  if (options.cycle == CycleChoice::whole) return whole_example(clip);
  if (options.cycle == CycleChoice::start_peak_end) return peaked_example(clip);
  const auto cycle = steadiest_cycle(clip);
  if (!cycle) return whole_example(clip);
  const CycleRange place{cycle->start_frame, cycle->end_frame};
  return looped_example(clip, *cycle, cycle->is_half ? place : best_cut(clip, place));
}

Example make_example(const Clip& clip, const ExampleOptions& options) {
  return prepare_example(clip, options).example;
}

void even_keytimes(std::vector<Example>& examples) {
  size_t fewest = examples.empty() ? 0 : examples.front().keytimes.size();
  for (const Example& example : examples) fewest = std::min(fewest, example.keytimes.size());
  for (Example& example : examples) {
    if (example.clip.loops || example.keytimes.size() == fewest) continue;
    std::vector<SpeedMinimum> minima = speed_minima(example.clip);
    std::stable_sort(
        minima.begin(), minima.end(),
        [](const SpeedMinimum& a, const SpeedMinimum& b) { return a.depth > b.depth; });
    example.keytimes = {0.0, example.clip.duration_seconds()};
    for (size_t i = 0; i + 2 < fewest; ++i) example.keytimes.push_back(minima[i].seconds);
    std::sort(example.keytimes.begin(), example.keytimes.end());
  }
}

std::optional<double> peak_seconds(const Clip& clip) {
  const std::vector<std::vector<Vec3>> ends = end_paths(clip);
  const int frames = clip.frame_count();
  double farthest = least_peak_metres;
  std::optional<double> peak;
  for (int f = 2; f + 2 < frames; ++f) {
    const double t = static_cast<double>(f) / (frames - 1);
    for (const std::vector<Vec3>& path : ends) {
      const Vec3 straight = (1.0 - t) * path.front() + t * path.back();
      const double away = (path[static_cast<size_t>(f)] - straight).norm();
      if (away <= farthest) continue;
      farthest = away;
      peak = f / clip.frames_per_second;
    }
  }
  return peak;
}

std::vector<SpeedMinimum> speed_minima(const Clip& clip) {
  std::vector<double> slowness = end_speeds(clip);
  const double top = slowness.empty() ? 0.0 : *std::max_element(slowness.begin(), slowness.end());
  for (double& value : slowness) value = -value;
  const double rate = clip.frames_per_second;
  std::vector<SpeedMinimum> minima;
  for (const Peak& peak : prominent_peaks(slowness, 0.25 * top, 0.0)) {
    const double seconds = peak.place / rate;
    const bool inside =
        seconds > least_end_seconds && seconds < clip.duration_seconds() - least_end_seconds;
    if (top > 0.0 && inside) minima.push_back({seconds, peak.prominence});
  }
  return minima;
}

}  // namespace mien::motion
