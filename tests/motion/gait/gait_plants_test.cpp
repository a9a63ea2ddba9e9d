#include "motion/gait/gait_plants.h"

#include <gtest/gtest.h>

#include "motion/gait/contact.h"
#include "motion/gait/loop.h"
#include "motion/skeleton/straighten.h"
#include "motion/synthetic_run.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(GaitPlants, OfARunAreItsContactsHoweverShort) {
  for (const double stance : {0.2, 0.26, 0.32}) {
    SyntheticRun run;
    run.stance = stance;
    const Clip take = steady_run(run, 2.0 * run.stride, 2.5);
    for (const Clip& clip : {take, straightened(closed_loop(take, 100, 150))}) {
      const std::vector<FootPlant> found = gait_plants(clip);
      ASSERT_GE(found.size(), clip.loops ? 2U : 6U) << stance;
      for (const FootPlant& plant : found) {
        if (!clip.loops && (plant.first == 0 || plant.last == clip.frame_count() - 1)) continue;
        EXPECT_NEAR(plant.last - plant.first + 1, 50.0 * stance, 4.0) << stance;
      }
    }
  }
}

TEST(GaitPlants, OfAWalkAreThoseOfContact) {
  const Clip walk = synthetic_clip(steady_walk(1.2, 4.0));
  const std::vector<FootPlant> found = gait_plants(walk);
  const std::vector<FootPlant> expected = foot_plants(walk);
  ASSERT_EQ(found.size(), expected.size());
  for (size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(found[i].left, expected[i].left);
    EXPECT_EQ(found[i].first, expected[i].first);
    EXPECT_EQ(found[i].last, expected[i].last);
  }
}

}  // namespace
}  // namespace mien::motion
