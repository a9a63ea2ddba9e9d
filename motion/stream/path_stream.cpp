#include "motion/stream/path_stream.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/math/pyramid.h"
#include "motion/modify/nine_grid.h"

namespace mien::motion {

namespace {

/// Bands before those that have the gain of the rest.
int levels_of(const BandWeights& weights) {
  auto levels = static_cast<int>(weights.gains.size());
  while (levels > 0 && weights.gains[static_cast<size_t>(levels - 1)] == weights.rest_gain) {
    --levels;
  }
  return levels;
}

/// Samples to either side that a filter of so many levels weighs.
long reach_of(int levels) { return 2 * ((1L << levels) - 1); }

/// Impulse response of the band weighting.
std::vector<double> band_response(const BandWeights& weights, int levels) {
  const auto reach = static_cast<size_t>(reach_of(levels));
  std::vector<double> single(std::max<size_t>(2 * reach + 1, 2), 0.0);
  single[reach] = 1.0;
  const std::span<const double> gains(weights.gains.data(), static_cast<size_t>(levels));
  std::vector<double> response =
      with_band_gains(std::span<const double>(single), gains, weights.rest_gain, SignalEnds::open);
  response.resize(2 * reach + 1);
  return response;
}

bool carries_legs(size_t joint) { return joint == Pelvis || joint >= LeftHip; }

}  // namespace

PathMix path_mix(const Modification& modification) {
  if (modification.gains) return {*modification.gains, 1.0};
  const double away = modification.paths - 1.0;
  return {away > 0.0 ? longest_path_gains() : shortest_path_gains(), std::abs(away)};
}

int path_reach(const PathGains& gains, double frames_per_second) {
  const BandWeights weights = band_weights(gains, frames_per_second);
  const long samples = reach_of(levels_of(weights));
  // A spline needs the frame after the next.
  const long spline = weights.factor > 1 && samples > 0 ? 1 : 0;
  return static_cast<int>((samples + weights.factor - 1) / weights.factor + spline);
}

PathStream::PathStream(const PathMix& mix, double frames_per_second, int look_ahead)
    : weights_(band_weights(mix.gains, frames_per_second)),
      share_(mix.share),
      legs_(mix.legs),
      look_ahead_(look_ahead),
      response_(band_response(weights_, levels_of(weights_))) {
  assert(look_ahead >= 0);
}

/// Between the last two frames the curve is computed as if the last were repeated, until the next
/// frame is known.
void PathStream::extend(Signal& signal, const Quat& rotation) const {
  const int factor = weights_.factor;
  signal.newest.push_back(directions_of(rotation));
  if (signal.newest.size() > 4) signal.newest.pop_front();
  if (factor == 1 || signal.newest.size() == 1) {
    signal.dense.push_back(signal.newest.back());
    return;
  }
  const std::vector<Directions> curve(signal.newest.begin(), signal.newest.end());
  const int intervals = std::min(2, static_cast<int>(curve.size()) - 1);
  const int first = static_cast<int>(curve.size()) - 1 - intervals;
  // Of the older interval only its samples within, and the frame at its end, are there already.
  if (intervals == 2) signal.dense.resize(signal.dense.size() - static_cast<size_t>(factor));
  for (int i = 1; i <= intervals * factor; ++i) {
    signal.dense.push_back(value_at(curve, first + static_cast<double>(i) / factor, false));
  }
}

Directions PathStream::filtered(const Signal& signal) const {
  const auto reach = static_cast<long>(response_.size() / 2);
  const long centre = given_ * weights_.factor - first_dense_;
  const auto last = static_cast<long>(signal.dense.size()) - 1;
  Directions sum = Directions::Zero();
  for (long i = -reach; i <= reach; ++i) {
    const long at = std::clamp(centre + i, 0L, last);
    sum += response_[static_cast<size_t>(i + reach)] * signal.dense[static_cast<size_t>(at)];
  }
  return sum;
}

std::optional<Pose> PathStream::push(const Pose& pose) {
  for (size_t j = 0; j < signals_.size(); ++j) extend(signals_[j], pose.rotations[j]);
  waiting_.push_back(pose);
  if (waiting_.size() <= static_cast<size_t>(look_ahead_)) return std::nullopt;
  return next();
}

std::vector<Pose> PathStream::finish() {
  if (given_ == 0) {
    // All of the motion is there, and it may hold fewer bands than a longer one.
    const int most = band_count(signals_.front().dense.size());
    response_ = band_response(weights_, std::min(levels_of(weights_), most));
  }
  std::vector<Pose> rest;
  while (!waiting_.empty()) rest.push_back(next());
  return rest;
}

Pose PathStream::next() {
  const Pose original = std::move(waiting_.front());
  waiting_.pop_front();
  Pose longer = original;
  for (size_t j = 0; j < signals_.size(); ++j) {
    if (!legs_ && carries_legs(j)) continue;
    const Quat& previous = (longer_before_ ? *longer_before_ : original).rotations[j];
    longer.rotations[j] = to_rotation(filtered(signals_[j]), previous);
  }
  longer_before_ = longer;
  ++given_;
  drop_past_frames();
  if (share_ >= 1.0) return longer;
  const std::array<const Pose*, 2> both = {&original, &longer};
  const std::array<double, 2> shares = {1.0 - share_, share_};
  before_ = mean_pose(both, shares, before_ ? *before_ : original);
  return *before_;
}

void PathStream::drop_past_frames() {
  const auto reach = static_cast<long>(response_.size() / 2);
  // The two newest intervals may still change.
  const auto kept = static_cast<long>(signals_.front().dense.size()) - 2 * weights_.factor - 1;
  const long needed = std::min(given_ * weights_.factor - reach, first_dense_ + kept);
  for (; first_dense_ < needed; ++first_dense_) {
    for (Signal& signal : signals_) signal.dense.pop_front();
  }
}

}  // namespace mien::motion
