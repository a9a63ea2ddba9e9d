#include "motion/modify/nine_grid.h"

#include <array>

#include <gtest/gtest.h>

#include "motion/gait/contact.h"
#include "motion/procedural/walker.h"

#include "path_measures.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Clip ordinary_walk() { return walk({}, 100.0, standard_body()).clip; }

/// {short, as is, long} × {constant, as is, accelerated}.
std::vector<Clip> nine_motions(const Clip& clip) {
  std::vector<Clip> grid;
  for (int i = 0; i < 9; ++i) {
    Modification place;
    place.paths = i / 3;
    place.acceleration = i % 3 - 1;
    grid.push_back(grid_motion(clip, foot_plants(clip), place));
  }
  return grid;
}

TEST(NineGrid, HoldsTheOriginalInItsMiddle) {
  const Clip clip = ordinary_walk();
  EXPECT_EQ(largest_distance(nine_motions(clip)[4], clip), 0.0);
}

TEST(NineGrid, GrowsFromShortToLongAndFromConstantToAccelerated) {
  const Clip clip = ordinary_walk();
  const auto grid = nine_motions(clip);
  const auto length = [&](size_t i) { return path_length(grid[i], LeftWrist); };
  const auto variation = [&](size_t i) { return speed_variation(grid[i], LeftWrist); };
  for (size_t e = 0; e < 3; ++e) {
    EXPECT_LT(length(e), length(3 + e));
    EXPECT_LT(length(3 + e), length(6 + e));
  }
  for (size_t u = 0; u < 3; ++u) {
    EXPECT_LT(variation(3 * u), variation(3 * u + 1)) << u;
    EXPECT_LT(variation(3 * u + 1), variation(3 * u + 2)) << u;
  }
}

TEST(NineGrid, IsBilinearBetweenItsNodes) {
  const Clip clip = ordinary_walk();
  const auto plants = foot_plants(clip);
  const auto grid = nine_motions(clip);
  Modification place;
  place.paths = 1.3;
  place.acceleration = 0.25;
  // As is, accelerated, long, and both.
  const std::array<Clip, 4> around = {grid[4], grid[5], grid[7], grid[8]};
  const std::array<double, 4> weights = {0.7 * 0.75, 0.7 * 0.25, 0.3 * 0.75, 0.3 * 0.25};
  EXPECT_LT(largest_distance(grid_motion(clip, plants, place), mean_clip(around, weights)), 1e-12);
}

TEST(NineGrid, MixesClipsInAnyOrder) {
  const Clip clip = ordinary_walk();
  const auto grid = nine_motions(clip);
  const std::array<Clip, 3> clips = {grid[0], grid[4], grid[8]};
  const std::array<Clip, 3> others = {grid[8], grid[0], grid[4]};
  const std::array<double, 3> weights = {0.2, 0.5, 0.3};
  const std::array<double, 3> other_weights = {0.3, 0.2, 0.5};
  EXPECT_LT(largest_distance(mean_clip(clips, weights), mean_clip(others, other_weights)), 1e-12);
}

TEST(NineGrid, TakesExplicitGainsForItsPaths) {
  const Clip clip = ordinary_walk();
  const auto plants = foot_plants(clip);
  Modification place;
  place.gains = PathGains{1.0, 1.8, 0.3, {}};
  Modification longest;
  longest.paths = 2.0;
  EXPECT_LT(largest_distance(grid_motion(clip, plants, place), grid_motion(clip, plants, longest)),
            1e-12);
}

}  // namespace
}  // namespace mien::motion
