#include "motion/examples/make_example.h"

#include <gtest/gtest.h>

#include "motion/gait/loop.h"
#include "motion/math/rotation.h"
#include "motion/refusal.h"
#include "motion/skeleton/floor.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

constexpr std::array<double, 7> known_keytimes = {0.0, 0.1, 0.3, 0.5, 0.6, 0.8, 1.0};

void expect_known_walk(const Example& example) {
  EXPECT_TRUE(example.clip.loops);
  ASSERT_EQ(example.keytimes.size(), 7u);
  for (size_t k = 0; k < 7; ++k) EXPECT_NEAR(example.keytimes[k], known_keytimes[k], 0.03) << k;
  EXPECT_DOUBLE_EQ(example.keytimes.back(), example.clip.duration_seconds());
  EXPECT_NEAR(example.clip.cycle_displacement.z(), 1.2, 0.02);
  EXPECT_DOUBLE_EQ(example.clip.cycle_displacement.x(), 0.0);
  EXPECT_NEAR(example.clip.poses.front().root_position.z(), 0.0, 1e-12);
  EXPECT_NEAR(floor_height(example.clip), 0.0, 1e-9);
  // It starts with the left foot striking: far before the body.
  const auto start = world_positions(example.clip.body, example.clip.poses.front());
  EXPECT_GT(start[LeftAnkle].z() - start[RightAnkle].z(), 0.5);
}

TEST(Example, OfALongTakeIsOneSteadyCycleStraightened) {
  const PreparedExample prepared = prepare_example(synthetic_clip(long_take()));
  expect_known_walk(prepared.example);
  ASSERT_TRUE(prepared.cycle);
  EXPECT_GE(prepared.cycle->start_frame, 290);
  EXPECT_LE(prepared.cycle->end_frame, 800);
  EXPECT_EQ(prepared.example.clip.name, "synthetic");
}

TEST(Example, CutAtRightStrikesStillStartsWithTheLeft) {
  SyntheticWalk walk = steady_walk(1.2, 1.4);
  for (double& distance : walk.distance) distance += 0.45;
  expect_known_walk(make_example(synthetic_clip(walk)));
}

TEST(Example, OfOneStepHasItsMirrorImageForTheOther) {
  SyntheticWalk walk = steady_walk(1.2, 0.85);
  for (double& distance : walk.distance) distance += 0.42;
  const PreparedExample prepared = prepare_example(synthetic_clip(walk));
  ASSERT_TRUE(prepared.cycle && prepared.cycle->is_half);
  EXPECT_EQ(prepared.example.clip.frame_count(),
            2 * (prepared.cycle->end_frame - prepared.cycle->start_frame));
  EXPECT_NEAR(prepared.example.clip.cycle_displacement.z(), 1.2, 0.05);
}

TEST(Example, OfGivenFramesIsCutThere) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 4.0));
  ExampleOptions options;
  options.frames = FrameRange{120, 220};
  const PreparedExample prepared = prepare_example(clip, options);
  EXPECT_EQ(prepared.cycle->start_frame, 120);
  EXPECT_EQ(prepared.cycle->end_frame, 220);
  expect_known_walk(prepared.example);
}

TEST(Example, OfALoopIsThatLoopBegunAtItsLeftStrike) {
  const Clip loop = closed_loop(synthetic_clip(steady_walk(1.2, 4.0)), 130, 230);
  const Example example = make_example(loop);
  expect_known_walk(example);
  EXPECT_EQ(example.clip.frame_count(), 100);
}

TEST(Example, RefusesFramesThatHoldNoCycle) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 4.0));
  ExampleOptions options;
  options.frames = FrameRange{380, 420};
  EXPECT_NE(refusal_of([&] {
              make_example(clip, options);
            }).find("synthetic: frames 380–420 are not within the clip of 401 frames"),
            std::string::npos);
  options.frames = FrameRange{100, 130};
  EXPECT_NE(refusal_of([&] { make_example(clip, options); }).find("do not contain a gait cycle"),
            std::string::npos);
  Clip pose = clip;
  pose.poses.resize(1);
  EXPECT_NE(refusal_of([&] { make_example(pose); }).find("fewer than two frames"),
            std::string::npos);
}

