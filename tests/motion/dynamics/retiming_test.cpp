#include "motion/dynamics/retiming.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "motion/gait/contact.h"
#include "motion/modify/path_measures.h"
#include "motion/procedural/walker.h"
#include "motion/random_motion.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Clip at_tempo(const Clip& clip, const Tempo& tempo) {
  return retimed(clip, retiming(clip.frame_count(), clip.loops, tempo));
}

Tempo curved() {
  Tempo tempo;
  tempo.curve = {{0.0, 1.0}, {0.3, 0.6}, {0.7, 2.0}};
  return tempo;
}

TEST(Retiming, DividesTheDuration) {
  Clip clip = walk({}, 100.0, standard_body()).clip;
  EXPECT_NEAR(at_tempo(clip, 1.25).duration_seconds(), clip.duration_seconds() / 1.25, 0.005);
  clip.loops = false;
  EXPECT_NEAR(at_tempo(clip, 0.5).duration_seconds(), clip.duration_seconds() / 0.5, 0.005);
}

TEST(Retiming, ToHalfTheTempoShowsEveryFrameAgain) {
  std::mt19937_64 random(4);
  for (const bool loops : {true, false}) {
    Clip clip = random_loop(random, 40).clip;
    clip.loops = loops;
    if (!loops) clip.cycle_displacement = Vec3::Zero();
    const Clip slow = at_tempo(clip, 0.5);
    const auto places = joint_paths(clip);
    const auto slow_places = joint_paths(slow);
    for (size_t f = 0; f < places.size(); ++f) {
      for (size_t j = 0; j < places[f].size(); ++j) {
        EXPECT_LT((places[f][j] - slow_places[2 * f][j]).norm(), 1e-9);
      }
    }
  }
}

TEST(Retiming, LeavesTheWayOfALoop) {
  const Clip clip = walk({}, 30.0, standard_body()).clip;
  for (const Tempo& tempo : {Tempo(1.3), curved()}) {
    const Clip other = at_tempo(clip, tempo);
    EXPECT_EQ(other.cycle_displacement, clip.cycle_displacement);
    const double fastest = tempo.curve.empty() ? 1.3 : 2.0;
    EXPECT_LT(largest_second_difference(other),
              1.3 * fastest * fastest * largest_second_difference(clip));
  }
}

TEST(Retiming, TakesPlantsAlong) {
  const std::vector<FootPlant> plants = {{true, 10, 20}, {false, 18, 43}};
  const auto slow = retimed(plants, retiming_between(40, 80, true));
  EXPECT_EQ(slow[0].first, 20);
  EXPECT_EQ(slow[0].last, 40);
  EXPECT_EQ(slow[1].last, 86);
  const auto fast = retimed(plants, retiming_between(41, 21, false));
  EXPECT_EQ(fast[0].first, 5);
  EXPECT_EQ(fast[0].last, 10);
}

TEST(Retiming, LastsAsLongAsTheIntegralOfItsCurve) {
  // From factor a to factor b the logarithm runs along a smooth step: Simpson's rule here.
  for (const bool loops : {true, false}) {
    for (const int frames : {31, 121}) {
      constexpr int parts = 3000;
      double sum = 0.0;
      for (int i = 0; i <= parts; ++i) {
        const double weight = i == 0 || i == parts ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        sum += weight / factor_at(curved(), static_cast<double>(i) / parts, loops);
      }
      sum /= 3.0 * parts;
      const Retiming found = retiming(frames, loops, curved());
      EXPECT_NEAR(1.0 / found.factor, sum, 2e-4);
      EXPECT_EQ(interval_count(found.frames_after(), loops),
                std::lround(sum * interval_count(frames, loops)));
    }
  }
}

TEST(Retiming, PlaysEachMomentAtTheSpeedOfTheCurve) {
  for (const bool loops : {true, false}) {
    const Retiming found = retiming(601, loops, curved());
    const int steps = interval_count(601, loops);
    for (size_t f = 1; f < found.sources.size(); ++f) {
      const double middle = 0.5 * (found.sources[f] + found.sources[f - 1]) / steps;
      EXPECT_NEAR(found.sources[f] - found.sources[f - 1], factor_at(curved(), middle, loops),
                  0.01);
    }
  }
}

TEST(Retiming, IsItsOwnInverse) {
  for (const bool loops : {true, false}) {
    for (const Tempo& tempo : {Tempo(1.7), curved()}) {
      const Retiming found = retiming(90, loops, tempo);
      for (size_t f = 0; f < found.sources.size(); ++f)
        EXPECT_NEAR(found.target(found.sources[f]), static_cast<double>(f), 0.02);
      EXPECT_EQ(found.sources.front(), 0.0);
      if (!loops) {
        EXPECT_EQ(found.sources.back(), 89.0);
      }
      EXPECT_NEAR(retimed_share(1.0, found), 1.0, 1e-12);
      EXPECT_NEAR(retimed_share(0.0, found), 0.0, 1e-12);
    }
  }
}

TEST(Retiming, GoesOnBeyondTheSeamOfALoop) {
  const Retiming found = retiming(50, true, curved());
  for (const double frame : {3.0, 17.5, 49.0})
    EXPECT_NEAR(found.target(frame + 50.0), found.target(frame) + found.frames_after(), 1e-9);
}

TEST(Retiming, OfOneFactorIsTheSameAsAFlatCurve) {
  Tempo flat;
  flat.curve = {{0.0, 1.3}, {0.5, 1.3}};
  const Retiming one = retiming(77, false, 1.3);
  const Retiming other = retiming(77, false, flat);
  ASSERT_EQ(one.sources.size(), other.sources.size());
  for (size_t f = 0; f < one.sources.size(); ++f)
    EXPECT_NEAR(one.sources[f], other.sources[f], 1e-9);
}

TEST(Retiming, IsTheSameAtEveryFrameRate) {
  const Retiming coarse = retiming(31, false, curved());
  const Retiming fine = retiming(121, false, curved());
  for (int f = 0; f < 31; ++f) {
    EXPECT_NEAR(coarse.targets[static_cast<size_t>(f)] / (coarse.frames_after() - 1),
                fine.targets[static_cast<size_t>(4 * f)] / (fine.frames_after() - 1), 2e-4);
  }
}

}  // namespace
}  // namespace mien::motion
