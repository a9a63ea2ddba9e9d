#include "motion/style_transfer/lti_style.h"

#include <random>

#include <gtest/gtest.h>

#include "motion/random_motion.h"
#include "motion/refusal.h"

#include "reach.h"
#include "walk_pair.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(LtiStyle, ReproducesTheStyledWalkItLearntFrom) {
  const Clip neutral = builtin_walk("normal").clip;
  for (const char* name : {"sad", "angry"}) {
    const Clip styled = builtin_walk(name).clip;
    const LtiStyleModel model = fit_lti_style(neutral, styled);
    EXPECT_LE(model.system.order(), 10);
    EXPECT_TRUE(model.correspondence.converged);
    EXPECT_LT(model.error_radians, 0.02) << name;
    const Clip result = translated(neutral, model);
    EXPECT_EQ(result.frame_count(), styled.frame_count());
    EXPECT_LT(largest_difference(result, styled), 0.35) << name;
    EXPECT_LT(largest_pop(result), 1.5 * std::max(largest_pop(neutral), largest_pop(styled)));
  }
}

TEST(LtiStyle, OfNoAmountIsTheMotion) {
  const Clip motion = builtin_walk("happy").clip;
  EXPECT_LT(
      largest_difference(
          translated(motion, fit_lti_style(builtin_walk("normal").clip, builtin_walk("sad").clip),
                     {.amount = 0.0}),
          motion),
      1e-9);
}

TEST(LtiStyle, OfAMotionToItselfChangesNothing) {
  const Clip sad = builtin_walk("sad").clip;
  const Clip motion = builtin_walk("happy").clip;
  EXPECT_LT(largest_difference(translated(motion, fit_lti_style(sad, sad)), motion), 1e-9);
}

TEST(LtiStyle, BendsAnotherWalkLikeTheSadOne) {
  const LtiStyleModel model = fit_lti_style(builtin_walk("normal").clip, builtin_walk("sad").clip);
  const Clip brisk = builtin_walk("brisk").clip;
  double bent = -1.0;
  for (const double amount : {0.0, 0.5, 1.0, 1.5}) {
    const Clip result = translated(brisk, model, {.amount = amount});
    const auto means = mean_rotations(result);
    EXPECT_GT(log(means[Neck] * means[Head]).x(), bent) << amount;
    bent = log(means[Neck] * means[Head]).x();
    EXPECT_LT(largest_pop(result), 2.0 * largest_pop(brisk) + 0.05) << amount;
  }
}

TEST(LtiStyle, TranslatesAPerformance) {
  const Clip neutral = reach(1.0, 0.8);
  const Clip styled = reach(1.5, 1.2);
  const Clip result = translated(neutral, fit_lti_style(neutral, styled));
  EXPECT_EQ(result.frame_count(), styled.frame_count());
  EXPECT_LT(largest_difference(result, styled), 0.1);
}

double farthest(const Clip& clip) {
  double farthest = 0.0;
  for (const Pose& pose : clip.poses) farthest = std::max(farthest, pose.root_position.norm());
  return farthest;
}

TEST(LtiStyle, IsBoundedForAnyMotionAndStrength) {
  std::mt19937_64 random(5);
  for (const char* style : {"sad", "angry", "happy"}) {
    const LtiStyleModel model =
        fit_lti_style(builtin_walk("normal").clip, builtin_walk(style).clip);
    for (const int frames : {12, 33, 60, 240}) {
      Clip motion = random_loop(random, frames, 30.0, frames == 33 ? 1.5 : 0.3).clip;
      for (const bool loops : {true, false}) {
        motion.loops = loops;
        for (const double amount : {0.0, 0.7, 1.0, 2.0, 3.0}) {
          const Clip result = translated(motion, model, {.amount = amount});
          EXPECT_LE(result.frame_count(), 3.1 * frames) << style << frames << amount;
          EXPECT_GE(result.frame_count(), std::min(4, frames / 4)) << style << frames << amount;
          EXPECT_LT(farthest(result), farthest(motion) + 3.0) << style << frames << amount;
        }
      }
    }
  }
}

TEST(LtiStyle, LeavesMotionsUnlikeTheNeutralOneAsTheyAre) {
  const LtiStyleModel model = fit_lti_style(builtin_walk("normal").clip, builtin_walk("sad").clip);
  std::mt19937_64 random(6);
  const Clip wild = random_loop(random, 40, 30.0, 2.5).clip;
  const LtiTranslation result = translation(wild, model);
  EXPECT_EQ(result.deviating_share, 1.0);
  EXPECT_EQ(result.clip.frame_count(), wild.frame_count());
  EXPECT_LT(largest_difference(result.clip, wild), 0.1);
  EXPECT_EQ(translation(builtin_walk("normal").clip, model).deviating_share, 0.0);
}

TEST(LtiStyle, SaysWhereEachFrameComesFrom) {
  const Clip motion = builtin_walk("normal").clip;
  const LtiTranslation result =
      translation(motion, fit_lti_style(motion, builtin_walk("sad").clip));
  ASSERT_EQ(result.source_frames.size(), result.clip.poses.size());
  EXPECT_NEAR(result.source_frames.front(), 0.0, 1e-9);
  for (size_t f = 1; f < result.source_frames.size(); ++f) {
    EXPECT_GT(result.source_frames[f], result.source_frames[f - 1]);
  }
  EXPECT_LT(result.source_frames.back(), motion.frame_count());
}

TEST(LtiStyle, RefusesTooManyStates) {
  const Clip sad = builtin_walk("sad").clip;
  EXPECT_NE(refusal_of([&] { fit_lti_style(sad, sad, {.order = 11}); }).find("give 1 to 10"),
            std::string::npos);
  EXPECT_NE(refusal_of([&] { fit_lti_style(sad, reach(1.0, 0.8)); }).find("only one is cyclic"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::motion
