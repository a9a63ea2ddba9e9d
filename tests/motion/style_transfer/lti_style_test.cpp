#include "motion/style_transfer/lti_style.h"

#include <gtest/gtest.h>

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

TEST(LtiStyle, RefusesTooManyStates) {
  const Clip sad = builtin_walk("sad").clip;
  EXPECT_NE(refusal_of([&] { fit_lti_style(sad, sad, {.order = 11}); }).find("give 1 to 10"),
            std::string::npos);
  EXPECT_NE(refusal_of([&] { fit_lti_style(sad, reach(1.0, 0.8)); }).find("only one is cyclic"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::motion
