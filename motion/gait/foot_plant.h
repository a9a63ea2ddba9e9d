#pragma once

namespace mien::motion {

/// An interval of frames in which one foot stands on the floor. In a looping clip `last` may lie
/// beyond the last frame: the plant continues in the next cycle.
struct FootPlant {
  bool left = true;
  int first = 0;  ///< frame
  int last = 0;   ///< frame, inclusive
};

}  // namespace mien::motion
