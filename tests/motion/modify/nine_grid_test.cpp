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

TEST(NineGrid, HoldsTheOriginalInItsMiddle) {
  const Clip clip = ordinary_walk();
  const auto grid = nine_motions(clip, foot_plants(clip), {});
  ASSERT_EQ(grid.size(), 9u);
  EXPECT_EQ(grid[4].name, "as is");
  EXPECT_EQ(largest_distance(grid[4].clip, clip), 0.0);
}

TEST(NineGrid, GrowsFromShortToLongAndFromConstantToAccelerated) {
  const Clip clip = ordinary_walk();
  const auto grid = nine_motions(clip, foot_plants(clip), {});
  const auto length = [&](size_t i) { return path_length(grid[i].clip, LeftWrist); };
  const auto variation = [&](size_t i) { return speed_variation(grid[i].clip, LeftWrist); };
  for (size_t e = 0; e < 3; ++e) {
    EXPECT_LT(length(e), length(3 + e));
    EXPECT_LT(length(3 + e), length(6 + e));
  }
  for (size_t u = 0; u < 3; ++u) {
    EXPECT_LT(variation(3 * u), variation(3 * u + 1)) << u;
    EXPECT_LT(variation(3 * u + 1), variation(3 * u + 2)) << u;
  }
}

TEST(NineGrid, IsReproducedAtItsNodes) {
  const Clip clip = ordinary_walk();
  const auto plants = foot_plants(clip);
  for (const GridMotion& node : nine_motions(clip, plants, {})) {
    Modification place;
    place.paths = node.paths;
    place.acceleration = node.acceleration;
    EXPECT_LT(largest_distance(grid_motion(clip, plants, place), node.clip), 1e-12) << node.name;
  }
}

TEST(NineGrid, IsBilinearBetweenItsNodes) {
  const Clip clip = ordinary_walk();
  const auto plants = foot_plants(clip);
  const auto grid = nine_motions(clip, plants, {});
  Modification place;
  place.paths = 1.3;
  place.acceleration = 0.25;
  // As is, accelerated, long, and both.
  const std::array<Clip, 4> around = {grid[4].clip, grid[5].clip, grid[7].clip, grid[8].clip};
  const std::array<double, 4> weights = {0.7 * 0.75, 0.7 * 0.25, 0.3 * 0.75, 0.3 * 0.25};
  EXPECT_LT(largest_distance(grid_motion(clip, plants, place), mean_clip(around, weights)), 1e-12);
}

TEST(NineGrid, MixesClipsInAnyOrder) {
  const Clip clip = ordinary_walk();
  const auto grid = nine_motions(clip, foot_plants(clip), {});
  const std::array<Clip, 3> clips = {grid[0].clip, grid[4].clip, grid[8].clip};
  const std::array<Clip, 3> others = {grid[8].clip, grid[0].clip, grid[4].clip};
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
