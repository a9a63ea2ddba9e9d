#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <vector>

#include "motion/math/filter.h"
#include "motion/math/geometry.h"

namespace mien::motion {

/// A multiresolution decomposition (Laplacian pyramid): the signal is the sum of its bands and the
/// residual. Each has as many samples as the signal.
template <typename Value>
struct Pyramid {
  std::vector<std::vector<Value>> bands;  ///< finest first
  std::vector<Value> rest;  ///< residual: frequencies below the last band, with the mean
};

/// Number of bands of a signal: ⌊log2 samples⌋ (Bruderlin and Williams 1995).
inline int band_count(std::size_t samples) {
  return samples < 2 ? 0 : static_cast<int>(std::bit_width(samples)) - 1;
}

/// Peak frequency of band `band` (0 is the finest), Hz: 0.5, 0.1405, 0.0668 and 0.0330 times the
/// rate for the first four, then halved from band to band.
double band_peak_hz(int band, double rate_hz);

/// One step of the pyramid: the signal convolved with (1 4 6 4 1)/16, its taps 2^level apart (Burt
/// and Adelson 1983, a = 3/8).
template <typename Value>
std::vector<Value> smoothed_once(const std::vector<Value>& signal, int level, SignalEnds ends) {
  const auto count = static_cast<long>(signal.size());
  const long step = 1L << level;
  const auto at = [&](long i) -> const Value& {
    if (ends == SignalEnds::periodic) {
      i %= count;
      return signal[static_cast<std::size_t>(i < 0 ? i + count : i)];
    }
    return signal[static_cast<std::size_t>(std::clamp(i, 0L, count - 1))];
  };
  std::vector<Value> smooth(signal.size());
  const auto weighted = [&](const Value& a, const Value& b, const Value& c, const Value& d,
                            const Value& e) -> Value {
    return 0.375 * c + 0.25 * (b + d) + 0.0625 * (a + e);
  };
  const long inside = std::min(2 * step, count);
  const auto edge = [&](long i) {
    smooth[static_cast<std::size_t>(i)] =
        weighted(at(i - 2 * step), at(i - step), at(i), at(i + step), at(i + 2 * step));
  };
  for (long i = 0; i < inside; ++i) edge(i);
  for (long i = inside; i < count - 2 * step; ++i) {
    const Value* p = signal.data() + i;
    smooth[static_cast<std::size_t>(i)] =
        weighted(p[-2 * step], p[-step], p[0], p[step], p[2 * step]);
  }
  for (long i = std::max(inside, count - 2 * step); i < count; ++i) edge(i);
  return smooth;
}

/// The signal, padded at both ends with its end values. At each end, as many samples are added as
/// `levels` steps of smoothing reach to one side.
template <typename Value>
std::vector<Value> with_repeated_ends(std::span<const Value> signal, int levels) {
  const auto pad = static_cast<std::size_t>(2 * ((1L << levels) - 1));
  std::vector<Value> padded;
  padded.reserve(signal.size() + 2 * pad);
  padded.insert(padded.end(), pad, signal.front());
  padded.insert(padded.end(), signal.begin(), signal.end());
  padded.insert(padded.end(), pad, signal.back());
  return padded;
}

/// The first `levels` bands of a signal. An open signal is extended by its end values, a periodic
/// one by repetition. Value is a number or a vector of numbers.
template <typename Value>
Pyramid<Value> pyramid(std::span<const Value> signal, int levels, SignalEnds ends) {
  Pyramid<Value> result;
  if (signal.empty()) return result;
  const bool open = ends == SignalEnds::open;
  std::vector<Value> fine =
      open ? with_repeated_ends(signal, levels) : std::vector<Value>(signal.begin(), signal.end());
  const auto first = static_cast<long>((fine.size() - signal.size()) / 2);
  const auto count = static_cast<long>(signal.size());
  for (int level = 0; level < levels; ++level) {
    std::vector<Value> coarse = smoothed_once(fine, level, ends);
    std::vector<Value>& band = result.bands.emplace_back();
    band.reserve(signal.size());
    for (long i = first; i < first + count; ++i) {
      band.push_back(fine[static_cast<std::size_t>(i)] - coarse[static_cast<std::size_t>(i)]);
    }
    fine = std::move(coarse);
  }
  result.rest.assign(fine.begin() + first, fine.begin() + first + count);
  return result;
}

/// The signal with its bands weighted: band k by gains[k], and the residual below the last band by
/// `rest_gain`. Gains beyond `band_count` are ignored. The time is O(samples · gains.size()), the
/// memory O(samples).
template <typename Value>
std::vector<Value> with_band_gains(std::span<const Value> signal, std::span<const double> gains,
                                   double rest_gain, SignalEnds ends) {
  // Bands at the end that have the gain of the rest are one with it.
  int levels = std::min(static_cast<int>(gains.size()), band_count(signal.size()));
  while (levels > 0 && gains[static_cast<std::size_t>(levels - 1)] == rest_gain) --levels;
  if (signal.empty()) return {};
  // Σ g_k (G_k − G_{k+1}) + g_rest G_last = g_0 G_0 + Σ (g_k − g_{k−1}) G_k: the levels themselves
  // need not be subtracted.
  const auto gain = [&](int k) {
    return k < levels ? gains[static_cast<std::size_t>(k)] : rest_gain;
  };
  std::vector<Value> level = ends == SignalEnds::open
                                 ? with_repeated_ends(signal, levels)
                                 : std::vector<Value>(signal.begin(), signal.end());
  const auto first = (level.size() - signal.size()) / 2;
  std::vector<Value> sum;
  sum.reserve(signal.size());
  for (const Value& value : signal) sum.push_back(gain(0) * value);
  for (int k = 1; k <= levels; ++k) {
    level = smoothed_once(level, k - 1, ends);
    const double step = gain(k) - gain(k - 1);
    if (step == 0.0) continue;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += step * level[first + i];
  }
  return sum;
}

}  // namespace mien::motion
