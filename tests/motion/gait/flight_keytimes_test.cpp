#include "motion/gait/flight_keytimes.h"

#include <gtest/gtest.h>

#include "motion/gait/event_contact.h"
#include "motion/gait/gait_events.h"
#include "motion/gait/loop.h"
#include "motion/gait/steadiest_step.h"
#include "motion/skeleton/straighten.h"
#include "motion/synthetic_run.h"

namespace mien::motion {
namespace {

using namespace mien::test;

/// One cycle that begins at the left heel strike, frames 100 to 150 of a steady run.
Clip cycle_of(const SyntheticRun& run) {
  return straightened(closed_loop(steady_run(run, 2.0 * run.stride, 2.5), 100, 150));
}

TEST(FlightKeytimes, OfARunAreItsEvents) {
  const SyntheticRun run;
  const auto keytimes = flight_keytimes(cycle_of(run));
  ASSERT_TRUE(keytimes);
  const double period = 0.5;  // seconds
  const std::array<double, 7> shares = {0.0, 0.16, 0.32, 0.5, 0.66, 0.82, 1.0};
  for (size_t k = 0; k < shares.size(); ++k) {
    EXPECT_NEAR((*keytimes)[k], shares[k] * period, 0.025) << k;
  }
}

TEST(FlightKeytimes, FollowTheDurationOfTheFlight) {
  double flight = 1.0;
  for (const double stance : {0.26, 0.32, 0.38}) {
    SyntheticRun run;
    run.stance = stance;
    const auto keytimes = flight_keytimes(cycle_of(run));
    ASSERT_TRUE(keytimes) << stance;
    EXPECT_LT((*keytimes)[3] - (*keytimes)[2], flight) << stance;
    flight = (*keytimes)[3] - (*keytimes)[2];
    EXPECT_NEAR(flight, (0.5 - stance) * 0.5, 0.025) << stance;
  }
}

TEST(FlightKeytimes, OfAWalkAreNone) {
  const Clip walk = synthetic_clip(steady_walk(1.2, 4.0));
  EXPECT_FALSE(flight_keytimes(straightened(closed_loop(walk, 100, 200))));
}

/// Starts slowly, gains speed, and ends after its second step, so that no stride repeats.
Clip start_of_run(const SyntheticRun& run = {}, double gain = 0.05, int frames = 70) {
  std::vector<double> distance = {0.2};
  for (int f = 1; f < frames; ++f) {
    distance.push_back(distance.back() + std::min(0.5 + gain * f, 3.0) / 100.0);
  }
  return synthetic_run(run, distance);
}

TEST(SteadiestStep, OfARunThatStartsIsUsedWithItsMirrorImage) {
  const auto cycle = steadiest_cycle(start_of_run());
  ASSERT_TRUE(cycle);
  EXPECT_TRUE(cycle->is_half);
  EXPECT_TRUE(cycle->has_flight);
  ASSERT_FALSE(cycle->warnings.empty());
  EXPECT_NE(cycle->warnings.back().find("mirror image"), std::string::npos);
  // At full speed: a step of 0.75 m at 3 m/s.
  EXPECT_NEAR(cycle->keytimes.back(), 0.5, 0.06);
  EXPECT_NEAR(cycle->speed_m_s, 3.0, 0.3);
}

TEST(SteadiestStep, MayFlyOnlyBriefly) {
  SyntheticRun run;
  run.stance = 0.44;
  run.bounce = 0.05;
  const Clip take = start_of_run(run, 0.03, 90);
  const std::vector<FootPlant> plants = foot_plants(take, event_contact());
  ASSERT_EQ(flights(take, plants).size(), 1u);  // of the first, slow step: 0.06 s
  ASSERT_EQ(foot_changes(take, plants).size(), 2u);
  const auto step = steadiest_step(take);
  ASSERT_TRUE(step);
  EXPECT_GT(step->speed_m_s, 2.6);
}

TEST(SteadiestStep, OfAWalkIsNone) {
  EXPECT_FALSE(steadiest_step(synthetic_clip(steady_walk(1.2, 2.0))));
}

TEST(SteadiestStep, OfASteadyRunIsNotNeeded) {
  const auto cycle = steadiest_cycle(steady_run({}, 3.0, 3.0));
  ASSERT_TRUE(cycle);
  EXPECT_FALSE(cycle->is_half);
}

}  // namespace
}  // namespace mien::motion
