#pragma once

#include <span>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::motion {

/// Extension of a signal beyond its ends for filtering.
enum class SignalEnds {
  open,      ///< odd reflection: the signal rotated by 180° about its end points
  periodic,  ///< the signal repeats: the last sample is followed by the first
};

/// Second-order Butterworth low-pass filter, run forward and backward for zero phase lag; at
/// `cutoff_hz` the amplitude is halved (−3 dB twice). A cutoff of half the rate or more returns the
/// signal unchanged. Both frequencies must be > 0.
std::vector<double> low_pass(std::span<const double> signal, double cutoff_hz, double rate_hz,
                             SignalEnds ends = SignalEnds::open);
std::vector<Vec3> low_pass(std::span<const Vec3> signal, double cutoff_hz, double rate_hz,
                           SignalEnds ends = SignalEnds::open);

/// Low-pass cutoff that keeps gait and removes marker noise: 6 Hz, or a fifth of the frame rate if
/// that is lower.
double gait_cutoff_hz(double frames_per_second);

/// Derivative per second by central differences, one-sided at the ends of an open signal. Zero for
/// a single sample.
std::vector<Vec3> derivative(std::span<const Vec3> signal, double rate_hz,
                             SignalEnds ends = SignalEnds::open);

/// A smooth curve that is nowhere below `needed` (values ≥ 0): the maximum of `needed` within
/// `half_width` frames, smoothed by a raised cosine of the same half width. The envelope of a loop
/// is periodic.
std::vector<double> smooth_envelope(const std::vector<double>& needed, int half_width, bool loops);

/// Smooth step from 1 (x ≤ 0) to 0 (x ≥ 1), with zero slope at both ends: 1 − smooth_step(x)
/// (geometry.h).
double fade(double x);

}  // namespace mien::motion
