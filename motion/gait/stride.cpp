#include "motion/gait/stride.h"

#include <algorithm>
#include <cmath>

namespace mien::motion {

namespace {

using Kind = GaitEvent::Kind;

constexpr double step_margin = 0.15;  // share of the period between strikes of different feet
constexpr double toe_off_window =
    0.42;  // share of the period around the other foot's strike; runs fly long

struct EventTime {
  double frame = 0.0;
  bool confirmed = true;
};

std::vector<EventTime> moments(std::span<const GaitEvent> events, Kind kind, bool left) {
  std::vector<EventTime> found;
  for (const GaitEvent& event : events) {
    if (event.kind == kind && event.left == left) found.push_back({event.frame, event.confirmed});
  }
  return found;
}

/// The only moment in (from, to); none when there are several.
std::optional<EventTime> only_between(const std::vector<EventTime>& all, double from, double to) {
  std::optional<EventTime> only;
  for (const EventTime& moment : all) {
    if (moment.frame <= from || moment.frame >= to) continue;
    if (only) return std::nullopt;
    only = moment;
  }
  return only;
}

/// The moment nearest to `frame`, within `reach` of it.
std::optional<EventTime> nearest(const std::vector<EventTime>& all, double frame, double reach) {
  std::optional<EventTime> best;
  for (const EventTime& moment : all) {
    const double distance = std::abs(moment.frame - frame);
    if (distance > reach) continue;
    if (!best || distance < std::abs(best->frame - frame)) best = moment;
  }
  return best;
}

/// The toe off that belongs to the strike at `frame`, or one period away from it.
std::optional<EventTime> toe_off_at(const std::vector<EventTime>& toe_offs, double frame,
                                    double period) {
  for (const double shift : {0.0, period, -period}) {
    if (auto found = nearest(toe_offs, frame + shift, toe_off_window * period)) {
      found->frame -= shift;
      return found;
    }
  }
  return std::nullopt;
}

/// First frame in (from, to) at which `ahead` − `behind` rises through `level`.
std::optional<double> rising(const std::vector<double>& ahead, const std::vector<double>& behind,
                             double level, double from, double to) {
  const int last = std::min(static_cast<int>(std::floor(to)), static_cast<int>(ahead.size()) - 1);
  for (int t = std::max(1, static_cast<int>(std::ceil(from))); t <= last; ++t) {
    const double before = ahead[t - 1] - behind[t - 1] - level;
    const double after = ahead[t] - behind[t] - level;
    if (before < 0.0 && after >= 0.0) return t - 1 + before / (before - after);
  }
  return std::nullopt;
}

/// When the swinging foot passes the standing one. In a limp it may only come up to it: then when
/// it is half way.
std::optional<double> passing(const std::vector<double>& swinging,
                              const std::vector<double>& standing, double from, double to) {
  if (const auto passes = rising(swinging, standing, 0.0, from, to)) return passes;
  const auto lead = [&](double frame) {
    const auto t = static_cast<size_t>(
        std::clamp(std::round(frame), 0.0, static_cast<double>(swinging.size()) - 1.0));
    return swinging[t] - standing[t];
  };
  return rising(swinging, standing, 0.5 * (lead(from) + lead(to)), from, to);
}

struct Feet {
  std::vector<EventTime> strikes;
  std::vector<EventTime> toe_offs;
  std::vector<EventTime> other_strikes;
  std::vector<EventTime> other_toe_offs;
  const std::vector<double>& heel;
  const std::vector<double>& other_heel;
};

std::optional<Stride> stride_between(const Feet& feet, const EventTime& from, const EventTime& to,
                                     bool left) {
  const double period = to.frame - from.frame;
  const auto other = only_between(feet.other_strikes, from.frame + step_margin * period,
                                  to.frame - step_margin * period);
  if (!other) return std::nullopt;
  const auto other_off = toe_off_at(feet.other_toe_offs, from.frame, period);
  const auto own_off = toe_off_at(feet.toe_offs, other->frame, period);
  const auto other_passes = passing(feet.other_heel, feet.heel, from.frame, other->frame);
  const auto own_passes = passing(feet.heel, feet.other_heel, other->frame, to.frame);
  if (!other_off || !own_off || !other_passes || !own_passes) return std::nullopt;
  const bool confirmed = from.confirmed && to.confirmed && other->confirmed &&
                         other_off->confirmed && own_off->confirmed;
  return Stride{left,           from.frame,  other_off->frame, *other_passes, other->frame,
                own_off->frame, *own_passes, to.frame,         confirmed};
}

}  // namespace

std::vector<Stride> strides(std::span<const GaitEvent> events, const FootProgress& progress,
                            bool left) {
  const Feet feet{moments(events, Kind::heel_strike, left),
                  moments(events, Kind::toe_off, left),
                  moments(events, Kind::heel_strike, !left),
                  moments(events, Kind::toe_off, !left),
                  left ? progress.left_heel : progress.right_heel,
                  left ? progress.right_heel : progress.left_heel};
  std::vector<Stride> found;
  for (size_t i = 1; i < feet.strikes.size(); ++i) {
    if (auto stride = stride_between(feet, feet.strikes[i - 1], feet.strikes[i], left)) {
      found.push_back(*stride);
    }
  }
  return found;
}

std::optional<std::array<double, 7>> left_based_keyframes(const Stride& s) {
  const double period = s.period();
  std::array<double, 7> keys;
  if (s.left) {
    keys = {0.0,
            s.other_toe_off - s.strike,
            s.other_passes - s.strike,
            s.other_strike - s.strike,
            s.toe_off - s.strike,
            s.passes - s.strike,
            period};
  } else {
    const double right_strike = s.next_strike - s.other_strike;
    keys = {0.0,
            s.toe_off - s.other_strike,
            s.passes - s.other_strike,
            right_strike,
            right_strike + s.other_toe_off - s.strike,
            right_strike + s.other_passes - s.strike,
            period};
  }
  if (period < 7.0) return std::nullopt;
  for (size_t k = 1; k < keys.size(); ++k) keys[k] = std::max(keys[k], keys[k - 1] + 1.0);
  keys.back() = period;
  for (size_t k = keys.size() - 1; k-- > 0;) keys[k] = std::min(keys[k], keys[k + 1] - 1.0);
  return keys;
}

bool has_flight(const Stride& s) {
  return s.other_toe_off < s.strike - 0.5 || s.toe_off < s.other_strike - 0.5;
}

}  // namespace mien::motion
