#include "motion/modify/tempo.h"

#include <random>

#include <gtest/gtest.h>

#include "motion/gait/contact.h"
#include "motion/procedural/walker.h"
#include "motion/random_motion.h"

#include "path_measures.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(Tempo, DividesTheDuration) {
  Clip clip = walk({}, 100.0, standard_body()).clip;
  EXPECT_NEAR(with_tempo(clip, 1.25).duration_seconds(), clip.duration_seconds() / 1.25, 0.005);
  clip.loops = false;
  EXPECT_NEAR(with_tempo(clip, 0.5).duration_seconds(), clip.duration_seconds() / 0.5, 0.005);
}

TEST(Tempo, OfHalfShowsEveryFrameAgain) {
  std::mt19937_64 random(4);
  for (const bool loops : {true, false}) {
    Clip clip = random_loop(random, 40).clip;
    clip.loops = loops;
    if (!loops) clip.cycle_displacement = Vec3::Zero();
    const Clip slow = with_tempo(clip, 0.5);
    const auto places = joint_paths(clip);
    const auto slow_places = joint_paths(slow);
    for (size_t f = 0; f < places.size(); ++f) {
      for (size_t j = 0; j < places[f].size(); ++j) {
        EXPECT_LT((places[f][j] - slow_places[2 * f][j]).norm(), 1e-9);
      }
    }
  }
}

TEST(Tempo, LeavesTheWayOfALoop) {
  const Clip clip = walk({}, 30.0, standard_body()).clip;
  const Clip fast = with_tempo(clip, 1.3);
  EXPECT_EQ(fast.cycle_displacement, clip.cycle_displacement);
  EXPECT_LT(largest_second_difference(fast), 1.3 * 1.3 * 1.3 * largest_second_difference(clip));
}

TEST(Tempo, TakesPlantsAlong) {
  const std::vector<FootPlant> plants = {{true, 10, 20}, {false, 18, 43}};
  const auto slow = with_tempo(plants, 40, 80, true);
  EXPECT_EQ(slow[0].first, 20);
  EXPECT_EQ(slow[0].last, 40);
  EXPECT_EQ(slow[1].last, 86);
  const auto fast = with_tempo(plants, 41, 21, false);
  EXPECT_EQ(fast[0].first, 5);
  EXPECT_EQ(fast[0].last, 10);
}

}  // namespace
}  // namespace mien::motion
