#pragma once

#include <span>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::motion {

/// Extension of a signal beyond its ends for filtering.
enum class SignalEnds {
  open,      ///< the signal turned half round its end points (odd reflection)
  periodic,  ///< the signal again: sample n is sample 0
};

/// Butterworth low-pass of order 2 run forward and backward, so that nothing is delayed; at
/// `cutoff_hz` the amplitude is halved (−3 dB twice). A cutoff of half the rate or more returns the
/// signal as it is. Both frequencies must be > 0.
std::vector<double> low_pass(std::span<const double> signal, double cutoff_hz, double rate_hz,
                             SignalEnds ends = SignalEnds::open);
std::vector<Vec3> low_pass(std::span<const Vec3> signal, double cutoff_hz, double rate_hz,
                           SignalEnds ends = SignalEnds::open);

/// Cutoff that keeps gait and drops marker noise: 6 Hz, at low frame rates a fifth of the rate.
double gait_cutoff_hz(double frames_per_second);

/// Central differences times `rate_hz`; one-sided at the ends of an open signal. Zero for a single
/// sample.
std::vector<Vec3> derivative(std::span<const Vec3> signal, double rate_hz,
                             SignalEnds ends = SignalEnds::open);

/// A smooth curve that is nowhere below `needed`: the largest need within `half_width` frames, then
/// averaged over as many by a raised cosine. Needs are ≥ 0. The envelope of a loop is periodic.
std::vector<double> smooth_envelope(const std::vector<double>& needed, int half_width, bool loops);

/// Smooth step from 1 (x ≤ 0) to 0 (x ≥ 1), with zero slope at both ends: 1 − smooth_step(x)
/// (geometry.h).
double fade(double x);

}  // namespace mien::motion
