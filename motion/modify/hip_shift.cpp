#include "motion/modify/hip_shift.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "motion/gait/foot_lock.h"
#include "motion/gait/foot_path.h"
#include "motion/math/filter.h"
#include "motion/skeleton/sole_height.h"

namespace mien::motion {

namespace {

constexpr double hip_cutoff_hz = 4.0;
constexpr double standing_cycle = 0.05;  // metres a cycle; a loop that goes less far stands

FootLockOptions lock_defaults() { return {}; }

/// Fills the gaps between known values: straight from one to the next, the nearest at open ends.
/// Zero when nothing is known.
std::vector<Vec3> without_gaps(const std::vector<std::optional<Vec3>>& known, bool loops) {
  const auto count = static_cast<long>(known.size());
  std::vector<Vec3> filled(known.size(), Vec3::Zero());
  const auto next_known = [&](long from, long step) -> long {
    for (long k = 0; k < count; ++k, from += step) {
      if (!loops && (from < 0 || from >= count)) break;
      if (known[static_cast<size_t>(((from % count) + count) % count)]) return from;
    }
    return std::numeric_limits<long>::max();
  };
  const auto value = [&](long i) {
    return *known[static_cast<size_t>(((i % count) + count) % count)];
  };
  constexpr long none = std::numeric_limits<long>::max();
  for (long i = 0; i < count; ++i) {
    const long before = next_known(i, -1);
    const long after = next_known(i, 1);
    Vec3& result = filled[static_cast<size_t>(i)];
    if (before == none && after == none) continue;
    if (before == none || after == none || before == after) {
      result = value(before == none ? after : before);
    } else {
      const double t = static_cast<double>(i - before) / static_cast<double>(after - before);
      result = (1.0 - t) * value(before) + t * value(after);
    }
  }
  return filled;
}

/// Horizontal movement of the pivot of a planted foot to the next frame.
Vec3 slide_of(const FootPath& path, int frame, bool on_heel) {
  return horizontal(on_heel ? Vec3(path.heel_at(frame + 1) - path.heel_at(frame))
                            : Vec3(path.ball_at(frame + 1) - path.ball_at(frame)));
}

/// What has to be added to the root in each interval (frame to next frame) for planted feet to
/// stand, or to slide as in `captured`, horizontally.
std::vector<Vec3> shifts(const Clip& clip, const Clip& original, const Clip* captured,
                         const std::vector<FootPlant>& plants) {
  const int count = clip.frame_count();
  std::vector<std::optional<Vec3>> sums(static_cast<size_t>(clip.loops ? count : count - 1));
  std::vector<int> feet(sums.size(), 0);
  for (const bool left : {true, false}) {
    const FootPath path = foot_path(clip, left);
    const FootPath known = foot_path(original, left);
    const FootPath own = foot_path(captured ? *captured : original, left);
    for (const FootPlant& plant : plants) {
      if (plant.left != left) continue;
      const FootLockOptions options = lock_defaults();
      const Stance stance = stance_of(known, plant, options.flat_metres, options.lifted_metres);
      for (int f = stance.first; f < stance.last; ++f) {
        const bool on_heel = f < stance.flat_first;
        Vec3 slide = slide_of(path, f, on_heel);
        if (captured) slide -= slide_of(own, f, on_heel);
        const auto at = static_cast<size_t>(path.wrapped(f));
        sums[at] = sums[at].value_or(Vec3::Zero()) - slide;
        ++feet[at];
      }
    }
  }
  for (size_t i = 0; i < sums.size(); ++i) {
    if (feet[i] > 1) sums[i] = *sums[i] / feet[i];
  }
  return without_gaps(sums, clip.loops);
}

/// How far the root has to rise in each frame for its feet to be as high as in the original; only
/// the y of each vector is used.
std::vector<Vec3> rises(const Clip& clip, const Clip& original,
                        const std::vector<FootPlant>& plants, HipPath path) {
  const int count = clip.frame_count();
  std::vector<std::optional<Vec3>> known(clip.poses.size());
  std::vector<double> standing(clip.poses.size(), 0.0);
  std::array<std::vector<SolePoints>, 2> now = {sole_paths(clip, true), sole_paths(clip, false)};
  std::array<std::vector<SolePoints>, 2> before = {sole_paths(original, true),
                                                   sole_paths(original, false)};
  for (const FootPlant& plant : plants) {
    for (int f = plant.first; f <= plant.last; ++f) {
      const auto at = static_cast<size_t>(clip.loops ? f % count : std::min(f, count - 1));
      double rise = 0.0;
      if (path == HipPath::exact) {
        rise = std::min(lowest_height(before[0][at]), lowest_height(before[1][at])) -
               std::min(lowest_height(now[0][at]), lowest_height(now[1][at]));
      } else {
        const size_t foot = plant.left ? 0 : 1;
        rise = lowest_height(before[foot][at]) - lowest_height(now[foot][at]);
      }
      known[at] = known[at].value_or(Vec3::Zero()) + Vec3(0, rise, 0);
      standing[at] += 1.0;
    }
  }
  for (size_t f = 0; f < known.size(); ++f) {
    if (known[f]) known[f] = *known[f] / standing[f];
  }
  return without_gaps(known, clip.loops);
}

/// The part of a loop's drift that would drive it off its line, or away from where it stands.
Vec3 unwanted(const Vec3& drift, const Clip& original) {
  const Vec3 way(original.cycle_displacement.x(), 0.0, original.cycle_displacement.z());
  if (way.norm() < standing_cycle) return drift;
  const Vec3 forward = way.normalized();
  return drift - drift.dot(forward) * forward;
}

Clip shifted(const Clip& clip, const Clip& original, const Clip* captured,
             const std::vector<FootPlant>& plants, HipPath path) {
  Clip result = clip;
  if (plants.empty() || clip.frame_count() < 2) return result;
  std::vector<Vec3> shift = shifts(clip, original, captured, plants);
  std::vector<Vec3> rise = rises(clip, original, plants, path);
  if (path == HipPath::smooth) {
    const SignalEnds ends = clip.loops ? SignalEnds::periodic : SignalEnds::open;
    shift = low_pass(shift, hip_cutoff_hz, clip.frames_per_second, ends);
    rise = low_pass(rise, hip_cutoff_hz, clip.frames_per_second, ends);
  }
  Vec3 correction = Vec3::Zero();
  if (clip.loops) {
    Vec3 drift = Vec3::Zero();
    for (const Vec3& step : shift) drift += step;
    correction = unwanted(drift, original) / clip.frame_count();
    result.cycle_displacement += drift - correction * clip.frame_count();
  }
  Vec3 way = Vec3::Zero();
  for (size_t f = 0; f < result.poses.size(); ++f) {
    result.poses[f].root_position += way + rise[f];
    if (f < shift.size()) way += shift[f] - correction;
  }
  return result;
}

}  // namespace

Clip with_hip_shift(const Clip& clip, const Clip& original, const std::vector<FootPlant>& plants,
                    HipPath path) {
  return shifted(clip, original, nullptr, plants, path);
}

Clip with_hip_shift_beyond(const Clip& captured, const Clip& clip, const Clip& original,
                           const std::vector<FootPlant>& plants) {
  return shifted(clip, original, &captured, plants, HipPath::smooth);
}

}  // namespace mien::motion
