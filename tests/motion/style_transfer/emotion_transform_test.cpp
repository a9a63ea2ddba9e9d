#include "motion/style_transfer/emotion_transform.h"

#include <gtest/gtest.h>

#include "motion/refusal.h"

#include "reach.h"
#include "walk_pair.h"

namespace mien::motion {
namespace {

using namespace mien::test;

constexpr double swing = 0.8;  // radians that the shoulder swings

TEST(BasicPeriods, EndWhereTheHandIsBack) {
  EXPECT_EQ(busiest_effector(reach(1.0, swing)), RightWrist);
  EXPECT_EQ(basic_periods(reach(1.0, swing), RightWrist), (std::vector<int>{0, 60}));
  EXPECT_EQ(basic_periods(reach(1.0, swing, 3), RightWrist), (std::vector<int>{0, 60, 120, 180}));
}

TEST(BasicPeriods, OfALoopIsOne) {
  const Clip walk = builtin_walk("normal").clip;
  EXPECT_EQ(basic_periods(walk, busiest_effector(walk)), (std::vector<int>{0, walk.frame_count()}));
}

TEST(EmotionTransform, RecoversHowMuchFasterAndWiderAReachIs) {
  for (const double slower : {0.6, 1.0, 1.5}) {
    for (const double wider : {0.5, 1.3}) {
      const Clip neutral = reach(1.0, swing);
      const Clip emotional = reach(slower, wider * swing);
      const EmotionTransform transform = emotion_transform(neutral, emotional);
      ASSERT_EQ(transform.periods.size(), 1u);
      EXPECT_NEAR(transform.periods[0].duration_ratio, slower, 1e-9);
      EXPECT_NEAR(transform.periods[0].amplitude_ratios[amplitude_class(RightShoulder)], wider,
                  0.02 * wider);
      EXPECT_NEAR(transform.periods[0].amplitude_ratios[amplitude_class(RightElbow)], wider,
                  0.02 * wider);
      EXPECT_LT(largest_difference(emotion_transformed(neutral, neutral, emotional), emotional),
                0.03)
          << slower << " " << wider;
    }
  }
}

TEST(EmotionTransform, RecoversAnUnevenPace) {
  const auto pace = [](double t) { return t + 0.1 * std::sin(2.0 * pi * t); };
  const Clip neutral = reach(1.0, swing);
  const Clip emotional = reach(1.0, swing, 1, pace);
  const Clip result = emotion_transformed(neutral, neutral, emotional);
  EXPECT_GT(largest_difference(neutral, emotional), 0.2);
  EXPECT_LT(largest_difference(result, emotional), 0.05);
}

TEST(EmotionTransform, OfOneReachIsGivenToSeveral) {
  const Clip three = reach(1.0, swing, 3);
  const Clip result = emotion_transformed(three, reach(1.0, swing), reach(1.5, 1.3 * swing));
  EXPECT_LT(largest_difference(result, reach(1.5, 1.3 * swing, 3)), 0.06);
}

TEST(EmotionTransform, OfNoAmountIsTheMotion) {
  for (const char* name : {"happy", "tired"}) {
    const Clip motion = builtin_walk(name).clip;
    EXPECT_LT(largest_difference(emotion_transformed(motion, builtin_walk("normal").clip,
                                                     builtin_walk("sad").clip, {.amount = 0.0}),
                                 motion),
              1e-9);
  }
}

TEST(EmotionTransform, OfAMotionToItselfChangesNothing) {
  const Clip sad = builtin_walk("sad").clip;
  const Clip motion = builtin_walk("happy").clip;
  EXPECT_LT(largest_difference(emotion_transformed(motion, sad, sad, {.amount = 2.0}), motion),
            1e-9);
}

TEST(EmotionTransform, TakesOverTempoAndStepButNoPosture) {
  const Clip neutral = builtin_walk("normal").clip;
  const Clip sad = builtin_walk("sad").clip;
  const Clip result = emotion_transformed(neutral, neutral, sad);
  EXPECT_EQ(result.frame_count(), sad.frame_count());
  EXPECT_NEAR(result.cycle_displacement.norm(), sad.cycle_displacement.norm(), 1e-9);
  const auto means = mean_rotations(result);
  const auto before = mean_rotations(neutral);
  for (int j = 0; j < body_joint_count; ++j) {
    EXPECT_LT(angle_between(means[j], before[j]), 0.06) << j;
  }
  EXPECT_LT(largest_pop(result), 1.5 * std::max(largest_pop(neutral), largest_pop(sad)));
}

TEST(EmotionTransform, ExaggeratesMonotonically) {
  const Clip neutral = builtin_walk("normal").clip;
  const Clip sad = builtin_walk("sad").clip;
  double way = HUGE_VAL;
  int frames = 0;
  for (const double amount : {0.0, 0.5, 1.0, 1.5, 2.0}) {
    const Clip result = emotion_transformed(neutral, neutral, sad, {.amount = amount});
    EXPECT_LT(result.cycle_displacement.norm(), way);
    EXPECT_GT(result.frame_count(), frames);
    way = result.cycle_displacement.norm();
    frames = result.frame_count();
  }
}

TEST(EmotionTransform, RefusesALoopBesideAPerformance) {
  EXPECT_NE(refusal_of([] {
              emotion_transform(builtin_walk("sad").clip, reach(1.0, swing));
            }).find("only one is cyclic"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::motion
