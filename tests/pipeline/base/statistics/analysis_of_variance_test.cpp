#include "pipeline/base/statistics/analysis_of_variance.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>

#include "pipeline/base/statistics/named_random.h"
#include "pipeline/base/statistics/noncentral_interval.h"
#include "pipeline/base/statistics/reference_values.h"
#include "pipeline/base/statistics/t_test.h"

namespace mien::pipeline {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using test::Expected;
using test::sample;
using test::table_of_sample;

// R's noncentral distributions and its search for a root are less exact than the rest.
constexpr double noncentral_tolerance = 1e-7;

struct ReferenceCells {
  MatrixXd cells;
  std::vector<int> levels;
  std::vector<std::size_t> groups;

  explicit ReferenceCells(const std::string& name) {
    Expected shape(name);
    cells = table_of_sample(name, shape);
    for (const double number : sample(name + "/levels")) levels.push_back(static_cast<int>(number));
    for (const double number : sample(name + "/groups"))
      groups.push_back(static_cast<std::size_t>(number));
  }
};

/// "G:A:B", as afex names it.
std::string name_in_r(const VarianceEffect& effect) {
  std::string name = effect.by_group ? "G" : "";
  for (const std::size_t factor : effect.factors)
    name += (name.empty() ? "" : ":") + std::string(1, static_cast<char>('A' + factor));
  return name;
}

TEST(AnalysisOfVariance, AgreesWithR) {
  for (const std::string name : {"anova-3", "anova-2-3", "anova-3-2-4", "anova-2-2-2-2",
                                 "anova-groups", "anova-two-groups"}) {
    const ReferenceCells given(name);
    const auto effects = analysis_of_variance(given.cells, given.levels, given.groups);
    const bool has_groups = std::ranges::max(given.groups) > 0;
    EXPECT_EQ(effects.size(), (has_groups ? 2u : 1u) * (1u << given.levels.size()) - 1u) << name;
    for (const VarianceEffect& effect : effects) {
      Expected expected(name + "/" + name_in_r(effect));
      expected.is("f", effect.f);
      expected.is("degrees", effect.degrees);
      expected.is("error_degrees", effect.error_degrees);
      expected.is("squares", effect.squares);
      expected.is("error_squares", effect.error_squares);
      expected.is("p", effect.p);
      expected.is("epsilon", effect.epsilon);
      expected.is("p_corrected", effect.p_corrected);
      expected.is("partial_eta", effect.partial_eta);
      expected.is("generalized_eta", effect.generalized_eta);
      expected.is("low", effect.partial_eta_low, noncentral_tolerance);
      expected.is("high", effect.partial_eta_high, noncentral_tolerance);
    }
  }
}

TEST(AnalysisOfVariance, HasTheWithinParticipantMarginsOfCousineauAndMorey) {
  for (const std::string name : {"anova-3", "anova-2-3", "anova-3-2-4", "anova-2-2-2-2"}) {
    const ReferenceCells given(name);
    const Eigen::VectorXd margins = within_participant_margins(given.cells, 0.95);
    Expected expected(name + "/margins");
    for (Index i = 0; i < margins.size(); ++i) expected.is(std::to_string(i + 1), margins[i]);
  }
}

TEST(AnalysisOfVariance, ContrastsOfLevelsAreTestedAsByR) {
  for (const std::string name : {"anova-3", "anova-2-3", "anova-3-2-4", "anova-2-2-2-2"}) {
    const ReferenceCells given(name);
    const Index levels = given.levels[0];
    const Index inner = given.cells.cols() / levels;
    std::vector<double> scores;
    for (Index i = 0; i < given.cells.rows(); ++i) {
      const auto mean = [&](Index level) {
        return given.cells.row(i).segment(level * inner, inner).mean();
      };
      scores.push_back(levels == 2 ? mean(0) - mean(1) : mean(0) - 0.5 * (mean(1) + mean(2)));
    }
    const TTest test = paired_t_test(scores);
    const EffectInterval interval = cohens_dz_interval(test.t, static_cast<int>(scores.size()));
    Expected expected(name + "/contrast");
    expected.is("estimate", test.mean);
    expected.is("t", test.t);
    expected.is("degrees", test.degrees);
    expected.is("p", test.p);
    expected.is("dz", cohens_dz(scores));
    expected.is("dz_low", interval.low, noncentral_tolerance);
    expected.is("dz_high", interval.high, noncentral_tolerance);
  }
}

TEST(NoncentralInterval, AgreesWithR) {
  for (const auto& [name, f, one, other] :
       {std::tuple("0.2 2 30", 0.2, 2.0, 30.0), std::tuple("1.7 1.4 22.6", 1.7, 1.4, 22.6),
        std::tuple("4 3 57", 4.0, 3.0, 57.0), std::tuple("60 1 19", 60.0, 1.0, 19.0),
        std::tuple("250 6 120", 250.0, 6.0, 120.0)}) {
    const EffectInterval interval = partial_eta_interval(f, one, other);
    Expected expected(std::string("partial eta ") + name);
    expected.is("low", interval.low, noncentral_tolerance);
    expected.is("high", interval.high, noncentral_tolerance);
  }
  for (const auto& [name, t, pairs] :
       {std::tuple("0 10", 0.0, 10), std::tuple("2.1 24", 2.1, 24), std::tuple("-3.7 8", -3.7, 8),
        std::tuple("11 40", 11.0, 40)}) {
    const EffectInterval interval = cohens_dz_interval(t, pairs);
    Expected expected(std::string("dz ") + name);
    expected.is("low", interval.low, noncentral_tolerance);
    expected.is("high", interval.high, noncentral_tolerance);
  }
}

TEST(NoncentralInterval, ExcludesNoEffectWhereTheTestDoes) {
  // Critical values at 0.05: F(2, 30) = 3.3158, t(19) = 2.0930.
  EXPECT_EQ(partial_eta_interval(3.31, 2.0, 30.0).low, 0.0);
  EXPECT_GT(partial_eta_interval(3.32, 2.0, 30.0).low, 0.0);
  EXPECT_LT(cohens_dz_interval(2.092, 20).low, 0.0);
  EXPECT_GT(cohens_dz_interval(2.094, 20).low, 0.0);
  EXPECT_TRUE(std::isnan(partial_eta_interval(std::nan(""), 1.0, 10.0).low));
  EXPECT_TRUE(std::isnan(cohens_dz_interval(INFINITY, 10).high));
}

// A trace that hardly moves has effects like these.
TEST(NoncentralInterval, PassesOverIntoThatOfTheErrorAlone) {
  for (const double degrees : {1.0, 19.0, 200.0}) {
    const double t = std::sqrt(1e7);
    const int pairs = static_cast<int>(degrees) + 1;
    for (const double sign : {-1.0, 1.0}) {
      const EffectInterval before = cohens_dz_interval(0.999999 * sign * t, pairs);
      const EffectInterval after = cohens_dz_interval(1.000001 * sign * t, pairs);
      EXPECT_NEAR(after.low / before.low, 1.0, 1e-4) << degrees;
      EXPECT_NEAR(after.high / before.high, 1.0, 1e-4) << degrees;
    }
    const EffectInterval before = partial_eta_interval(0.999999e7 / 3.0, 3.0, degrees);
    const EffectInterval after = partial_eta_interval(1.000001e7 / 3.0, 3.0, degrees);
    EXPECT_NEAR((1.0 - after.low) / (1.0 - before.low), 1.0, 2e-3) << degrees;
    EXPECT_NEAR((1.0 - after.high) / (1.0 - before.high), 1.0, 2e-3) << degrees;
  }
}

TEST(NoncentralInterval, IsFoundForEffectsOfAnySize) {
  for (const double f : {0.0, 1e-6, 30.0, 1e3, 1e5, 1e7, 1e10, 1e15}) {
    const EffectInterval interval = partial_eta_interval(f, 5.0, 95.0);
    EXPECT_LE(interval.low, interval.high) << f;
    EXPECT_LE(interval.high, 1.0) << f;
  }
  for (const double t : {-1e6, -500.0, -3.0, 1e-9, 40.0, 3000.0, 1e5, 1e12}) {
    const EffectInterval interval = cohens_dz_interval(t, 30);
    EXPECT_LT(interval.low, t / std::sqrt(30.0)) << t;
    EXPECT_GT(interval.high, t / std::sqrt(30.0)) << t;
  }
}

/// Independent numbers with a deviation of their own for each cell, and an effect for each
/// participant.
MatrixXd random_cells(Index people, const std::vector<double>& deviations, int study) {
  MatrixXd cells(people, static_cast<Index>(deviations.size()));
  for (Index i = 0; i < people; ++i)
    for (Index k = 0; k < cells.cols(); ++k)
      cells(i, k) = normal(7, "person " + std::to_string(study) + " " + std::to_string(i)) +
                    deviations[static_cast<std::size_t>(k)] *
                        normal(7, "cell " + std::to_string(study) + " " + std::to_string(i) + " " +
                                      std::to_string(k));
  return cells;
}

TEST(AnalysisOfVariance, OfTwoLevelsIsThePairedTTest) {
  const MatrixXd cells = random_cells(11, {1.0, 2.0}, 0);
  std::vector<double> differences;
  for (Index i = 0; i < cells.rows(); ++i) differences.push_back(cells(i, 0) - cells(i, 1));
  const TTest test = paired_t_test(differences);
  const auto effects = analysis_of_variance(cells, {2});
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_NEAR(effects[0].f, test.t * test.t, 1e-10);
  EXPECT_NEAR(effects[0].p, test.p, 1e-12);
}

TEST(AnalysisOfVariance, IgnoresWhatParticipantsAddToAllAnswers) {
  const MatrixXd cells = random_cells(9, {1.0, 2.0, 0.5, 1.0, 1.0, 3.0}, 1);
  MatrixXd raised = cells;
  for (Index i = 0; i < cells.rows(); ++i) raised.row(i).array() += 10.0 * static_cast<double>(i);
  const auto before = analysis_of_variance(cells, {2, 3});
  const auto after = analysis_of_variance(raised, {2, 3});
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR(before[i].p_corrected, after[i].p_corrected, 1e-10);
}

TEST(AnalysisOfVariance, OfDifferencesThatAllParticipantsShareHasNoTest) {
  MatrixXd cells(4, 2);
  cells << 1.1, 1.4, 2.1, 2.4, 0.7, 1.0, 3.3, 3.6;
  const auto effects = analysis_of_variance(cells, {2});
  EXPECT_EQ(effects[0].error_squares, 0.0);
  EXPECT_TRUE(std::isnan(effects[0].f));
  EXPECT_TRUE(std::isnan(effects[0].p_corrected));
}

/// In how many of `studies` each effect has a p below 0.05.
struct FalsePositives {
  std::vector<int> corrected, uncorrected;
};

FalsePositives false_positives(int studies, const std::vector<double>& deviations,
                               const std::vector<int>& levels,
                               const std::vector<std::size_t>& groups, Index people) {
  FalsePositives found;
  for (int study = 0; study < studies; ++study) {
    const auto effects =
        analysis_of_variance(random_cells(people, deviations, study), levels, groups);
    found.corrected.resize(effects.size());
    found.uncorrected.resize(effects.size());
    for (std::size_t i = 0; i < effects.size(); ++i) {
      found.corrected[i] += effects[i].p_corrected < 0.05 ? 1 : 0;
      found.uncorrected[i] += effects[i].p < 0.05 ? 1 : 0;
    }
  }
  return found;
}

TEST(AnalysisOfVariance, FindsNoEffectMoreOftenThanStatedWithoutSphericity) {
  constexpr int studies = 600;
  const boost::math::binomial chance(studies, 0.05);
  const double most = quantile(complement(chance, 0.0005));
  const double least = quantile(chance, 0.0005);
  const FalsePositives found =
      false_positives(studies, {0.2, 0.2, 0.2, 3.0, 0.2, 0.2}, {6}, {}, 12);
  EXPECT_GT(found.uncorrected[0], most) << "the case needs the correction";
  EXPECT_LE(found.corrected[0], most);
  EXPECT_GE(found.corrected[0], least);
  const FalsePositives mixed =
      false_positives(studies, {1.0, 1.0, 1.0, 1.0}, {2, 2}, {0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1}, 11);
  ASSERT_EQ(mixed.corrected.size(), 7u);
  for (const int count : mixed.corrected) {
    EXPECT_LE(count, most);
    EXPECT_GE(count, least);
  }
}

TEST(AnalysisOfVariance, FindsAnInteractionThatIsThereAndNothingElse) {
  int interaction = 0;
  int first = 0;
  constexpr int studies = 200;
  for (int study = 0; study < studies; ++study) {
    MatrixXd cells = random_cells(14, {1.0, 1.0, 1.0, 1.0}, 1000 + study);
    cells.col(0).array() += 0.9;  // +, −, −, +: an interaction alone
    cells.col(3).array() += 0.9;
    const auto effects = analysis_of_variance(cells, {2, 2});
    interaction += effects[2].p_corrected < 0.05 ? 1 : 0;
    first += effects[0].p_corrected < 0.05 ? 1 : 0;
  }
  // Contrast scores have the mean 0.9 and the deviation 1: the power of F(1, 13) is 0.875.
  const boost::math::binomial found(studies, 0.875);
  EXPECT_GE(interaction, quantile(found, 0.0005));
  EXPECT_LE(interaction, quantile(complement(found, 0.0005)));
  EXPECT_LE(first, quantile(complement(boost::math::binomial(studies, 0.05), 0.0005)));
}

}  // namespace
}  // namespace mien::pipeline
