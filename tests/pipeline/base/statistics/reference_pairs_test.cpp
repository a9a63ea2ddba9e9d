// Consistency of paired comparisons, Elo's ratings and resampled worths against R: definitions
// counted triad by triad, all orders of the comparisons, and glm (reference/reference.R).

#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "pipeline/base/statistics/elo_rating.h"
#include "pipeline/base/statistics/reference_values.h"
#include "pipeline/base/statistics/transitivity.h"
#include "pipeline/base/statistics/worth_bootstrap.h"

namespace mien::pipeline {
namespace {

using test::Expected;
using test::sample;

/// Counts of a table of wins (a row for each chosen stimulus) and of one of ties.
std::vector<PairCount> counts_of(const std::vector<double>& wins, const std::vector<double>& ties,
                                 std::size_t stimuli) {
  std::vector<PairCount> counts;
  for (std::size_t i = 0; i < stimuli; ++i)
    for (std::size_t k = i + 1; k < stimuli; ++k)
      counts.push_back({i, k, wins[i * stimuli + k], wins[k * stimuli + i],
                        ties.empty() ? 0.0 : ties[i * stimuli + k]});
  return counts;
}

TEST(ReferenceOfPairs, HasTheCircularTriadsThatAreCounted) {
  for (const std::string name : {"six", "seven-odd", "eight-majorities"}) {
    Expected expected(name);
    const auto stimuli = static_cast<std::size_t>(expected.at("stimuli"));
    const auto found = circular_triads(counts_of(sample(name), {}, stimuli), stimuli);
    ASSERT_TRUE(found) << name;
    expected.is("circular", found->circular);
    expected.is("most", found->most);
    expected.is("by_chance", found->by_chance);
    expected.is("zeta", found->zeta);
  }
}

TEST(ReferenceOfPairs, HasTheViolationsOfTransitivityThatAreCounted) {
  for (const std::string name : {"shares", "shares-ties"}) {
    Expected expected(name);
    const auto stimuli = static_cast<std::size_t>(expected.at("stimuli"));
    const TransitivityViolations found =
        transitivity_violations(counts_of(sample(name), sample(name + "/ties"), stimuli), stimuli);
    expected.is("triads", found.triads);
    expected.is("weak", found.weak);
    expected.is("moderate", found.moderate);
    expected.is("strong", found.strong);
  }
}

TEST(ReferenceOfPairs, HasEloRatingsOverAllOrders) {
  const std::vector<double> games = sample("elo-games");
  std::vector<PairCount> counts;
  for (std::size_t i = 0; i < games.size(); i += 3) {
    const double result = games[i + 2];
    counts.push_back({static_cast<std::size_t>(games[i]) - 1,
                      static_cast<std::size_t>(games[i + 1]) - 1, result == 1.0 ? 1.0 : 0.0,
                      result == 0.0 ? 1.0 : 0.0, result == 0.5 ? 1.0 : 0.0});
  }
  constexpr int orders = 20000;  // random ones of 5040
  const std::vector<EloRating> found = elo_ratings(counts, 4, 1, orders);
  Expected mean("elo-games");
  Expected deviation("elo-games/deviation");
  for (std::size_t i = 0; i < 4; ++i) {
    const double error = deviation.at(std::to_string(i + 1)) / std::sqrt(1.0 * orders);
    mean.is(std::to_string(i + 1), found[i].mean, 4.0 * error);
    deviation.is(std::to_string(i + 1), found[i].deviation, 4.0 * error);
  }
}

TEST(ReferenceOfPairs, HasTheIntervalsOfResampledParticipants) {
  Expected expected("worth-people");
  const Eigen::MatrixXd chosen = test::table_of_sample("worth-people", expected);
  std::vector<std::vector<PairCount>> people;
  std::vector<PairCount> all;
  for (Eigen::Index person = 0; person < chosen.rows(); ++person) {
    std::vector<PairCount>& own = people.emplace_back();
    Eigen::Index pair = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = i + 1; k < 4; ++k, ++pair)
        own.push_back({i, k, chosen(person, pair), 3.0 - chosen(person, pair)});
    all.insert(all.end(), own.begin(), own.end());
  }
  const BradleyTerry fit = bradley_terry(all, 4, OrderEffect::none);
  const WorthBootstrap found =
      worth_bootstrap(people, 4, OrderEffect::none, 1, 3999, {{1.0, 0.0, 0.0, -1.0}});
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string number = std::to_string(i + 1);
    expected.is("worth_" + number, fit.worth[i], 1e-6);
    // Both are simulated: ends have standard errors of about 0.006.
    expected.is("low_" + number, found.worth[i].low, 0.035);
    expected.is("high_" + number, found.worth[i].high, 0.035);
  }
  expected.is("error", found.contrasts[0].error, 0.012);
}

}  // namespace
}  // namespace mien::pipeline
