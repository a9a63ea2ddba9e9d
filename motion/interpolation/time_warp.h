#pragma once

#include <span>
#include <vector>

namespace mien::motion {

/// Shape of a time warp between corresponding keytimes.
enum class WarpShape {
  monotone,  ///< monotone cubic (Fritsch and Carlson 1980): no jump of speed at a keytime; default
  linear,    ///< piecewise linear, as in the adjective paper
};

/// A strictly increasing map of one motion's time onto another's, exact at the keytimes.
struct TimeWarp {
  std::vector<double> from;    ///< seconds, ascending
  std::vector<double> to;      ///< seconds, ascending
  std::vector<double> slopes;  ///< d to/d from at each keytime; empty for the linear shape
};

/// Both spans hold the same number (≥ 2) of strictly ascending times. `periodic` gives the first
/// and the last keytime, which are the same moment of a loop, one slope.
TimeWarp make_time_warp(std::span<const double> from, std::span<const double> to, WarpShape shape,
                        bool periodic);

/// The time in the other motion; outside the keytimes the nearest end.
double warped(const TimeWarp& warp, double seconds);

}  // namespace mien::motion
