#include <gtest/gtest.h>

#include "motion/gait/loop.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(SeamCost, VanishesAfterAWholePeriodWhereverOneHeads) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 3.0));
  EXPECT_NEAR(seam_cost(clip, 50, 150), 0.0, 1e-9);
  EXPECT_GT(seam_cost(clip, 50, 100), 0.1);
  SyntheticWalk turned = steady_walk(1.2, 3.0);
  turned.heading = 1.0;
  EXPECT_NEAR(seam_cost(synthetic_clip(turned), 50, 100), seam_cost(clip, 50, 100), 1e-9);
}

TEST(BestCut, FindsThePeriodNearby) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 3.0));
  const CycleRange cut = best_cut(clip, {52, 149}, 3);
  EXPECT_EQ(cut.end - cut.start, 100);
  EXPECT_LE(std::abs(cut.start - 52), 3);
  EXPECT_LE(std::abs(cut.end - 149), 3);
}

TEST(BestCut, StaysInsideTheClip) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 1.0));
  const CycleRange cut = best_cut(clip, {1, 99}, 3);
  EXPECT_GE(cut.start, 0);
  EXPECT_LE(cut.end, 100);
}

}  // namespace
}  // namespace mien::motion
