#include "motion/modify/hit_timing.h"

#include <algorithm>

namespace mien::motion {

namespace {

constexpr double reach_seconds = 0.2;
constexpr double faster_before = 1.0;  // of the speed at the hit
constexpr double slower_after = 0.8;

/// One side of a hit.
struct Side {
  double frames;      ///< that change
  bool ends_at_turn;  ///< where the hand stands, so that its timing may change abruptly
};

struct Neighbourhood {
  Side before;
  Side after;
};

Side side_of(int turn, double free, double reach) {
  if (turn > 0) return {static_cast<double>(turn), true};
  return {std::min(free, reach), false};
}

Neighbourhood neighbourhood(std::span<const HandHit> hits, std::size_t i, int frame_count,
                            double frames_per_second, bool loops) {
  const double own = hits[i].frame;
  const auto count = static_cast<double>(frame_count);
  double before = own, after = count - 1.0 - own;  // to the ends
  if (i > 0) {
    before = 0.5 * (own - hits[i - 1].frame);
  } else if (loops) {
    before = 0.5 * (own + count - hits.back().frame);
  }
  if (i + 1 < hits.size()) {
    after = 0.5 * (hits[i + 1].frame - own);
  } else if (loops) {
    after = 0.5 * (hits.front().frame + count - own);
  }
  const double reach = reach_seconds * frames_per_second;
  return {side_of(hits[i].since_turn, before, reach), side_of(hits[i].until_turn, after, reach)};
}

/// By how many frames the source lags `away` frames from a hit, with a slope of 1 there. At the
/// other end it is 0; so is its slope, except at a turn.
double lag(double away, const Side& side) {
  if (away <= 0.0 || away >= side.frames) return 0.0;
  const double rest = 1.0 - away / side.frames;
  return away * rest * (side.ends_at_turn ? 1.0 : rest);
}

double ahead(double away, const Neighbourhood& around) {
  return away < 0.0 ? -faster_before * lag(-away, around.before)
                    : -slower_after * lag(away, around.after);
}

}  // namespace

std::vector<double> hard_hit_sources(std::span<const HandHit> hits, int frame_count,
                                     double frames_per_second, bool loops) {
  std::vector<double> sources;
  for (int f = 0; f < frame_count; ++f) sources.push_back(f);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const Neighbourhood around = neighbourhood(hits, i, frame_count, frames_per_second, loops);
    for (int f = 0; f < frame_count; ++f) {
      double away = f - hits[i].frame;
      if (loops && away > 0.5 * frame_count) away -= frame_count;
      if (loops && away < -0.5 * frame_count) away += frame_count;
      sources[static_cast<std::size_t>(f)] += ahead(away, around);
    }
  }
  return sources;
}

}  // namespace mien::motion
