#include "pipeline/study/matching/simulated_trial.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

Eigen::RowVectorXd row(std::initializer_list<double> values) {
  Eigen::RowVectorXd result(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

TEST(SimulatedTrial, AUserWithGoodEyesFindsTheWayDown) {
  const Eigen::RowVectorXd goal = row({0.33, 0.71, 0.52});
  const SliderDistance bowl = [&](const Eigen::RowVectorXd& s) {
    return 0.05 + (s - goal).norm();  // below 0.06 within 0.01 of the goal
  };
  const SimulatedTrial trial =
      simulate_trial(goal, {.name = "a", .reading_error = 0.2, .seeing_error = 0.0}, bowl);
  EXPECT_LT(trial.distance, 0.09);
  EXPECT_LT(trial.distance, trial.first_distance);
}

TEST(SimulatedTrial, StopsWhenTheMotionMatchesOrThePatienceEnds) {
  int views = 0;
  const SliderDistance far = [&](const Eigen::RowVectorXd& s) {
    ++views;
    return 1.0 + 0.001 * s.sum();
  };
  SimulatedUser user = {.name = "b", .max_views = 17};
  SimulatedTrial trial = simulate_trial(row({0.5, 0.5}), user, far);
  EXPECT_EQ(trial.views, 17);
  EXPECT_EQ(views, 17);
  EXPECT_FALSE(trial.matched);
  trial = simulate_trial(row({0.5, 0.5}), user, [](const auto&) { return 0.03; });
  EXPECT_EQ(trial.views, 1);
  EXPECT_TRUE(trial.matched);
}

TEST(SimulatedTrial, TheFirstGuessIsTheIdealReadWithAnErrorToATenth) {
  const Eigen::RowVectorXd ideal = row({0.42, 0.77, 0.0, 1.0});
  const SliderDistance any = [](const Eigen::RowVectorXd&) { return 0.01; };
  const auto exact = simulate_trial(ideal, {.name = "c", .reading_error = 0.0}, any);
  EXPECT_NEAR((exact.first_guess - row({0.4, 0.8, 0.0, 1.0})).norm(), 0.0, 1e-12);
  double squares = 0.0;
  for (int u = 0; u < 500; ++u) {
    const auto guess = simulate_trial(row({0.5}), {.name = std::to_string(u)}, any).first_guess;
    squares += std::pow(guess[0] - 0.5, 2) / 500;
  }
  // Rounding adds 0.1²/12 to the variance.
  EXPECT_NEAR(std::sqrt(squares), std::sqrt(0.15 * 0.15 + 0.01 / 12), 0.02);
}

TEST(SimulatedTrial, TheSameUserDoesTheSame) {
  const SliderDistance bowl = [](const Eigen::RowVectorXd& s) { return 0.1 + s.squaredNorm(); };
  const auto a = simulate_trial(row({0.5, 0.6}), {.seed = 1, .name = "u"}, bowl);
  const auto b = simulate_trial(row({0.5, 0.6}), {.seed = 1, .name = "u"}, bowl);
  const auto c = simulate_trial(row({0.5, 0.6}), {.seed = 2, .name = "u"}, bowl);
  EXPECT_EQ(a.distance, b.distance);
  EXPECT_EQ(a.views, b.views);
  EXPECT_NE(a.distance, c.distance);
}

}  // namespace
}  // namespace mien::pipeline
