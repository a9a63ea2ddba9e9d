#include "motion/gait/flight_keytimes.h"

#include <algorithm>
#include <cmath>

#include "motion/gait/stride.h"

namespace mien::motion {

namespace {

constexpr double latest_toe_off = 0.02;  // seconds after the other foot's strike

/// The stride that begins at the second left heel strike of the unrolled loop, if it is one cycle.
std::optional<Stride> stride_of_loop(const Clip& loop) {
  const int frames = loop.frame_count();
  const Clip unrolled = repeated(loop, 4);
  const std::vector<GaitEvent> events = gait_events(unrolled);
  for (const Stride& stride : strides(events, foot_progress(unrolled), true)) {
    const bool in_second_lap = stride.strike >= frames - 0.5 && stride.strike < 2 * frames - 0.5;
    if (in_second_lap && std::abs(stride.period() - frames) <= 0.1 * frames) return stride;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::array<double, gait_keytime_count>> flight_keytimes(const Clip& loop) {
  const auto stride = stride_of_loop(loop);
  if (!stride) return std::nullopt;
  const Stride& s = *stride;
  const double latest = latest_toe_off * loop.frames_per_second + 0.5;
  if (s.toe_off > s.other_strike + latest || s.other_toe_off > s.strike + latest) {
    return std::nullopt;
  }
  const double period = s.period();
  if (period < gait_keytime_count) return std::nullopt;
  std::array<double, gait_keytime_count> keys = {0.0,
                                                 s.other_passes - s.strike,
                                                 s.toe_off - s.strike,
                                                 s.other_strike - s.strike,
                                                 s.passes - s.strike,
                                                 s.other_toe_off - s.strike + period,
                                                 period};
  for (size_t k = keys.size() - 1; k-- > 1;) keys[k] = std::min(keys[k], keys[k + 1] - 1.0);
  for (size_t k = 1; k + 1 < keys.size(); ++k) keys[k] = std::max(keys[k], keys[k - 1] + 1.0);
  if (keys[5] > period - 1.0 + 1e-9) return std::nullopt;
  const double seconds_per_frame = loop.duration_seconds() / period;
  for (double& key : keys) key *= seconds_per_frame;
  keys.back() = loop.duration_seconds();
  return keys;
}

}  // namespace mien::motion
