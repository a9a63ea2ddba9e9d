
#include "motion/error.h"
#include "motion/interpolation/time_warp.h"
#include "motion/motion_graph/motion_graph.h"

namespace mien::motion {

namespace {

void check_keytimes(std::span<const double> keytimes, const Clip& clip) {
  bool sound = keytimes.size() >= 2 && keytimes.front() >= -1e-9 &&
               keytimes.back() <= clip.duration_seconds() + 1e-9;
  for (std::size_t i = 1; i < keytimes.size(); ++i) sound = sound && keytimes[i] > keytimes[i - 1];
  if (!sound) {
    throw Error(
        "the keytimes of \"" + clip.name + "\" are not in ascending order or lie outside it",
        "give at least two, including those of the first and the last frame");
  }
}

}  // namespace

SynchronisedMotion synchronised(const Clip& version, std::span<const double> version_keytimes,
                                const Clip& reference, std::span<const double> reference_keytimes) {
  check_keytimes(version_keytimes, version);
  check_keytimes(reference_keytimes, reference);
  if (version_keytimes.size() != reference_keytimes.size()) {
    throw Error(
        "the keytimes of \"" + version.name + "\" and \"" + reference.name + "\" do not correspond",
        "give the same number for both");
  }
  const TimeWarp warp =
      make_time_warp(reference_keytimes, version_keytimes, WarpShape::monotone, false);
  SynchronisedMotion motion;
  motion.clip = version;
  motion.clip.frames_per_second = reference.frames_per_second;
  motion.clip.loops = false;
  motion.clip.poses.clear();
  const double step = 1.0 / reference.frames_per_second;
  for (int f = 0; f < reference.frame_count(); ++f) {
    const double seconds = warped(warp, f * step);
    motion.clip.poses.push_back(pose_at(version, seconds));
    const double next = warped(warp, (f + 1) * step);
    motion.frame_seconds.push_back(next > seconds ? next - seconds : step);
  }
  return motion;
}

}  // namespace mien::motion
