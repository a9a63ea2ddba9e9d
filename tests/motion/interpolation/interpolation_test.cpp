#include "motion/interpolation/interpolation.h"

#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "motion/measures/distance/distance.h"
#include "motion/random_motion.h"
#include "motion/random_places.h"
#include "motion/refusal.h"

namespace mien::motion {
namespace {

using test::random_places;
using Method = InterpolationMethod;

Eigen::RowVectorXd random_wish(std::mt19937_64& random, Eigen::Index parameters) {
  return random_places(random, 1, parameters).row(0);
}

/// GoogleTest takes no hyphens.
std::string test_name(Method method) {
  std::string name(name_of(method));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class EveryMethod : public testing::TestWithParam<Method> {
 protected:
  InterpolationOptions options() const {
    InterpolationOptions chosen;
    chosen.method = GetParam();
    chosen.nearest.seed = 5;
    return chosen;
  }
  Interpolator fitted(const ExampleSet& set, const Eigen::MatrixXd& places) const {
    return fit_interpolator(set, places, options());
  }
  /// Of which the weights are shares, not a by-product.
  bool blends() const { return GetParam() != Method::pca; }
  /// Which go through the examples, at least with a grid line at each.
  bool is_exact() const {
    return blends() && GetParam() != Method::grid && GetParam() != Method::incremental;
  }
  bool is_continuous() const { return GetParam() != Method::incremental; }
};

INSTANTIATE_TEST_SUITE_P(Of, EveryMethod,
                         testing::Values(Method::cardinal, Method::nearest,
                                         Method::inverse_distance, Method::grid, Method::kriging,
                                         Method::pca, Method::incremental),
                         [](const auto& each) { return test_name(each.param); });

TEST_P(EveryMethod, GivesSharesThatSumToOne) {
  std::mt19937_64 random(21);
  const ExampleSet set = test::random_loops(random, 9);
  for (Eigen::Index parameters = 1; parameters <= 4; ++parameters) {
    const Interpolator fitted_one = fitted(set, random_places(random, 9, parameters));
    for (int trial = 0; trial < 60; ++trial) {
      const Eigen::RowVectorXd wish = 3.0 * random_wish(random, parameters).array() - 1.0;
      const Eigen::VectorXd weights = weights_at(fitted_one, wish).weights;
      ASSERT_EQ(weights.size(), 9);
      EXPECT_NEAR(weights.sum(), 1.0, 1e-9);
      if (blends()) {
        EXPECT_GE(weights.minCoeff(), 0.0);
      }
    }
  }
}

TEST_P(EveryMethod, GivesAnExampleAllTheWeightAtItsOwnParameters) {
  if (!is_exact()) GTEST_SKIP() << "approximates by design";
  std::mt19937_64 random(22);
  for (Eigen::Index count : {1, 2, 3, 12}) {
    const ExampleSet set = test::random_loops(random, static_cast<int>(count));
    for (Eigen::Index parameters = 1; parameters <= 5; ++parameters) {
      const Eigen::MatrixXd places = random_places(random, count, parameters);
      const Interpolator fitted_one = fitted(set, places);
      for (Eigen::Index k = 0; k < count; ++k) {
        const Eigen::VectorXd weights = weights_at(fitted_one, places.row(k)).weights;
        EXPECT_LT((weights - Eigen::VectorXd::Unit(count, k)).cwiseAbs().maxCoeff(), 1e-6)
            << count << " examples, " << parameters << " parameters";
      }
    }
  }
}

TEST_P(EveryMethod, IsContinuous) {
  if (!is_continuous()) GTEST_SKIP() << "goes in steps by design";
  std::mt19937_64 random(23);
  const ExampleSet set = test::random_loops(random, 10);
  const Interpolator fitted_one = fitted(set, random_places(random, 10, 2));
  // Halving a step must halve what it does; a jump would stay.
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::RowVectorXd wish = random_wish(random, 2);
    Eigen::RowVectorXd from = wish;
    Eigen::RowVectorXd to = random_wish(random, 2);
    for (int halving = 0; halving < 30; ++halving) {
      const Eigen::RowVectorXd middle = 0.5 * (from + to);
      const Eigen::VectorXd at_middle = weights_at(fitted_one, middle).weights;
      const double first = (at_middle - weights_at(fitted_one, from).weights).norm();
      const double second = (weights_at(fitted_one, to).weights - at_middle).norm();
      (first > second ? to : from) = middle;  // towards the larger change
    }
    const double left =
        (weights_at(fitted_one, from).weights - weights_at(fitted_one, to).weights).norm();
    EXPECT_LT(left, 1e-4) << from;
  }
}

TEST_P(EveryMethod, DoesNotCareInWhichOrderExamplesCome) {
  std::mt19937_64 random(24);
  const ExampleSet set = test::random_loops(random, 8);
  const Eigen::MatrixXd places = random_places(random, 8, 3);
  std::vector<Eigen::Index> order(8);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  ExampleSet shuffled = set;
  for (size_t i = 0; i < 8; ++i) shuffled.examples[i] = set.examples[static_cast<size_t>(order[i])];
  const Interpolator one = fitted(set, places);
  const Interpolator other = fitted(shuffled, places(order, Eigen::all));
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::RowVectorXd wish = random_wish(random, 3);
    const Eigen::VectorXd expected = weights_at(one, wish).weights(order);
    EXPECT_LT((weights_at(other, wish).weights - expected).cwiseAbs().maxCoeff(), 1e-7);
  }
}

TEST_P(EveryMethod, MirrorsWhenAScaleIsReversed) {
  std::mt19937_64 random(25);
  const ExampleSet set = test::random_loops(random, 8);
  const Eigen::MatrixXd places = random_places(random, 8, 3);
  Eigen::MatrixXd reversed = places;
  reversed.col(1) = 1.0 - places.col(1).array();
  const Interpolator one = fitted(set, places);
  const Interpolator other = fitted(set, reversed);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::RowVectorXd wish = random_wish(random, 3);
    Eigen::RowVectorXd mirrored = wish;
    mirrored[1] = 1.0 - wish[1];
    EXPECT_LT(
        (weights_at(one, wish).weights - weights_at(other, mirrored).weights).cwiseAbs().maxCoeff(),
        1e-7);
  }
}

