#include "motion/gait/steadiest_step.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/gait/event_contact.h"
#include "motion/gait/gait_events.h"
#include "motion/gait/loop.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/mirror.h"

namespace mien::motion {

namespace {

constexpr double longest_take = 6.0;  // seconds
constexpr double shortest_step = 0.2;
constexpr double longest_step = 0.7;
constexpr double visible_seam = 0.5;  // as in the steadiness of whole cycles (gait.cpp)
constexpr double visible_gain = 0.1;  // share of the speed
constexpr double similar_cost = 1.5;  // of steps so nearly as steady, the last is used
constexpr int most_candidates = 400;

struct Candidate {
  CycleRange range;
  double cost = 0.0;
};

/// The walking-direction speed of the pelvis around each frame, over a tenth of a second either
/// side.
std::vector<double> pelvis_speeds(const Clip& clip) {
  const int reach = std::max(1, static_cast<int>(std::lround(0.1 * clip.frames_per_second)));
  std::vector<double> speeds;
  for (int f = 0; f < clip.frame_count(); ++f) {
    const int before = std::max(0, f - reach);
    const int after = std::min(clip.frame_count() - 1, f + reach);
    speeds.push_back(
        horizontal(clip.poses[after].root_position - clip.poses[before].root_position).norm() *
        clip.frames_per_second / std::max(1, after - before));
  }
  return speeds;
}

/// Whether the feet change in the step as in running, however briefly the body flies.
bool runs(const std::vector<Flight>& changes, const CycleRange& range) {
  return std::any_of(changes.begin(), changes.end(), [&](const Flight& change) {
    return change.first <= range.end && change.last >= range.start;
  });
}

std::vector<Candidate> candidates_of(const Clip& clip, const std::vector<Flight>& changes) {
  const Clip image = mirrored(clip);
  const std::vector<double> speeds = pelvis_speeds(clip);
  const int shortest = static_cast<int>(std::ceil(shortest_step * clip.frames_per_second));
  const int longest = static_cast<int>(longest_step * clip.frames_per_second);
  std::vector<Candidate> candidates;
  for (int start = 0; start + shortest < clip.frame_count(); ++start) {
    const int last = std::min(clip.frame_count() - 1, start + longest);
    for (int end = start + shortest; end <= last; ++end) {
      if (!runs(changes, {start, end})) continue;
      const double gain = (speeds[end] - speeds[start]) / std::max(speeds[end], 0.2);
      const double seam = seam_cost(image, start, clip, end);
      candidates.push_back({{start, end}, std::pow(gain / visible_gain, 2) + seam / visible_seam});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  return candidates;
}

std::optional<GaitCycle> cycle_of_step(const Clip& clip, const Candidate& candidate) {
  const auto [start, end] = candidate.range;
  auto cycle = cycle_of_loop(mirrored_loop(clip, start, end));
  if (!cycle || !cycle->has_flight) return std::nullopt;
  cycle->left_strike += start;
  cycle->start_frame = start;
  cycle->end_frame = end;
  cycle->starts_left = false;
  cycle->is_half = true;
  cycle->steadiness = 1.0 / (1.0 + 0.1 * candidate.cost);
  return cycle;
}

}  // namespace

std::optional<GaitCycle> steadiest_step(const Clip& clip) {
  if (clip.loops || clip.duration_seconds() > longest_take) return std::nullopt;
  const std::vector<FootPlant> plants = foot_plants(clip, event_contact());
  if (flights(clip, plants).empty()) return std::nullopt;
  std::optional<GaitCycle> best;
  double least = 0.0;
  int tried = 0;
  for (const Candidate& candidate : candidates_of(clip, foot_changes(clip, plants))) {
    if (++tried > most_candidates || (best && candidate.cost > similar_cost * least)) break;
    if (best && candidate.range.end <= best->end_frame) continue;
    auto cycle = cycle_of_step(clip, candidate);
    if (!cycle) continue;
    if (!best) least = candidate.cost;
    best = std::move(cycle);
  }
  return best;
}

}  // namespace mien::motion
