#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "motion/math/rotation.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/clip.h"

namespace mien::test {

/// A walk of the set of ten: "normal", "sad", "happy", …
inline motion::Example builtin_walk(std::string_view name) {
  static const motion::ExampleSet set = motion::builtin_examples("walks-10");
  const auto found = std::find_if(set.examples.begin(), set.examples.end(),
                                  [&](const motion::Example& e) { return e.name == name; });
  return *found;
}

/// Largest difference of two clips with equally many frames: metres of the root (and of the way of
/// a cycle), radians of any joint. Infinite when they differ in length, rate or looping.
inline double largest_difference(const motion::Clip& a, const motion::Clip& b) {
  if (a.frame_count() != b.frame_count() || a.loops != b.loops ||
      a.frames_per_second != b.frames_per_second) {
    return HUGE_VAL;
  }
  double largest = (a.cycle_displacement - b.cycle_displacement).norm();
  for (size_t i = 0; i < a.poses.size(); ++i) {
    const motion::Pose& p = a.poses[i];
    const motion::Pose& q = b.poses[i];
    largest = std::max(largest, (p.root_position - q.root_position).norm());
    for (size_t j = 0; j < p.rotations.size(); ++j) {
      largest = std::max(largest, motion::angle_between(p.rotations[j], q.rotations[j]));
    }
  }
  return largest;
}

/// Largest second difference of any joint's rotation over frames, radians, across the seam of a
/// loop too: a pop stands out.
inline double largest_pop(const motion::Clip& clip) {
  const int count = clip.frame_count();
  double largest = 0.0;
  for (int i = clip.loops ? 0 : 1; i < (clip.loops ? count : count - 1); ++i) {
    const motion::Pose& before = clip.poses[(i + count - 1) % count];
    const motion::Pose& here = clip.poses[i];
    const motion::Pose& after = clip.poses[(i + 1) % count];
    for (size_t j = 0; j < here.rotations.size(); ++j) {
      const motion::Vec3 change = motion::log(after.rotations[j] * here.rotations[j].conjugate()) -
                                  motion::log(here.rotations[j] * before.rotations[j].conjugate());
      largest = std::max(largest, change.norm());
    }
  }
  return largest;
}

}  // namespace mien::test
