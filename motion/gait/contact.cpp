#include "motion/gait/contact.h"

#include <algorithm>
#include <cmath>

#include "motion/math/filter.h"
#include "motion/math/percentile.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

constexpr double exactly = 1e-6;  // metres
constexpr int laps =
    3;  // a loop is looked at three times round; the middle lap has both neighbours

Clip unrolled(const Clip& clip) { return clip.loops ? repeated(clip, laps) : clip; }

/// Metres per second relative to the floor, of the path without marker noise.
std::vector<double> speeds_of(const std::vector<Vec3>& path, double rate, const Vec3& floor) {
  const std::vector<Vec3> smooth = low_pass(path, std::min(10.0, 0.3 * rate), rate);
  std::vector<double> speeds;
  for (const Vec3& velocity : derivative(smooth, rate)) speeds.push_back((velocity - floor).norm());
  return speeds;
}

std::vector<bool> touching(const std::vector<SolePoints>& sole, Vec3 SolePoints::*point,
                           double rate, const ContactOptions& options) {
  std::vector<Vec3> path;
  for (const SolePoints& points : sole) path.push_back(points.*point);
  const std::vector<double> speeds = speeds_of(path, rate, options.floor_velocity);
  std::vector<double> heights;
  for (const Vec3& position : path) heights.push_back(position.y());
  const double level = percentile(heights, 3);
  std::vector<bool> contact(path.size(), false);
  for (size_t t = 0; t < path.size(); ++t) {
    const bool was = t > 0 && contact[t - 1];
    const bool low = heights[t] - level < options.height_metres;
    contact[t] = low && speeds[t] < (was ? options.off_speed : options.on_speed);
  }
  return contact;
}

/// Flips the runs of `value` shorter than `frames` that have a neighbour on both sides.
void flip_short_runs(std::vector<bool>& signal, bool value, double frames) {
  size_t start = 0;
  while (start < signal.size()) {
    size_t end = start;
    while (end < signal.size() && signal[end] == signal[start]) ++end;
    const bool inside = start > 0 && end < signal.size();
    if (inside && signal[start] == value && static_cast<double>(end - start) < frames) {
      std::fill(signal.begin() + static_cast<long>(start), signal.begin() + static_cast<long>(end),
                !value);
    }
    start = end;
  }
}

std::vector<bool> middle_lap(const std::vector<bool>& signal, int frames) {
  return {signal.begin() + frames, signal.begin() + 2L * frames};
}

FootContact unrolled_contact(const Clip& clip, bool left, const ContactOptions& options) {
  const std::vector<SolePoints> sole = sole_paths(clip, left);
  const double rate = clip.frames_per_second;
  FootContact contact;
  contact.heel = touching(sole, &SolePoints::heel, rate, options);
  contact.toes = touching(sole, &SolePoints::ball, rate, options);
  const std::vector<bool> tip = touching(sole, &SolePoints::tip, rate, options);
  contact.foot.resize(sole.size());
  for (size_t t = 0; t < sole.size(); ++t) {
    contact.toes[t] = contact.toes[t] || tip[t];
    contact.foot[t] = contact.heel[t] || contact.toes[t];
  }
  flip_short_runs(contact.foot, false, options.shortest_gap * clip.frames_per_second);
  flip_short_runs(contact.foot, true, options.shortest_plant * clip.frames_per_second);
  return contact;
}

/// Runs of contact that begin in [from, to), as frames after `from`.
std::vector<FootPlant> plants_between(const std::vector<bool>& contact, bool left, int from,
                                      int to) {
  std::vector<FootPlant> plants;
  const int count = static_cast<int>(contact.size());
  for (int t = from; t < to; ++t) {
    if (!contact[t] || (t > 0 && contact[t - 1])) continue;
    int last = t;
    while (last + 1 < count && contact[last + 1]) ++last;
    plants.push_back({left, t - from, last - from});
  }
  return plants;
}

std::vector<FootPlant> plants_of_foot(const Clip& clip, bool left, const ContactOptions& options) {
  const std::vector<bool> contact = unrolled_contact(unrolled(clip), left, options).foot;
  const int frames = clip.frame_count();
  if (!clip.loops) return plants_between(contact, left, 0, frames);
  std::vector<FootPlant> plants = plants_between(contact, left, frames, 2 * frames);
  if (plants.empty() && contact[frames]) plants.push_back({left, 0, frames - 1});
  return plants;
}

/// The common velocity of the feet of a clip while they are low.
Vec3 velocity_of_planted_feet(const Clip& clip) {
  std::vector<double> x;
  std::vector<double> z;
  for (const bool left : {true, false}) {
    std::vector<Vec3> path;
    for (const SolePoints& points : sole_paths(clip, left)) path.push_back(points.ball);
    const std::vector<Vec3> velocity = derivative(path, clip.frames_per_second);
    std::vector<double> heights;
    for (const Vec3& position : path) heights.push_back(position.y());
    const double low = percentile(heights, 30);
    for (size_t t = 0; t < path.size(); ++t) {
      if (heights[t] > low) continue;
      x.push_back(velocity[t].x());
      z.push_back(velocity[t].z());
    }
  }
  return {percentile(x, 50), 0.0, percentile(z, 50)};
}

}  // namespace

FootContact foot_contact(const Clip& clip, bool left, const ContactOptions& options) {
  FootContact contact = unrolled_contact(unrolled(clip), left, options);
  if (!clip.loops) return contact;
  for (std::vector<bool>* part : {&contact.heel, &contact.toes, &contact.foot}) {
    *part = middle_lap(*part, clip.frame_count());
  }
  return contact;
}

std::vector<FootPlant> foot_plants(const Clip& clip, const ContactOptions& options) {
  std::vector<FootPlant> plants = plants_of_foot(clip, true, options);
  const std::vector<FootPlant> right = plants_of_foot(clip, false, options);
  plants.insert(plants.end(), right.begin(), right.end());
  std::stable_sort(plants.begin(), plants.end(),
                   [](const FootPlant& a, const FootPlant& b) { return a.first < b.first; });
  return plants;
}

Vec3 floor_velocity(const Clip& loop) {
  constexpr double slowest_walk = 0.1;    // m/s
  constexpr double slowest_floor = 0.15;  // m/s, under a loop that does not come back exactly
  const double travel = horizontal(loop.cycle_displacement).norm();
  if (!loop.loops || travel > slowest_walk * loop.duration_seconds()) return Vec3::Zero();
  const Vec3 velocity = velocity_of_planted_feet(unrolled(loop));
  return travel < exactly || velocity.norm() >= slowest_floor ? velocity : Vec3::Zero();
}

bool stays_in_place(const Clip& clip) {
  return clip.loops && (clip.cycle_displacement.isZero(exactly) || !floor_velocity(clip).isZero());
}

}  // namespace mien::motion
