#pragma once

#include <cstddef>

#include "motion/procedural/walker.h"
#include "motion/skeleton/clip.h"
#include "motion/synthetic_walk.h"

namespace mien::test {

/// A walk with level trunk and swinging arms, whose feet stay flat.
inline motion::Clip walk_of(double seconds = 3.0, double rate = 100.0) {
  return synthetic_clip(steady_walk(1.2, seconds, rate));
}

/// Three cycles of the parametric walker.
inline motion::Clip natural_walk() {
  return motion::repeated(motion::walk({}, 100.0, motion::standard_body()).clip, 3);
}

/// Whether all bits are the same.
inline bool same_pose(const motion::Pose& a, const motion::Pose& b) {
  if (a.root_position != b.root_position) return false;
  for (std::size_t j = 0; j < a.rotations.size(); ++j)
    if (a.rotations[j].coeffs() != b.rotations[j].coeffs()) return false;
  return true;
}

inline constexpr double held_metres = 1e-6;

}  // namespace mien::test
