#pragma once

#include <span>
#include <vector>

namespace mien::motion {

/// Shape of a time warp between corresponding keytimes.
enum class WarpShape {
  monotone,  ///< monotone cubic (Fritsch and Carlson 1980), speed continuous at keytimes; default
  linear,    ///< piecewise linear, as in the adjective paper
};

/// A strictly increasing map from the time of one motion to that of another, exact at the keytimes.
struct TimeWarp {
  std::vector<double> from;    ///< seconds, ascending
  std::vector<double> to;      ///< seconds, ascending
  std::vector<double> slopes;  ///< d to/d from at each keytime; empty for the linear shape
};

/// Creates a time warp. Both spans contain the same number (≥ 2) of strictly ascending times, in
/// seconds. With `periodic`, the first and the last keytime, which are the same moment of a loop,
/// have the same slope.
TimeWarp make_time_warp(std::span<const double> from, std::span<const double> to, WarpShape shape,
                        bool periodic);

/// The corresponding time in the other motion, seconds, clamped to its first and last keytime.
double warped(const TimeWarp& warp, double seconds);

}  // namespace mien::motion
