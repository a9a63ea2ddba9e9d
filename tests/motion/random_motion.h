#pragma once

#include <cmath>
#include <random>
#include <string>

#include "motion/math/rotation.h"
#include "motion/skeleton/example.h"

namespace mien::test {

/// A smooth looping motion of the standard body with random joint swings, `frames` at `fps`,
/// travelling along +Z. Swings stay below `amplitude` radians about each axis.
inline motion::Example random_loop(std::mt19937_64& random, int frames, double fps = 30.0,
                                   double amplitude = 0.5) {
  using namespace motion;
  std::uniform_real_distribution<double> swing(-amplitude, amplitude);
  std::uniform_real_distribution<double> phase(0.0, 2.0 * pi);
  std::uniform_real_distribution<double> share(-0.03, 0.03);
  Example example;
  example.clip.body = standard_body();
  example.clip.frames_per_second = fps;
  example.clip.loops = true;
  example.clip.cycle_displacement = Vec3(0, 0, 1.2 + swing(random));
  example.clip.poses.resize(static_cast<size_t>(frames));
  for (int f = 0; f < frames; ++f) {
    Pose& pose = example.clip.poses[static_cast<size_t>(f)];
    pose.rotations.resize(body_joint_count);
    pose.root_position = Vec3(0, 0.95, 0) + double(f) / frames * example.clip.cycle_displacement;
  }
  for (int j = 0; j < body_joint_count; ++j) {
    const Vec3 mean(swing(random), swing(random), swing(random));
    const Vec3 axis(swing(random), swing(random), swing(random));
    const double start = phase(random);
    for (int f = 0; f < frames; ++f) {
      example.clip.poses[static_cast<size_t>(f)].rotations[static_cast<size_t>(j)] =
          exp(0.5 * mean) * exp(axis * std::sin(start + 2.0 * pi * f / frames));
    }
  }
  const double duration = frames / fps;
  for (int k = 0; k <= 6; ++k) {
    const double inner = k > 0 && k < 6 ? share(random) : 0.0;
    example.keytimes.push_back((k / 6.0 + inner) * duration);
  }
  return example;
}

inline motion::ExampleSet random_loops(std::mt19937_64& random, int count) {
  motion::ExampleSet set;
  std::uniform_int_distribution<int> frames(24, 50);
  for (int i = 0; i < count; ++i) {
    set.examples.push_back(random_loop(random, frames(random)));
    set.examples.back().name = "example-" + std::to_string(i);
  }
  return set;
}

}  // namespace mien::test
