#include "motion/style_transfer/style_components.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/math/fast_ica.h"
#include "motion/refusal.h"

#include "reach.h"
#include "walk_pair.h"

namespace mien::motion {
namespace {

using namespace mien::test;

/// A sine, a saw tooth and a square wave of different periods: mean 0, unit variance.
Eigen::MatrixXd three_sources(int samples) {
  Eigen::MatrixXd sources(samples, 3);
  for (int i = 0; i < samples; ++i) {
    sources(i, 0) = std::sin(2.0 * pi * i / 25.0);
    sources(i, 1) = std::fmod(i / 40.0, 1.0);
    sources(i, 2) = (i / 16) % 2 == 0 ? 1.0 : -1.0;
  }
  sources.rowwise() -= sources.colwise().mean().eval();
  for (int c = 0; c < 3; ++c) sources.col(c) *= std::sqrt(samples) / sources.col(c).norm();
  return sources;
}

TEST(FastIca, FindsTheSourcesOfARotatedMixture) {
  const Eigen::MatrixXd sources = three_sources(4000);
  const Mat3 turn = Eigen::AngleAxisd(0.9, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  for (const std::uint64_t seed : {0, 1, 2, 3}) {
    const FastIca found = fast_ica(sources * turn, seed);
    EXPECT_TRUE(found.converged);
    const Eigen::MatrixXd match =
        (sources.transpose() * sources * turn * found.rotation / 4000.0).cwiseAbs();
    for (int c = 0; c < 3; ++c) EXPECT_GT(match.col(c).maxCoeff(), 0.99) << seed;
  }
}

TEST(StyleComponents, UnmixToTheMotions) {
  const Clip neutral = builtin_walk("normal").clip;
  for (const int count : {1, 6, 30}) {
    const StyleComponents parts =
        style_components(neutral, builtin_walk("sad").clip, {.components = count});
    const Eigen::MatrixXd again =
        ((parts.neutral_series * parts.mixing + parts.neutral_residual).rowwise() + parts.mean);
    EXPECT_LT((again - parts.neutral.values).cwiseAbs().maxCoeff(), 1e-9) << count;
  }
}

TEST(StyleComponents, AreWhiteSortedAndAddUp) {
  const StyleComponents parts =
      style_components(builtin_walk("normal").clip, builtin_walk("sad").clip);
  EXPECT_TRUE(parts.converged);
  const Eigen::Index count = parts.energy.size();
  ASSERT_EQ(count, 6);
  const Eigen::MatrixXd covariance = (parts.neutral_series.transpose() * parts.neutral_series +
                                      parts.styled_series.transpose() * parts.styled_series) /
                                     (2.0 * static_cast<double>(parts.neutral_series.rows()));
  EXPECT_LT((covariance - Eigen::MatrixXd::Identity(count, count)).cwiseAbs().maxCoeff(), 1e-9);
  for (Eigen::Index k = 0; k < count; ++k) {
    if (k > 0) {
      EXPECT_LE(parts.energy[k], parts.energy[k - 1]);
    }
    EXPECT_NEAR(parts.joint_shares.row(k).sum(), 1.0, 1e-12);
  }
}

TEST(StyleComponents, OfTheSameSeedAreTheSame) {
  const Clip neutral = builtin_walk("normal").clip;
  const Clip sad = builtin_walk("sad").clip;
  const StyleComponents once = style_components(neutral, sad, {.seed = 5});
  const StyleComponents again = style_components(neutral, sad, {.seed = 5});
  EXPECT_EQ(once.mixing, again.mixing);
  EXPECT_EQ(once.neutral_series, again.neutral_series);
}

TEST(StyleComponents, AllSwappedAreTheStyledMotionInTheNeutralTime) {
  const Clip neutral = builtin_walk("normal").clip;
  const Clip sad = builtin_walk("sad").clip;
  const StyleComponentOptions all{.components = 99, .most_different = 99};
  const Clip result = restyled(neutral, style_components(neutral, sad, all), all);
  EXPECT_EQ(result.frame_count(), neutral.frame_count());
  const auto means = mean_rotations(result);
  const auto wanted = mean_rotations(sad);
  for (int j = 0; j < body_joint_count; ++j) {
    EXPECT_LT(angle_between(means[j], wanted[j]), 0.05) << j;
  }
}

TEST(StyleComponents, OfNoAmountAreTheMotion) {
  const Clip motion = builtin_walk("happy").clip;
  EXPECT_LT(
      largest_difference(
          restyled(motion, style_components(builtin_walk("normal").clip, builtin_walk("sad").clip),
                   {.amount = 0.0}),
          motion),
      1e-9);
}

TEST(StyleComponents, OfAMotionToItselfChangeNothing) {
  const Clip sad = builtin_walk("sad").clip;
  const Clip motion = builtin_walk("happy").clip;
  EXPECT_LT(largest_difference(restyled(motion, style_components(sad, sad)), motion), 1e-9);
}

TEST(StyleComponents, SwappedMoreAreBentMore) {
  const Clip neutral = builtin_walk("normal").clip;
  const StyleComponentOptions options;
  const StyleComponents parts = style_components(neutral, builtin_walk("sad").clip, options);
  double bent = -1.0;
  for (const double amount : {0.0, 0.5, 1.0, 1.5}) {
    const auto means = mean_rotations(restyled(neutral, parts, {.amount = amount}));
    EXPECT_GT(log(means[Neck] * means[Head]).x(), bent) << amount;
    bent = log(means[Neck] * means[Head]).x();
  }
}

TEST(StyleComponents, RefuseWhatIsNotThere) {
  const Clip sad = builtin_walk("sad").clip;
  const Clip normal = builtin_walk("normal").clip;
  EXPECT_NE(refusal_of([&] {
              restyled(normal, style_components(normal, sad), {.swapped = {6}});
            }).find("no style component 6"),
            std::string::npos);
  EXPECT_NE(refusal_of([&] { style_components(sad, reach(1.0, 0.8)); }).find("only one is cyclic"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::motion
