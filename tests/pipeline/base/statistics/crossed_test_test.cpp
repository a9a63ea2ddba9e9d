#include "pipeline/base/statistics/crossed_test.h"

#include <cmath>
#include <string>

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <gtest/gtest.h>

#include "pipeline/base/statistics/analysis_of_variance.h"
#include "pipeline/base/statistics/named_random.h"
#include "pipeline/base/statistics/reference_values.h"

namespace mien::pipeline {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

CrossedRatings crossed_sample(const std::string& name, test::Expected& expected) {
  CrossedRatings crossed{test::table_of_sample(name, expected), {}, {}};
  const auto per_cell = static_cast<Index>(expected.at("per_cell"));
  for (Index column = 0; column < crossed.ratings.cols(); ++column)
    crossed.cells.push_back(static_cast<std::size_t>(column / per_cell));
  return crossed;
}

void expect_reference(const std::string& name, const std::string& effect,
                      const std::vector<std::size_t>& factors, RandomParticipants random) {
  test::Expected sample_size(name);
  const CrossedSquares squares = crossed_squares(crossed_sample(name, sample_size));
  std::vector<int> levels;
  for (const double level : test::sample(name + "/levels"))
    levels.push_back(static_cast<int>(level));
  const CrossedTest found = crossed_test(squares, effect_contrasts(factors, levels), random,
                                         VectorXd::Zero(squares.cell_means.size()));
  test::Expected expected(name + "/" + effect);
  // Iterated estimates of R have errors of about 1e-6.
  expected.is("f", found.f, 1e-4);
  expected.is("degrees", found.degrees);
  expected.is("error_degrees", found.error_degrees, 1e-4);
  expected.is("p", found.p, 1e-5);
}

TEST(CrossedTest, IsThatOfMixedModelsInR) {
  expect_reference("crossed-2-3", "A", {0}, RandomParticipants::intercepts);
  expect_reference("crossed-2-3", "B", {1}, RandomParticipants::intercepts);
  expect_reference("crossed-2-3", "A:B", {0, 1}, RandomParticipants::intercepts);
  expect_reference("crossed-2", "A", {0}, RandomParticipants::intercepts);
  expect_reference("crossed-slopes", "A", {0}, RandomParticipants::slopes);
  expect_reference("crossed-none", "A", {0}, RandomParticipants::intercepts);
}

/// Ratings of so many participants and stimuli in each of two cells.
CrossedRatings two_cells(std::uint64_t stream, Index people, Index first, Index second,
                         double stimulus, double slope, double difference) {
  CrossedRatings crossed{MatrixXd(people, first + second), {}, {}};
  for (Index column = 0; column < first + second; ++column)
    crossed.cells.push_back(column < first ? 0 : 1);
  std::uint64_t next = 0;
  const auto draw = [&] { return normal_number(stream, next++); };
  VectorXd of_stimuli(first + second);
  for (double& effect : of_stimuli) effect = stimulus * draw();
  for (Index person = 0; person < people; ++person) {
    const double mean = draw();
    const double own[2] = {slope * draw(), slope * draw()};
    for (Index column = 0; column < first + second; ++column) {
      const std::size_t cell = crossed.cells[static_cast<std::size_t>(column)];
      crossed.ratings(person, column) =
          mean + own[cell] + of_stimuli[column] + (cell == 0 ? difference : 0.0) + draw();
    }
  }
  return crossed;
}

double share_found(int studies, RandomParticipants random, auto&& study) {
  int found = 0;
  for (int i = 0; i < studies; ++i) {
    const CrossedSquares squares = crossed_squares(study(1000 + static_cast<std::uint64_t>(i)));
    found += crossed_test(squares, effect_contrasts({0}, {2}), random, VectorXd::Zero(2)).p < 0.05;
  }
  return static_cast<double>(found) / studies;
}

TEST(CrossedTest, KeepsItsLevelWhereStimuliDiffer) {
  constexpr int studies = 4000;
  constexpr double margin = 0.0125;  // 3.6 standard errors
  const double slopes = share_found(studies, RandomParticipants::slopes, [](std::uint64_t stream) {
    return two_cells(stream, 20, 8, 8, 0.7, 0.5, 0.0);
  });
  EXPECT_NEAR(slopes, 0.05, margin);
  const double intercepts =
      share_found(studies, RandomParticipants::intercepts,
                  [](std::uint64_t stream) { return two_cells(stream, 20, 5, 10, 0.7, 0.0, 0.0); });
  EXPECT_NEAR(intercepts, 0.05, margin);
}

TEST(CrossedTest, HasThePowerOfTheNoncentralDistribution) {
  // Westfall, Kenny and Judd (2014), stimuli within conditions: the noncentrality of the difference
  // of cell means is d / sqrt(2·(σ²_PC/p + σ²_S/q + σ²_E/(p·q))) for p participants and q stimuli
  // in each condition, with Satterthwaite's degrees of freedom of the expected mean squares.
  constexpr double people = 24, stimuli = 10, stimulus = 0.5, slope = 0.4, difference = 0.8;
  const double of_people = slope * slope + 1.0 / stimuli;  // mean squares over cells, per stimulus
  const double of_stimuli = people / stimuli * stimulus * stimulus + 1.0 / stimuli;
  const double of_rest = 1.0 / stimuli;
  const double error = of_people + of_stimuli - of_rest;
  const double degrees =
      error * error /
      (of_people * of_people / (people - 1.0) + of_stimuli * of_stimuli / (2.0 * (stimuli - 1.0)) +
       of_rest * of_rest / ((people - 1.0) * 2.0 * (stimuli - 1.0)));
  const double delta = difference / std::sqrt(2.0 * error / people);
  const double critical = quantile(complement(boost::math::students_t(degrees), 0.025));
  const boost::math::non_central_t distribution(degrees, delta);
  const double expected = cdf(complement(distribution, critical)) + cdf(distribution, -critical);
  EXPECT_GT(expected, 0.4);
  EXPECT_LT(expected, 0.9);
  const double found = share_found(4000, RandomParticipants::slopes, [&](std::uint64_t stream) {
    return two_cells(stream, static_cast<Index>(people), static_cast<Index>(stimuli),
                     static_cast<Index>(stimuli), stimulus, slope, difference);
  });
  EXPECT_NEAR(found, expected, 0.028);  // 3.5 standard errors
}

TEST(CrossedTest, AddsAShiftToTheMeans) {
  const CrossedRatings plain = two_cells(7, 12, 4, 4, 0.5, 0.3, 0.0);
  CrossedRatings moved = plain;
  moved.ratings.leftCols(4).array() += 0.9;
  const MatrixXd effect = effect_contrasts({0}, {2});
  VectorXd shift(2);
  shift << 0.9, 0.0;
  const CrossedTest by_shift =
      crossed_test(crossed_squares(plain), effect, RandomParticipants::slopes, shift);
  const CrossedTest by_ratings =
      crossed_test(crossed_squares(moved), effect, RandomParticipants::slopes, VectorXd::Zero(2));
  EXPECT_NEAR(by_shift.f, by_ratings.f, 1e-9);
  EXPECT_NEAR(by_shift.error_degrees, by_ratings.error_degrees, 1e-9);
  EXPECT_GT(by_shift.f, 1.0);
}

TEST(CrossedTest, WeighsGroupsEqually) {
  // Groups of different sizes and means: participants' deviations are those from their groups.
  CrossedRatings crossed = two_cells(9, 12, 3, 3, 0.5, 0.3, 0.5);
  crossed.groups = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1};
  crossed.ratings.bottomRows(4).array() += 5.0;
  const CrossedSquares squares = crossed_squares(crossed);
  EXPECT_EQ(squares.person_degrees, 10.0);
  EXPECT_NEAR(squares.people, 4.0 / (1.0 / 8.0 + 1.0 / 4.0), 1e-12);
  const double expected = 0.5 * (crossed.ratings.topLeftCorner(8, 3).mean() +
                                 crossed.ratings.bottomLeftCorner(4, 3).mean());
  EXPECT_NEAR(squares.cell_means[0], expected, 1e-12);
  crossed.ratings.bottomRows(4).array() -= 3.0;
  EXPECT_NEAR(crossed_squares(crossed).all_squares, squares.all_squares, 1e-9);
}

TEST(CrossedTest, NeedsSeveralStimuliInACell) {
  const CrossedSquares squares = crossed_squares(two_cells(3, 8, 1, 1, 0.5, 0.0, 1.0));
  EXPECT_TRUE(std::isnan(crossed_test(squares, effect_contrasts({0}, {2}),
                                      RandomParticipants::slopes, VectorXd::Zero(2))
                             .p));
}

}  // namespace
}  // namespace mien::pipeline
