#pragma once

namespace mien::motion {

/// Moments that differ by less are the same, seconds.
inline constexpr double moment_tolerance = 1e-9;

/// A time in a motion: seconds since its beginning, or a frame counted from 0.
struct Moment {
  double value = 0.0;
  bool is_frame = false;

  double seconds(double frames_per_second) const {
    return is_frame ? value / frames_per_second : value;
  }

  friend bool operator==(const Moment&, const Moment&) = default;
};

}  // namespace mien::motion