/// A right hand that goes up and down `strokes` times, pausing between.
Clip waving(int strokes) {
  SyntheticWalk still;
  still.distance.assign(static_cast<size_t>(100 * strokes + 1), 0.3);
  Clip clip = synthetic_clip(still);
  for (size_t t = 0; t < clip.poses.size(); ++t) {
    const double stroke = static_cast<double>(t) / 100.0;
    const double angle = 0.8 * (1 - std::cos(pi * stroke));
    clip.poses[t].rotations[RightShoulder] = about(Vec3::UnitZ(), 1.4 - angle);
  }
  return clip;
}

TEST(Example, OfAPerformanceHasItsPausesForKeytimes) {
  const Example example = make_example(waving(4));
  EXPECT_FALSE(example.clip.loops);
  ASSERT_EQ(example.keytimes.size(), 5u);
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(example.keytimes[k], k, 0.06);
  ExampleOptions whole;
  whole.cycle = CycleChoice::whole;
  EXPECT_FALSE(make_example(synthetic_clip(steady_walk(1.2, 4.0)), whole).clip.loops);
}

TEST(Example, OfStartPeakAndEndHasItsPeakWhereTheHandIsFarthest) {
  ExampleOptions options;
  options.cycle = CycleChoice::start_peak_end;
  const Example example = make_example(waving(2), options);
  EXPECT_FALSE(example.clip.loops);
  ASSERT_EQ(example.keytimes.size(), 3u);
  EXPECT_EQ(example.keytimes[0], 0.0);
  EXPECT_NEAR(example.keytimes[1], 1.0, 0.02);
  EXPECT_DOUBLE_EQ(example.keytimes[2], example.clip.duration_seconds());
  Clip still = waving(1);
  for (Pose& pose : still.poses) pose = still.poses.front();
  EXPECT_NE(
      refusal_of([&] { make_example(still, options); }).find("do not move, so there are no peaks"),
      std::string::npos);
}

TEST(Example, OfKeytimesByHandIsCutToThem) {
  ExampleOptions options;
  options.keytimes = {1.0, 1.52, 2.203, 3.0};
  const Clip take = waving(4);
  const Example example = make_example(take, options);
  EXPECT_EQ(example.clip.frame_count(), 201);
  ASSERT_EQ(example.keytimes.size(), 4u);
  EXPECT_EQ(example.keytimes[0], 0.0);
  EXPECT_NEAR(example.keytimes[1], 0.52, 1e-12);
  EXPECT_NEAR(example.keytimes[2], 1.203, 1e-12);
  EXPECT_DOUBLE_EQ(example.keytimes[3], 2.0);
  // The frames are the take's.
  EXPECT_LT(angle_between(example.clip.poses[52].rotations[RightShoulder],
                          take.poses[152].rotations[RightShoulder]),
            1e-12);
}

TEST(Example, RefusesKeytimesThatAMotionCannotHave) {
  const auto refusal = [](const std::vector<double>& keytimes) {
    ExampleOptions options;
    options.keytimes = keytimes;
    return refusal_of([&] { make_example(waving(2), options); });
  };
  EXPECT_NE(refusal({0.5}).find("are fewer than two"), std::string::npos);
  EXPECT_NE(refusal({0.5, 2.5}).find("are not within the motion"), std::string::npos);
  EXPECT_NE(refusal({-0.1, 1.0}).find("are not within the motion"), std::string::npos);
  EXPECT_NE(refusal({0.5, 0.505, 1.0}).find("are less than one frame apart"), std::string::npos);
  EXPECT_NE(refusal({1.0, 0.5}).find("are less than one frame apart"), std::string::npos);
}

TEST(EvenKeytimes, KeepTheDeepestPauses) {
  std::vector<Example> examples = {make_example(waving(4)), make_example(waving(2))};
  ASSERT_EQ(examples[0].keytimes.size(), 5u);
  ASSERT_EQ(examples[1].keytimes.size(), 3u);
  even_keytimes(examples);
  ASSERT_EQ(examples[0].keytimes.size(), 3u);
  EXPECT_TRUE(std::is_sorted(examples[0].keytimes.begin(), examples[0].keytimes.end()));
  EXPECT_DOUBLE_EQ(examples[0].keytimes.back(), examples[0].clip.duration_seconds());
  EXPECT_NEAR(examples[1].keytimes[1], 1.0, 0.06);
}

}  // namespace
}  // namespace mien::motion
