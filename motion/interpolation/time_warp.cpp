#include "motion/interpolation/time_warp.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace mien::motion {

namespace {

std::vector<double> secants(std::span<const double> from, std::span<const double> to) {
  std::vector<double> slopes;
  for (size_t k = 0; k + 1 < from.size(); ++k) {
    slopes.push_back((to[k + 1] - to[k]) / (from[k + 1] - from[k]));
  }
  return slopes;
}

/// Fritsch–Carlson: mean of the neighbouring secants, limited to the circle α² + β² ≤ 9 in which
/// the cubic of an interval cannot turn back.
std::vector<double> monotone_slopes(const std::vector<double>& secant, bool periodic) {
  const size_t intervals = secant.size();
  std::vector<double> slope(intervals + 1);
  for (size_t k = 1; k < intervals; ++k) slope[k] = 0.5 * (secant[k - 1] + secant[k]);
  slope.front() = periodic ? 0.5 * (secant.front() + secant.back()) : secant.front();
  slope.back() = periodic ? slope.front() : secant.back();
  for (size_t k = 0; k < intervals; ++k) {
    const double alpha = slope[k] / secant[k];
    const double beta = slope[k + 1] / secant[k];
    const double radius = std::hypot(alpha, beta);
    if (radius <= 3.0) continue;
    slope[k] = 3.0 / radius * alpha * secant[k];
    slope[k + 1] = 3.0 / radius * beta * secant[k];
  }
  // The limiter may have touched one end of the loop only: both take the smaller, safe slope.
  if (periodic) slope.front() = slope.back() = std::min(slope.front(), slope.back());
  return slope;
}

}  // namespace

TimeWarp make_time_warp(std::span<const double> from, std::span<const double> to, WarpShape shape,
                        bool periodic) {
  assert(from.size() == to.size() && from.size() >= 2);
  TimeWarp warp{{from.begin(), from.end()}, {to.begin(), to.end()}, {}};
  if (shape == WarpShape::monotone) warp.slopes = monotone_slopes(secants(from, to), periodic);
  return warp;
}

double warped(const TimeWarp& warp, double seconds) {
  if (seconds <= warp.from.front()) return warp.to.front();
  if (seconds >= warp.from.back()) return warp.to.back();
  const auto after = std::upper_bound(warp.from.begin(), warp.from.end(), seconds);
  const auto k = static_cast<size_t>(after - warp.from.begin()) - 1;
  const double width = warp.from[k + 1] - warp.from[k];
  const double rise = warp.to[k + 1] - warp.to[k];
  const double s = (seconds - warp.from[k]) / width;
  if (warp.slopes.empty()) return warp.to[k] + s * rise;
  const double start = warp.slopes[k] * width;
  const double end = warp.slopes[k + 1] * width;
  // Hermite cubic written about the straight line, so that equal timings give `seconds` itself.
  return warp.to[k] + s * rise + s * (1.0 - s) * ((1.0 - s) * (start - rise) - s * (end - rise));
}

}  // namespace mien::motion
