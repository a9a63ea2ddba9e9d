#include "pipeline/matching/simulated_trial.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/procedural/builtin_sets.h"
#include "pipeline/documents/csv.h"
#include "pipeline/matching/simulated_evaluation.h"
#include "pipeline/synthesis/synthesis.h"

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
      try_interface(goal, {.name = "a", .reading_error = 0.2, .seeing_error = 0.0}, bowl);
  EXPECT_LT(trial.distance, 0.09);
  EXPECT_LT(trial.distance, trial.first_distance);
}

TEST(SimulatedTrial, StopsWhenTheMotionMatchesOrThePatienceEnds) {
  int looks = 0;
  const SliderDistance far = [&](const Eigen::RowVectorXd& s) {
    ++looks;
    return 1.0 + 0.001 * s.sum();
  };
  SimulatedUser user = {.name = "b", .most_looks = 17};
  SimulatedTrial trial = try_interface(row({0.5, 0.5}), user, far);
  EXPECT_EQ(trial.looks, 17);
  EXPECT_EQ(looks, 17);
  EXPECT_FALSE(trial.matched);
  trial = try_interface(row({0.5, 0.5}), user, [](const auto&) { return 0.03; });
  EXPECT_EQ(trial.looks, 1);
  EXPECT_TRUE(trial.matched);
}

TEST(SimulatedTrial, TheFirstGuessIsTheIdealReadWithAnErrorToATenth) {
  const Eigen::RowVectorXd ideal = row({0.42, 0.77, 0.0, 1.0});
  const SliderDistance any = [](const Eigen::RowVectorXd&) { return 0.01; };
  const auto exact = try_interface(ideal, {.name = "c", .reading_error = 0.0}, any);
  EXPECT_NEAR((exact.first_guess - row({0.4, 0.8, 0.0, 1.0})).norm(), 0.0, 1e-12);
  double squares = 0.0;
  for (int u = 0; u < 500; ++u) {
    const auto guess = try_interface(row({0.5}), {.name = std::to_string(u)}, any).first_guess;
    squares += std::pow(guess[0] - 0.5, 2) / 500;
  }
  // Rounding adds 0.1²/12 to the variance.
  EXPECT_NEAR(std::sqrt(squares), std::sqrt(0.15 * 0.15 + 0.01 / 12), 0.02);
}

TEST(SimulatedTrial, TheSameUserDoesTheSame) {
  const SliderDistance bowl = [](const Eigen::RowVectorXd& s) { return 0.1 + s.squaredNorm(); };
  const auto a = try_interface(row({0.5, 0.6}), {.seed = 1, .name = "u"}, bowl);
  const auto b = try_interface(row({0.5, 0.6}), {.seed = 1, .name = "u"}, bowl);
  const auto c = try_interface(row({0.5, 0.6}), {.seed = 2, .name = "u"}, bowl);
  EXPECT_EQ(a.distance, b.distance);
  EXPECT_EQ(a.looks, b.looks);
  EXPECT_NE(a.distance, c.distance);
}

Repertoire rated_repertoire() {
  Manifest manifest;
  manifest.examples.builtin = "walks-10";
  manifest.ratings.source = Ratings::Source::builtin;
  return load_repertoire(manifest);
}

TEST(InterfaceEvaluation, IdealAdjectivesAndWeightsMakeTheTargetAgain) {
  const Repertoire repertoire = rated_repertoire();
  const auto interfaces = interfaces_of(repertoire);
  ASSERT_EQ(interfaces.size(), 3u);
  const Eigen::RowVectorXd place = repertoire.parameters.values.col(4).head(4).transpose();
  const motion::Example target =
      motion_of(fit_interface(interfaces[0], {}, repertoire), place, {}, repertoire);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(10);
  weights[4] = 1.0;  // an example's own adjectives
  for (const SliderInterface& interface : interfaces) {
    const auto ideal = ideal_settings(interface, target, weights, repertoire);
    const motion::Example made =
        motion_of(fit_interface(interface, {}, repertoire), ideal, {}, repertoire);
    EXPECT_LT(motion::distance(target, made).mean, 1e-6) << name_of(interface.kind);
  }
}

TEST(InterfaceEvaluation, EveryMethodMeetsItsOwnTargetsOnFineSliders) {
  using enum motion::InterpolationMethod;
  const Repertoire repertoire = rated_repertoire();
  const auto interfaces = interfaces_of(repertoire);
  const auto targets = sample_targets(repertoire.parameters, interfaces[0].sliders,
                                      {.targets = 2, .practice = 0, .seed = 1});
  const auto results =
      evaluate_interfaces(repertoire, targets, {},
                          {.methods = {cardinal, nearest, inverse_distance, grid, kriging, pca},
                           .steps = {0.001},
                           .users = 0});
  ASSERT_EQ(results.size(), 6u * 2u * 3u);
  for (const InterfaceResult& r : results) {
    if (r.kind != InterfaceKind::adjectives) continue;
    EXPECT_LT(r.distance, 0.001) << r.target << " " << motion::name_of(r.method);
  }
}

TEST(InterfaceEvaluation, FinerSlidersComeNearerAndTheTablesSaySimulated) {
  const Repertoire repertoire = rated_repertoire();
  const auto interfaces = interfaces_of(repertoire);
  const auto targets = sample_targets(repertoire.parameters, interfaces[0].sliders,
                                      {.targets = 3, .practice = 0, .seed = 1});
  const auto results =
      evaluate_interfaces(repertoire, targets, {}, {.steps = {0.01, 0.25}, .users = 0, .seed = 1});
  ASSERT_EQ(results.size(), 3u * 3u * 2u);
  const auto summaries = summarise(results);
  ASSERT_EQ(summaries.size(), 6u);
  EXPECT_EQ(summaries[0].count, 3);
  for (std::size_t i : {0u, 4u}) {  // features do not determine the weights
    EXPECT_LT(summaries[i].mean_first, summaries[i + 1].mean_first) << name_of(summaries[i].kind);
    EXPECT_LT(summaries[i].mean_first, 0.02);
  }
  const CsvTable table = parse_csv(results_csv(results), "t.csv");
  const int simulated = require_column(table, "simulated");
  for (const auto& r : table.rows) EXPECT_EQ(r[static_cast<std::size_t>(simulated)].text, "1");
}

TEST(InterfaceEvaluation, TriesEveryMethodOfInterpolationByItself) {
  const Repertoire repertoire = rated_repertoire();
  const auto interfaces = interfaces_of(repertoire);
  const auto targets = sample_targets(repertoire.parameters, interfaces[0].sliders,
                                      {.targets = 2, .practice = 0, .seed = 1});
  using enum motion::InterpolationMethod;
  const EvaluationOptions both = {.methods = {cardinal, inverse_distance}, .users = 1, .seed = 1};
  EvaluationOptions one = both;
  one.methods = {inverse_distance};
  const auto summaries = summarise(evaluate_interfaces(repertoire, targets, {}, both));
  const auto alone = summarise(evaluate_interfaces(repertoire, targets, {}, one));
  ASSERT_EQ(summaries.size(), 2 * alone.size());
  bool differs = false;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    const InterfaceSummary& other = summaries[alone.size() + i];
    EXPECT_EQ(other.method, inverse_distance);
    EXPECT_EQ(other.mean_first, alone[i].mean_first);
    differs = differs || summaries[i].mean_first != other.mean_first;
  }
  EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace mien::pipeline
