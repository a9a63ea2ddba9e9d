#include "motion/dynamics/retiming.h"

#include <algorithm>
#include <cmath>

#include "motion/skeleton/joint_curve.h"

namespace mien::motion {

namespace {

constexpr int fineness = 16;  // parts of an interval in which its speed is constant

/// Root place less the even way of a loop, so that it is periodic; the rest of the six numbers is
/// not used.
std::vector<Directions> root_curve(const Clip& clip) {
  std::vector<Directions> curve;
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    const double share = static_cast<double>(f) / clip.frame_count();
    Directions place = Directions::Zero();
    place.head<3>() = clip.poses[f].root_position - share * clip.cycle_displacement;
    curve.push_back(place);
  }
  return curve;
}

int whole_frames(double steps, bool loops) {
  return std::max(loops ? 3 : 1, static_cast<int>(std::lround(steps)));
}

Retiming evenly(int frames_before, int steps_before, int steps_after, bool loops) {
  Retiming result;
  result.loops = loops;
  for (int f = 0; f < (loops ? steps_after : steps_after + 1); ++f)
    result.sources.push_back(static_cast<double>(f) * steps_before / std::max(1, steps_after));
  const double scale = steps_before < 1 ? 1.0 : static_cast<double>(steps_after) / steps_before;
  for (int f = 0; f < frames_before; ++f) result.targets.push_back(f * scale);
  return result;
}

bool changes_nothing(const Retiming& retiming) {
  for (size_t f = 0; f < retiming.sources.size(); ++f) {
    if (retiming.sources[f] != static_cast<double>(f)) return false;
  }
  return retiming.sources.size() == retiming.targets.size();
}

}  // namespace

int interval_count(int frames, bool loops) { return loops ? frames : frames - 1; }

double Retiming::target(double frame) const {
  const int count = frames_before();
  if (!loops) frame = std::clamp(frame, 0.0, count - 1.0);
  const double lap = loops ? std::floor(frame / count) : 0.0;
  const double within = frame - lap * count;
  const auto whole = std::min(static_cast<int>(within), count - 1);
  const double from = targets[static_cast<size_t>(whole)];
  const double share = within - whole;
  if (share == 0.0) return lap * frames_after() + from;
  const double to = whole + 1 < count ? targets[static_cast<size_t>(whole) + 1] : frames_after();
  return lap * frames_after() + from + share * (to - from);
}

Retiming even_retiming(int frame_count, bool loops, double factor) {
  const int steps = interval_count(frame_count, loops);
  if (steps < 1) return evenly(frame_count, steps, frame_count - 1, loops);
  Retiming result = evenly(frame_count, steps, whole_frames(steps / factor, loops), loops);
  result.factor = factor;
  result.is_even = true;
  return result;
}

Retiming retiming_between(int frames_before, int frames_after, bool loops) {
  const int before = std::max(1, interval_count(frames_before, loops));
  const int after = interval_count(frames_after, loops);
  Retiming result = evenly(frames_before, before, std::max(1, after), loops);
  result.factor = after < 1 ? 1.0 : static_cast<double>(before) / after;
  result.is_even = true;
  return result;
}

Retiming retiming(int frame_count, bool loops, const Tempo& tempo,
                  std::span<const double> stretch) {
  const int steps = interval_count(frame_count, loops);
  if (steps < 1 || (tempo.curve.empty() && stretch.empty()))
    return even_retiming(frame_count, loops, tempo.factor);
  // The new time at each part of an interval, by the midpoint rule.
  std::vector<double> times = {0.0};
  for (int i = 0; i < steps; ++i) {
    const double longer = stretch.empty() ? 1.0 : stretch[static_cast<size_t>(i)];
    for (int k = 0; k < fineness; ++k) {
      const double share = (i + (k + 0.5) / fineness) / steps;
      times.push_back(times.back() + longer / (fineness * factor_at(tempo, share, loops)));
    }
  }
  Retiming result;
  result.loops = loops;
  result.factor = steps / times.back();
  const int new_steps = whole_frames(times.back(), loops);
  const double scale = new_steps / times.back();
  for (int f = 0; f < frame_count; ++f)
    result.targets.push_back(scale * times[static_cast<size_t>(f) * fineness]);
  size_t part = 0;
  for (int f = 0; f < (loops ? new_steps : new_steps + 1); ++f) {
    const double time = f / scale;
    while (part + 2 < times.size() && times[part + 1] < time) ++part;
    const double within = (time - times[part]) / (times[part + 1] - times[part]);
    result.sources.push_back((static_cast<double>(part) + within) / fineness);
  }
  if (!loops) result.sources.back() = steps;
  return result;
}

Clip retimed(const Clip& clip, const Retiming& retiming) {
  if (interval_count(clip.frame_count(), clip.loops) < 1 || changes_nothing(retiming)) return clip;
  Clip result = clip;
  result.poses.assign(retiming.sources.size(), clip.poses.front());
  for (int joint = 0; joint < clip.body.size(); ++joint) {
    const std::vector<Directions> curve = direction_curve(clip, joint);
    std::vector<Directions> played;
    for (const double source : retiming.sources)
      played.push_back(value_at(curve, source, clip.loops));
    set_rotations(result, joint, played);
  }
  const std::vector<Directions> root = root_curve(clip);
  for (size_t f = 0; f < result.poses.size(); ++f) {
    const double source = retiming.sources[f];
    result.poses[f].root_position = value_at(root, source, clip.loops).head<3>() +
                                    source / clip.frame_count() * clip.cycle_displacement;
    result.poses[f].fingers = pose_at(clip, source / clip.frames_per_second).fingers;
  }
  return result;
}

std::vector<FootPlant> retimed(const std::vector<FootPlant>& plants, const Retiming& retiming) {
  std::vector<FootPlant> result = plants;
  for (FootPlant& plant : result) {
    const int first = static_cast<int>(std::ceil(retiming.target(plant.first) - 1e-9));
    const int last = static_cast<int>(std::floor(retiming.target(plant.last) + 1e-9));
    plant.first = std::min(first, last);
    plant.last = std::max(plant.first, last);
  }
  return result;
}

std::vector<HandHit> retimed(const std::vector<HandHit>& hits, const Retiming& retiming) {
  std::vector<HandHit> result;
  for (HandHit hit : hits) {
    const int frame = static_cast<int>(std::lround(retiming.target(hit.frame)));
    hit.frame = std::min(frame, retiming.frames_after() - 1);
    const auto is_same = [&](const HandHit& other) {
      return other.left == hit.left && other.frame == hit.frame;
    };
    if (std::none_of(result.begin(), result.end(), is_same)) result.push_back(hit);
  }
  return result;
}

double retimed_share(double share, const Retiming& retiming) {
  const int before = interval_count(retiming.frames_before(), retiming.loops);
  const int after = interval_count(retiming.frames_after(), retiming.loops);
  if (before < 1 || after < 1) return share;
  return retiming.target(share * before) / after;
}

}  // namespace mien::motion
