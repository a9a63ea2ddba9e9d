#include <gtest/gtest.h>

#include "motion/gait/gait_events.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

/// A body that bobs between 0.8 and 1.0 m, high at frames 50, 150, …
Clip bobbing() {
  SyntheticWalk walk;
  walk.distance.assign(200, 0.0);
  Clip clip = synthetic_clip(walk);
  for (int t = 0; t < 200; ++t) {
    clip.poses[t].root_position.y() = 0.9 - 0.1 * std::cos(2 * pi * t / 100.0);
  }
  return clip;
}

TEST(Flight, IsAGapBetweenPlantsWithTheBodyUp) {
  const std::vector<FootPlant> plants = {{false, 0, 40}, {true, 61, 140}};
  const std::vector<Flight> found = flights(bobbing(), plants);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first, 41);
  EXPECT_EQ(found[0].last, 60);
  EXPECT_FALSE(found[0].takes_off_left);
  EXPECT_TRUE(found[0].lands_left);
}

TEST(Flight, IsNotAGapWithTheBodyDown) {
  EXPECT_TRUE(flights(bobbing(), {{false, 20, 90}, {true, 111, 190}}).empty());
}

TEST(Flight, IsNotWhileTheOtherFootStands) {
  EXPECT_TRUE(flights(bobbing(), {{false, 0, 40}, {true, 30, 120}, {false, 61, 140}}).empty());
}

TEST(Flight, IsNotShorterThanSixHundredths) {
  EXPECT_TRUE(flights(bobbing(), {{false, 0, 47}, {true, 52, 140}}).empty());
}

TEST(FootChanges, AreAlsoThoseOfSlowRunsThatHardlyFly) {
  for (const std::vector<FootPlant>& plants :
       {std::vector<FootPlant>{{false, 0, 47}, {true, 52, 140}},
        std::vector<FootPlant>{{false, 0, 51}, {true, 50, 140}}}) {
    const std::vector<Flight> found = foot_changes(bobbing(), plants);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].first, plants[0].last + 1);
    EXPECT_EQ(found[0].last, plants[1].first - 1);
    EXPECT_TRUE(found[0].lands_left);
  }
}

TEST(FootChanges, AreFlightsToo) {
  EXPECT_EQ(foot_changes(bobbing(), {{false, 0, 40}, {true, 61, 140}}).size(), 1u);
}

TEST(FootChanges, AreNoStepsOfWalking) {
  EXPECT_TRUE(foot_changes(bobbing(), {{false, 20, 98}, {true, 103, 190}}).empty());  // body down
  EXPECT_TRUE(foot_changes(bobbing(), {{false, 0, 60}, {true, 45, 140}}).empty());
}

TEST(Flight, IsNoLongGapInWhichTheBodyDoesNotFall) {
  // Six tenths of a second: who flies so long rises by nearly half a metre.
  EXPECT_TRUE(flights(bobbing(), {{false, 0, 20}, {true, 81, 140}}).empty());
}

}  // namespace
}  // namespace mien::motion
