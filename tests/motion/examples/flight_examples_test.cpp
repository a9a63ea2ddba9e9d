#include "motion/examples/flight_examples.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "motion/examples/make_example.h"
#include "motion/examples/settled_feet.h"
#include "motion/formats/motion_file.h"
#include "motion/gait/foot_lock.h"
#include "motion/gait/gait_plants.h"
#include "motion/interpolation/blend.h"
#include "motion/measures/distance/distance.h"
#include "motion/rig/body_mapping.h"
#include "motion/sole_heights.h"
#include "motion/synthetic_run.h"

#include "real_data.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Example run_of(double stance, double speed, double lean) {
  SyntheticRun run;
  run.stance = stance;
  run.lean = lean;
  return make_example(steady_run(run, speed, 3.0));
}

/// The share of the frames in which both soles are above a height.
double flown_share(const Clip& clip, double metres) {
  const std::vector<double> heights = lowest_sole_heights(clip);
  const auto flown = std::count_if(heights.begin(), heights.end(),
                                   [metres](double height) { return height > metres; });
  return static_cast<double>(flown) / static_cast<double>(heights.size());
}

double lowest_sole(const Clip& clip) {
  const std::vector<double> heights = lowest_sole_heights(clip);
  return *std::min_element(heights.begin(), heights.end());
}

Example blended(const ExampleSet& set, double share_of_second, double rate = 100.0) {
  return blend(set, Eigen::Vector2d(1.0 - share_of_second, share_of_second),
               {.frames_per_second = rate});
}

TEST(FlightExamples, GiveARunBlendedFromRunsTheMeanFlight) {
  ExampleSet set{"runs", {run_of(0.26, 3.2, 0.1), run_of(0.40, 2.4, 0.4)}};
  ASSERT_TRUE(use_flight_keytimes(set.examples));
  const double first = flown_share(set.examples[0].clip, 0.01);
  const double second = flown_share(set.examples[1].clip, 0.01);
  ASSERT_GT(first, second + 0.1);
  for (const double share : {0.25, 0.5, 0.75}) {
    const Example run = blended(set, share);
    EXPECT_NEAR(flown_share(run.clip, 0.01), (1.0 - share) * first + share * second, 0.06) << share;
    EXPECT_GT(lowest_sole(run.clip), -0.015) << share;
    const auto flight = run.keytimes[3] - run.keytimes[2];
    EXPECT_GT(flight, set.examples[1].keytimes[3] - set.examples[1].keytimes[2]);
    EXPECT_LT(flight, set.examples[0].keytimes[3] - set.examples[0].keytimes[2]);
  }
}

TEST(FlightExamples, AreNotMadeOfRunsAndWalks) {
  std::vector<Example> examples = {run_of(0.3, 3.0, 0.0),
                                   make_example(synthetic_clip(steady_walk(1.2, 4.0)))};
  const std::vector<double> before = examples[0].keytimes;
  examples[0].name = "run";
  EXPECT_FALSE(use_flight_keytimes(examples));
  EXPECT_EQ(examples[0].keytimes, before);
  EXPECT_EQ(running_examples(examples), std::vector<std::string>{"run"});
}

TEST(FlightExamples, MatchTwoRunsAndARunWithAWalk) {
  Example run = run_of(0.3, 3.0, 0.0);
  const std::vector<double> walking = run.keytimes;
  Example other = run_of(0.36, 2.6, 0.2);
  match_keytimes(run, other);
  EXPECT_NE(run.keytimes, walking);
  EXPECT_GT(run.keytimes[3] - run.keytimes[2], 0.05);  // a flight
  Example walk = make_example(synthetic_clip(steady_walk(1.2, 4.0)));
  const std::vector<double> of_walk = walk.keytimes;
  match_keytimes(run, walk);
  EXPECT_EQ(walk.keytimes, of_walk);
  for (size_t k = 0; k < 7; ++k) EXPECT_NEAR(run.keytimes[k], walking[k], 0.02) << k;
}

/// Two captured takes of one actor that start to run, and the moments, seconds, at which the same
/// happens in both: start, toe offs, strikes, end.
struct RunTakes {
  std::string actor;
  std::vector<double> of_slow;
  std::vector<double> of_fast;
  double most;  ///< D, metres
};

class RealRuns : public testing::TestWithParam<RunTakes> {
 protected:
  void SetUp() override {
    if (!real_data()) {
      GTEST_SKIP() << "no motion capture here: set MIEN_DATA to the folder that has it";
    }
    const auto folder = *real_data() / "mocap" / "aalto-two-actors";
    const std::string pair = GetParam().actor + "_run_fast_" + GetParam().actor + "_run_slow_";
    const std::vector<Recording> files = {read_motion(folder / (pair + "000_100.bvh")),
                                          read_motion(folder / (pair + "100_000.bvh"))};
    const BodyMapping mapping = recognise(files);
    for (const Recording& file : files) takes.push_back(to_body(file, mapping));
  }

  std::vector<Clip> takes;  ///< slow, fast
};

TEST_P(RealRuns, BlendIntoTheCycleOfTheirBlendedTakes) {
  ExampleSet cycles{"cycles", {make_example(takes[0]), make_example(takes[1])}};
  ASSERT_TRUE(use_flight_keytimes(cycles.examples));
  cycles = with_settled_feet(cycles);
  const ExampleSet whole{"takes",
                         {make_example(takes[0], {.keytimes = GetParam().of_slow}),
                          make_example(takes[1], {.keytimes = GetParam().of_fast})}};
  for (const double share : {0.25, 0.5, 0.75}) {
    Example run = blended(cycles, share, 30.0);
    run.clip = foot_locked(run.clip, gait_plants(run.clip));
    std::vector<Example> expected = {make_example(blended(whole, share).clip)};
    ASSERT_TRUE(use_flight_keytimes(expected)) << share;
    expected[0].clip = with_settled_feet(expected[0].clip);
    EXPECT_LT(distance(expected[0], run).mean, GetParam().most) << share;
    EXPECT_GT(lowest_sole(run.clip), -0.025) << share;
  }
}

TEST_P(RealRuns, AreCutToStepsOfRunning) {
  for (const Clip& take : takes) {
    const PreparedExample run = prepare_example(take);
    ASSERT_TRUE(run.cycle);
    // The first step, from standing, took the fast run of one actor 1 s a stride.
    EXPECT_LT(run.example.keytimes.back(), 0.97) << take.name;
    EXPECT_GT(run.example.keytimes.back(), 0.6) << take.name;
    EXPECT_GT(lowest_sole(run.example.clip), -0.025) << take.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Both, RealRuns,
                         testing::Values(RunTakes{"k",
                                                  {0, 0.52, 0.87, 1.385, 1.465, 1.79, 1.84},
                                                  {0, 0.67, 1.12, 1.415, 1.535, 1.745, 1.85},
                                                  0.02},
                                         RunTakes{"t",
                                                  {0, 0.82, 1.19, 1.665, 1.71, 2.085, 2.13, 2.57},
                                                  {0, 0.71, 1.01, 1.275, 1.415, 1.645, 1.765, 1.97},
                                                  0.03}),
                         [](const auto& takes) { return takes.param.actor; });

}  // namespace
}  // namespace mien::motion