TEST_P(EveryMethod, SharesWeightBetweenExamplesAtOnePlaceAndTellsIt) {
  std::mt19937_64 random(26);
  const ExampleSet set = test::random_loops(random, 6);
  Eigen::MatrixXd places = random_places(random, 6, 2);
  places.row(4) = places.row(1);
  const Interpolator fitted_one = fitted(set, places);
  ASSERT_FALSE(fitted_one.remarks.empty());
  EXPECT_EQ(fitted_one.remarks.front().rfind("example-1 and example-4 have the same", 0), 0u)
      << fitted_one.remarks.front();
  if (!blends()) return;
  const Eigen::VectorXd weights = weights_at(fitted_one, places.row(1)).weights;
  EXPECT_NEAR(weights[1], weights[4], 1e-12);
  if (is_exact()) {
    EXPECT_NEAR(weights[1], 0.5, 1e-7);
  }
}

TEST_P(EveryMethod, TellsWhenParametersDependOnEachOther) {
  std::mt19937_64 random(27);
  const ExampleSet set = test::random_loops(random, 7);
  Eigen::MatrixXd places = random_places(random, 7, 2);
  places.col(1) = 0.8 - 0.5 * places.col(0).array();
  const Interpolator fitted_one = fit_interpolator(set, places, options(), {"quick", "large"});
  ASSERT_FALSE(fitted_one.remarks.empty());
  EXPECT_EQ(fitted_one.remarks.front().rfind("quick and large depend on each other", 0), 0u);
  EXPECT_NEAR(weights_at(fitted_one, random_wish(random, 2)).weights.sum(), 1.0, 1e-9);
}

TEST_P(EveryMethod, TakesMoreParametersThanExamplesAndTellsIt) {
  std::mt19937_64 random(28);
  const ExampleSet set = test::random_loops(random, 3);
  const Eigen::MatrixXd places = random_places(random, 3, 6);
  const Interpolator fitted_one = fitted(set, places);
  ASSERT_FALSE(fitted_one.remarks.empty());
  EXPECT_NE(fitted_one.remarks.front().find("more parameters than 3 different examples"),
            std::string::npos);
  EXPECT_NEAR(weights_at(fitted_one, random_wish(random, 6)).weights.sum(), 1.0, 1e-9);
}

TEST_P(EveryMethod, OfOneExampleIsThatExample) {
  std::mt19937_64 random(29);
  const ExampleSet set = test::random_loops(random, 1);
  const Interpolator fitted_one = fitted(set, Eigen::MatrixXd::Constant(1, 2, 0.4));
  ASSERT_FALSE(fitted_one.remarks.empty());
  const Eigen::VectorXd weights = weights_at(fitted_one, Eigen::RowVector2d(0.9, 0.1)).weights;
  ASSERT_EQ(weights.size(), 1);
  EXPECT_NEAR(weights[0], 1.0, 1e-12);
  const Example made = motion_at(fitted_one, set, Eigen::RowVector2d(0.9, 0.1));
  EXPECT_LT(distance(set.examples[0], made).mean, 2e-3);
}

