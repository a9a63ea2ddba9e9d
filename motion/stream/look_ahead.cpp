#include "motion/stream/look_ahead.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/procedural/builtin_sets.h"

namespace mien::motion {

namespace {

constexpr int cycles = 4;

/// Captured motions err by so many times as much as built-in ones at the most (70 recordings).
constexpr double captured_by_builtin = 1.6;

std::vector<Clip> builtin_motions(double frames_per_second) {
  std::vector<Clip> clips;
  for (const char* const set : {"actors", "walks-10"}) {
    for (const Example& example : builtin_examples(set, frames_per_second).examples) {
      clips.push_back(example.clip.loops ? repeated(example.clip, cycles) : example.clip);
    }
  }
  return clips;
}

/// Paths alone, the rest as it is.
Modification paths_alone(const Modification& modification) {
  Modification paths;
  paths.paths = modification.paths;
  paths.gains = modification.gains;
  paths.soft_joint_limits = false;
  paths.repair = FootRepair::none;
  return paths;
}

/// The same bands at a quarter of the frame rate, if that is still a film's.
bool can_be_thinned(const Modification& paths, double frames_per_second) {
  const double quarter = 0.25 * frames_per_second;
  const bool own_bands = paths.gains && !paths.gains->bands.empty();
  return !own_bands && quarter >= 24.0 && oversampling(quarter) == 4;
}

}  // namespace

StreamError stream_error(const Clip& streamed, const Clip& offline) {
  assert(streamed.frame_count() == offline.frame_count());
  StreamError error;
  double squares = 0.0;
  for (size_t f = 0; f < streamed.poses.size(); ++f) {
    const std::vector<Vec3> here = world_positions(streamed.body, streamed.poses[f]);
    const std::vector<Vec3> there = world_positions(offline.body, offline.poses[f]);
    for (size_t j = 0; j < here.size(); ++j) {
      const double away = (here[j] - there[j]).norm();
      squares += away * away;
      if (away <= error.largest_metres) continue;
      error.largest_metres = away;
      error.joint = static_cast<BodyJoint>(j);
      error.frame = static_cast<int>(f);
    }
  }
  const double count = static_cast<double>(body_joint_count) * streamed.frame_count();
  if (count > 0.0) error.rms_metres = std::sqrt(squares / count);
  return error;
}

Modification without_repair(Modification modification) {
  modification.repair = FootRepair::none;
  return modification;
}

int shortest_look_ahead(const Modification& modification, double frames_per_second,
                        double largest_error) {
  const Modification paths = paths_alone(modification);
  if (is_identity(paths)) return 0;
  check_streamable(paths);
  if (can_be_thinned(paths, frames_per_second)) {
    return 4 * shortest_look_ahead(paths, 0.25 * frames_per_second, largest_error);
  }
  const double of_builtin = largest_error / captured_by_builtin;
  const std::vector<Clip> clips = builtin_motions(frames_per_second);
  std::vector<Clip> offline;
  for (const Clip& clip : clips) offline.push_back(modified(clip, paths));
  const auto is_enough = [&](int look_ahead) {
    for (size_t c = 0; c < clips.size(); ++c) {
      const Clip online = streamed(clips[c], paths, {look_ahead, 0, 0});
      if (stream_error(online, offline[c]).largest_metres > of_builtin) return false;
    }
    return true;
  };
  int too_few = -1;
  int enough = path_reach(path_mix(paths).gains, frames_per_second);
  while (enough - too_few > 1) {
    const int middle = (too_few + enough) / 2;
    (is_enough(middle) ? enough : too_few) = middle;
  }
  return enough;
}

StreamDelay split_delay(int frames, const Modification& m, double frames_per_second) {
  StreamDelay delay;
  if (m.gains || m.paths != 1.0) {
    delay.paths = std::min(frames, path_reach(path_mix(m).gains, frames_per_second));
  }
  if (m.acceleration != 0.0) {
    delay.timing = frames - delay.paths;
  } else {
    delay.posture = frames - delay.paths;
  }
  return delay;
}

}  // namespace mien::motion
