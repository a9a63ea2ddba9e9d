#include "motion/modify/path_length.h"

#include <algorithm>
#include <cmath>

#include "motion/math/pyramid.h"
#include "motion/modify/turn_curve.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/hand.h"
#include "motion/skeleton/joint_curve.h"
#include "motion/skeleton/recorded_hands.h"

namespace mien::motion {

namespace {

constexpr double low_to_middle_hz = 1.0;
constexpr double middle_to_high_hz = 12.5;
constexpr double transition_octaves = 0.5;

/// 0 well below `border_hz`, 1 well above it.
double share_above(double hz, double border_hz) {
  return std::clamp(0.5 + std::log2(hz / border_hz) / transition_octaves, 0.0, 1.0);
}

double group_gain(const PathGains& gains, double hz) {
  const double above_low = share_above(hz, low_to_middle_hz);
  const double above_middle = share_above(hz, middle_to_high_hz);
  return gains.low + above_low * (gains.middle - gains.low) +
         above_middle * (gains.high - gains.middle);
}

/// `factor` samples for each one of the curve, by splines.
std::vector<Directions> oversampled(const std::vector<Directions>& curve, int factor, bool loops) {
  const size_t count = loops ? curve.size() * static_cast<size_t>(factor)
                             : (curve.size() - 1) * static_cast<size_t>(factor) + 1;
  std::vector<Directions> dense;
  dense.reserve(count);
  for (size_t i = 0; i < count; ++i) {
    dense.push_back(value_at(curve, static_cast<double>(i) / factor, loops));
  }
  return dense;
}

/// The filter for one signal of a joint, whatever six numbers it holds.
struct BandFilter : BandWeights {
  bool loops = false;

  std::vector<Directions> operator()(const std::vector<Directions>& curve) const {
    const SignalEnds ends = loops ? SignalEnds::periodic : SignalEnds::open;
    if (factor == 1) {
      return with_band_gains(std::span<const Directions>(curve), gains, rest_gain, ends);
    }
    const std::vector<Directions> dense = oversampled(curve, factor, loops);
    const std::vector<Directions> filtered =
        with_band_gains(std::span<const Directions>(dense), gains, rest_gain, ends);
    std::vector<Directions> result;
    result.reserve(curve.size());
    for (size_t i = 0; i < curve.size(); ++i) {
      result.push_back(filtered[i * static_cast<size_t>(factor)]);
    }
    return result;
  }
};

void filter_logarithms(Clip& clip, int joint, const BandFilter& filter) {
  TurnCurve turns = turn_curve(clip, joint);
  std::vector<Directions> curve(turns.turns.size(), Directions::Zero());
  for (size_t f = 0; f < curve.size(); ++f) curve[f].head<3>() = turns.turns[f];
  curve = filter(curve);
  for (size_t f = 0; f < curve.size(); ++f) turns.turns[f] = curve[f].head<3>();
  set_rotations(clip, joint, turns);
}

void filter_joints(Clip& clip, int first, RotationSignal signal, const BandFilter& filter) {
  for (int joint = first; joint < clip.body.size(); ++joint) {
    if (signal == RotationSignal::quaternions)
      filter_logarithms(clip, joint, filter);
    else
      set_rotations(clip, joint, filter(direction_curve(clip, joint)));
  }
}

void filter_fingers(Clip& clip, RotationSignal signal, const BandFilter& filter) {
  Clip hands;
  hands.body = with_fingers(clip.body);
  for (const Pose& pose : clip.poses) hands.poses.push_back(with_fingers(pose));
  filter_joints(hands, body_joint_count, signal, filter);
  for (size_t f = 0; f < clip.poses.size(); ++f)
    std::copy_n(hands.poses[f].rotations.begin() + body_joint_count, finger_joint_count,
                clip.poses[f].fingers.begin());
}

}  // namespace

PathGains longest_path_gains() { return {1.0, longest_middle_gain, high_gain, {}}; }

PathGains shortest_path_gains() { return {1.0, shortest_middle_gain, high_gain, {}}; }

int oversampling(double frames_per_second) {
  int factor = 1;
  while (factor * frames_per_second < 50.0) factor *= 2;
  return factor == 2 ? 4 : factor;
}

std::vector<double> band_gains(const PathGains& gains, double rate_hz) {
  std::vector<double> result;
  for (int band = 0;; ++band) {
    const double hz = band_peak_hz(band, rate_hz);
    if (share_above(hz, low_to_middle_hz) == 0.0) return result;
    result.push_back(group_gain(gains, hz));
  }
}

BandWeights band_weights(const PathGains& gains, double frames_per_second) {
  if (!gains.bands.empty()) return {gains.bands, gains.low, 1};
  const int factor = oversampling(frames_per_second);
  return {band_gains(gains, factor * frames_per_second), gains.low, factor};
}

Clip with_path_gains(const Clip& clip, const PathGains& gains, RotationSignal signal,
                     FingerPaths hands) {
  Clip result = clip;
  if (clip.poses.empty()) return result;
  const BandFilter filter{band_weights(gains, clip.frames_per_second), clip.loops};
  filter_joints(result, 0, signal, filter);
  if (hands == FingerPaths::scaled && has_fingers(clip)) filter_fingers(result, signal, filter);
  return result;
}

}  // namespace mien::motion