TEST_P(EveryMethod, MakesTheSameMotionTwice) {
  std::mt19937_64 random(30);
  const ExampleSet set = test::random_loops(random, 6);
  const Eigen::MatrixXd places = random_places(random, 6, 2);
  const Eigen::RowVectorXd wish = random_wish(random, 2);
  const Example once = motion_at(fitted(set, places), set, wish);
  const Example again = motion_at(fitted(set, places), set, wish);
  ASSERT_EQ(once.clip.poses.size(), again.clip.poses.size());
  EXPECT_EQ(distance(once, again).sum, 0.0);
  EXPECT_EQ(once.keytimes, again.keytimes);
  EXPECT_EQ(once.keytimes.size(), set.examples[0].keytimes.size());
}

TEST(Interpolation, RefusesAGridOverTooManyParameters) {
  std::mt19937_64 random(31);
  const ExampleSet set = test::random_loops(random, 12);
  const std::string refusal = test::refusal_of(
      [&] { fit_interpolator(set, random_places(random, 12, 9), {.method = Method::grid}); });
  EXPECT_NE(refusal.find("a grid over 9 parameters has too many corners"), std::string::npos);
  EXPECT_NE(refusal.find("at most 8 parameters"), std::string::npos);
}

TEST(Interpolation, GivesKrigingAnExpectedErrorThatGrowsAwayFromTheExamples) {
  std::mt19937_64 random(32);
  const ExampleSet set = test::random_loops(random, 10);
  const Eigen::MatrixXd places = random_places(random, 10, 2);
  const Interpolator kriging = fit_interpolator(set, places, {.method = Method::kriging});
  for (Eigen::Index k = 0; k < 10; ++k) {
    EXPECT_LT(*weights_at(kriging, places.row(k)).expected_error_m, 1e-4);
  }
  const Eigen::RowVectorXd away = Eigen::RowVector2d(4.0, -3.0);
  EXPECT_GT(*weights_at(kriging, away).expected_error_m,
            *weights_at(kriging, places.colwise().mean()).expected_error_m);
  EXPECT_FALSE(weights_at(fit_interpolator(set, places, {}), away).expected_error_m);
}

TEST(Interpolation, LogsTheClicksOfWords) {
  std::mt19937_64 random(33);
  const ExampleSet set = test::random_loops(random, 10);
  const Eigen::MatrixXd places = random_places(random, 10, 2);
  const Interpolator words = fit_interpolator(set, places, {.method = Method::incremental});
  const InterpolatedWeights made = weights_at(words, places.row(3));
  ASSERT_FALSE(made.remarks.empty());
  EXPECT_EQ(made.remarks.front().rfind("clicks: ", 0), 0u);
  EXPECT_NE(made.remarks.front().find("parameter "), std::string::npos);
}

TEST(Interpolation, TakesDirectSharesAsTheyAre) {
  EXPECT_LT(
      (direct_weights(Eigen::Vector3d(1.0, 0.0, 3.0)) - Eigen::Vector3d(0.25, 0.0, 0.75)).norm(),
      1e-15);
  EXPECT_LT((direct_weights(Eigen::Vector3d::Zero()) - Eigen::Vector3d::Constant(1.0 / 3.0)).norm(),
            1e-15);
  std::mt19937_64 random(34);
  const ExampleSet set = test::random_loops(random, 3);
  const Interpolator direct =
      fit_interpolator(set, Eigen::MatrixXd::Identity(3, 3), {.method = Method::direct});
  EXPECT_NEAR(weights_at(direct, Eigen::RowVector3d(1.0, 0.0, 3.0)).weights[2], 0.75, 1e-15);
}

TEST(Interpolation, HalfSquaredDifferencesAreThoseOfTheDistance) {
  std::mt19937_64 random(35);
  ExampleSet set = test::random_loops(random, 3);
  // With the same timing the moments are those of the distance itself.
  for (Example& example : set.examples) {
    example.clip.poses.resize(24);
    example.keytimes = {0.0, 0.8};
  }
  const Eigen::MatrixXd half = half_squared_differences(set);
  const double expected =
      0.5 * distance(set.examples[0], set.examples[2]).by_joint_and_time.array().square().mean();
  EXPECT_NEAR(half(0, 2), expected, 1e-12);
  EXPECT_EQ(half(1, 1), 0.0);
  EXPECT_EQ(half(0, 2), half(2, 0));
}

}  // namespace
}  // namespace mien::motion
