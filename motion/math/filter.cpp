#include "motion/math/filter.h"

#include <algorithm>
#include <cmath>

namespace mien::motion {

namespace {

/// One second-order section with unit gain at 0 Hz, by the bilinear transform.
struct Section {
  double b0, b1, b2, a1, a2;
};

Section butterworth(double cutoff_hz, double rate_hz) {
  const double w = std::tan(pi * cutoff_hz / rate_hz);
  const double norm = 1.0 / (1.0 + std::sqrt(2.0) * w + w * w);
  const double b0 = w * w * norm;
  return {b0, 2.0 * b0, b0, 2.0 * (w * w - 1.0) * norm, (1.0 - std::sqrt(2.0) * w + w * w) * norm};
}

/// Transposed direct form II, started as if the first sample had been there for ever.
template <typename Value>
void run(const Section& section, std::vector<Value>& signal) {
  Value z2 = (section.b2 - section.a2) * signal.front();
  Value z1 = (section.b1 - section.a1) * signal.front() + z2;
  for (Value& sample : signal) {
    const Value in = sample;
    const Value out = section.b0 * in + z1;
    z1 = section.b1 * in - section.a1 * out + z2;
    z2 = section.b2 * in - section.a2 * out;
    sample = out;
  }
}

/// `pad` more samples at either end.
template <typename Value>
std::vector<Value> padded(std::span<const Value> signal, long pad, SignalEnds ends) {
  const auto count = static_cast<long>(signal.size());
  std::vector<Value> result;
  result.reserve(static_cast<size_t>(count + 2 * pad));
  for (long i = -pad; i < count + pad; ++i) {
    if (ends == SignalEnds::periodic) {
      result.push_back(signal[static_cast<size_t>(((i % count) + count) % count)]);
    } else if (i < 0) {
      result.push_back(2.0 * signal.front() - signal[static_cast<size_t>(-i)]);
    } else if (i >= count) {
      result.push_back(2.0 * signal.back() - signal[static_cast<size_t>(2 * (count - 1) - i)]);
    } else {
      result.push_back(signal[static_cast<size_t>(i)]);
    }
  }
  return result;
}

template <typename Value>
std::vector<Value> filtered(std::span<const Value> signal, double cutoff_hz, double rate_hz,
                            SignalEnds ends) {
  if (signal.size() < 2 || cutoff_hz >= 0.5 * rate_hz) return {signal.begin(), signal.end()};
  // The response to what happened three periods ago is below 1e-5.
  long pad = std::max(9L, std::lround(3.0 * rate_hz / cutoff_hz));
  if (ends == SignalEnds::open) pad = std::min(pad, static_cast<long>(signal.size()) - 1);
  const Section section = butterworth(cutoff_hz, rate_hz);
  std::vector<Value> work = padded(signal, pad, ends);
  run(section, work);
  std::reverse(work.begin(), work.end());
  run(section, work);
  std::reverse(work.begin(), work.end());
  return {work.begin() + pad, work.end() - pad};
}

}  // namespace

std::vector<double> low_pass(std::span<const double> signal, double cutoff_hz, double rate_hz,
                             SignalEnds ends) {
  return filtered(signal, cutoff_hz, rate_hz, ends);
}

std::vector<Vec3> low_pass(std::span<const Vec3> signal, double cutoff_hz, double rate_hz,
                           SignalEnds ends) {
  return filtered(signal, cutoff_hz, rate_hz, ends);
}

double gait_cutoff_hz(double frames_per_second) { return std::min(6.0, frames_per_second / 5.0); }

std::vector<Vec3> derivative(std::span<const Vec3> signal, double rate_hz, SignalEnds ends) {
  const auto count = static_cast<long>(signal.size());
  std::vector<Vec3> result(signal.size(), Vec3::Zero());
  for (long i = 0; i < count; ++i) {
    long before = i - 1;
    long after = i + 1;
    if (ends == SignalEnds::periodic) {
      before = (before + count) % count;
      after %= count;
    } else {
      before = std::max(before, 0L);
      after = std::min(after, count - 1);
    }
    const auto steps =
        ends == SignalEnds::periodic ? 2.0 : static_cast<double>(std::max(1L, after - before));
    result[static_cast<size_t>(i)] =
        (signal[static_cast<size_t>(after)] - signal[static_cast<size_t>(before)]) *
        (rate_hz / steps);
  }
  return result;
}

std::vector<double> smooth_envelope(const std::vector<double>& needed, int half_width, bool loops) {
  const int count = static_cast<int>(needed.size());
  const auto at = [&](int f) {
    return static_cast<size_t>(loops ? ((f % count) + count) % count : std::clamp(f, 0, count - 1));
  };
  std::vector<double> widened(needed.size());
  for (int f = 0; f < count; ++f) {
    for (int k = -half_width; k <= half_width; ++k) {
      widened[at(f)] = std::max(widened[at(f)], needed[at(f + k)]);
    }
  }
  std::vector<double> smooth(needed.size());
  for (int f = 0; f < count; ++f) {
    double sum = 0.0;
    double weight = 0.0;
    for (int k = -half_width; k <= half_width; ++k) {
      const double w = 1.0 + std::cos(pi * k / (half_width + 1));
      sum += w * widened[at(f + k)];
      weight += w;
    }
    smooth[at(f)] = sum / weight;
  }
  return smooth;
}

double fade(double x) {
  if (x <= 0.0) return 1.0;
  if (x >= 1.0) return 0.0;
  return 2.0 * x * x * x - 3.0 * x * x + 1.0;
}

}  // namespace mien::motion
