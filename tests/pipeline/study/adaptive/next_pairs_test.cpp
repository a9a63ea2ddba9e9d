#include "pipeline/study/adaptive/next_pairs.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "pipeline/base/statistics/named_random.h"

namespace mien::pipeline {
namespace {

std::vector<StimulusPair> all_pairs_of(std::size_t stimuli) {
  std::vector<StimulusPair> pairs;
  for (std::size_t i = 0; i < stimuli; ++i)
    for (std::size_t j = i + 1; j < stimuli; ++j) pairs.push_back({i, j});
  return pairs;
}

/// Stimuli whose worths are known, and the answers about them, the same whenever they are asked.
struct PairWorld {
  std::uint64_t seed;
  std::vector<double> worths;

  PairWorld(std::uint64_t number, std::size_t stimuli, double spread) : seed(number) {
    for (std::size_t i = 0; i < stimuli; ++i)
      worths.push_back(spread * normal(seed, "worth/" + std::to_string(i)));
  }

  PairCount answers(const StimulusPair& pair, int count, const std::string& when) const {
    PairCount result{.first = pair.first, .second = pair.second};
    const double first = 1.0 / (1.0 + std::exp(worths[pair.second] - worths[pair.first]));
    for (int n = 0; n < count; ++n)
      (uniform(seed, when + "/" + std::to_string(pair.first) + "/" + std::to_string(pair.second) +
                         "/" + std::to_string(n)) < first
           ? result.first_wins
           : result.second_wins) += 1.0;
    return result;
  }

  /// Each stimulus compared with the next.
  std::vector<PairCount> ring(int count) const {
    std::vector<PairCount> counts;
    for (std::size_t i = 0; i < worths.size(); ++i)
      counts.push_back(answers({i, (i + 1) % worths.size()}, count, "ring"));
    return counts;
  }

  /// Root mean square error of the worths about their mean.
  double error_with(const std::vector<PairCount>& counts) const {
    const Eigen::VectorXd truth =
        Eigen::Map<const Eigen::VectorXd>(worths.data(), static_cast<Eigen::Index>(worths.size()));
    const Eigen::VectorXd off = pair_posterior(counts, worths.size()).mean - truth;
    return std::sqrt((off.array() - off.mean()).square().mean());
  }
};

// The choice by brute force: the covariance is made anew with each pair as if it had been asked.
TEST(NextPairs, AreThoseAfterWhichTheLeastIsUnknown) {
  const PairWorld world(3, 7, 1.2);
  const std::vector<PairCount> counts = world.ring(4);
  const std::vector<StimulusPair> possible = all_pairs_of(7);
  const NextPairs next = next_pairs(possible, {{"a", counts}}, 7, {.pairs = 4, .answers = 6.0});
  ASSERT_EQ(next.pairs.size(), 4u);
  PairPosterior known = pair_posterior(counts, 7);
  const double at_first = known.variance();
  std::set<std::size_t> taken;
  for (const NextPair& found : next.pairs) {
    std::size_t best = 0;
    double least = 1e300;
    Eigen::MatrixXd best_covariance;
    for (std::size_t p = 0; p < possible.size(); ++p) {
      if (taken.contains(p)) continue;
      Eigen::VectorXd pair = Eigen::VectorXd::Zero(7);
      pair[static_cast<Eigen::Index>(possible[p].first)] = 1.0;
      pair[static_cast<Eigen::Index>(possible[p].second)] = -1.0;
      const double curvature =
          expected_comparison(known, possible[p].first, possible[p].second).curvature;
      const Eigen::MatrixXd information =
          known.covariance.inverse() + 6.0 * curvature * pair * pair.transpose();
      const Eigen::MatrixXd covariance = information.inverse();
      const double left = covariance.trace() - covariance.sum() / 7.0;
      if (left >= least) continue;
      least = left;
      best = p;
      best_covariance = covariance;
    }
    EXPECT_EQ(found.pair, best);
    EXPECT_NEAR(found.gain, (known.variance() - least) / at_first, 1e-9);
    known.covariance = best_covariance;
    taken.insert(best);
  }
  EXPECT_NEAR(next.known_then[0], known.deviation(), 1e-9);
  EXPECT_NEAR(next.known_now[0], pair_posterior(counts, 7).deviation(), 1e-12);
}

/// Mean errors over worlds after rounds of pairs, by number of answers.
struct ErrorCurves {
  std::vector<double> answers, informative, random;
};

/// Rounds of `batch` pairs, each asked `each` times, after a ring.
ErrorCurves error_curves(std::size_t stimuli, double spread, int worlds, int rounds) {
  constexpr int each = 4;
  constexpr std::size_t batch = 8;
  const std::vector<StimulusPair> possible = all_pairs_of(stimuli);
  ErrorCurves curves;
  curves.informative.resize(static_cast<std::size_t>(rounds) + 1);
  curves.random = curves.informative;
  for (int w = 0; w < worlds; ++w) {
    const PairWorld world(1000 + static_cast<std::uint64_t>(w), stimuli, spread);
    std::vector<PairCount> chosen = world.ring(each), drawn = chosen;
    int draw = 0;
    for (std::size_t r = 0; r <= static_cast<std::size_t>(rounds); ++r) {
      curves.informative[r] += world.error_with(chosen) / worlds;
      curves.random[r] += world.error_with(drawn) / worlds;
      for (const NextPair& next :
           next_pairs(possible, {{"a", chosen}}, stimuli, {.pairs = batch, .answers = each}).pairs)
        chosen.push_back(world.answers(possible[next.pair], each, "chosen/" + std::to_string(r)));
      std::set<std::size_t> random;
      while (random.size() < batch)
        random.insert(
            static_cast<std::size_t>(uniform(world.seed, "draw/" + std::to_string(draw++)) *
                                     static_cast<double>(possible.size())));
      for (const std::size_t pair : random)
        drawn.push_back(world.answers(possible[pair], each, "drawn/" + std::to_string(r)));
    }
  }
  for (int r = 0; r <= rounds; ++r)
    curves.answers.push_back(each * (static_cast<double>(stimuli) + batch * r));
  return curves;
}

/// Number of answers after which the error of informative pairs is at most `aim`, linear between
/// rounds.
double answers_needed(const ErrorCurves& curves, double aim) {
  std::size_t r = 0;
  while (r < curves.informative.size() && curves.informative[r] > aim) ++r;
  if (r == 0) return curves.answers.front();
  if (r == curves.informative.size()) return 1e9;
  const double share =
      (curves.informative[r - 1] - aim) / (curves.informative[r - 1] - curves.informative[r]);
  return curves.answers[r - 1] + share * (curves.answers[r] - curves.answers[r - 1]);
}

// Informative pairs reach the error of random ones with fewer answers: the more, the farther apart
// the worths are, since answers about very different stimuli are foregone conclusions.
TEST(NextPairs, NeedFewerAnswersThanRandomOnes) {
  for (const auto& [spread, most] :
       std::vector<std::pair<double, double>>{{1.0, 0.97}, {2.0, 0.8}}) {
    const ErrorCurves curves = error_curves(16, spread, 24, 12);
    double share = 0.0;
    for (const std::size_t round : {6u, 8u, 10u, 12u})
      share += answers_needed(curves, curves.random[round]) / curves.answers[round] / 4.0;
    RecordProperty("share", std::to_string(share));
    EXPECT_LE(share, most) << spread << ": " << share;
  }
}

// … and that of all pairs.
TEST(NextPairs, NeedFewerAnswersThanAllPairs) {
  constexpr std::size_t stimuli = 16;
  constexpr int worlds = 24, each = 3;
  constexpr double spread = 2.0;
  double all = 0.0;
  for (int w = 0; w < worlds; ++w) {
    const PairWorld world(1000 + static_cast<std::uint64_t>(w), stimuli, spread);
    std::vector<PairCount> counts;
    for (const StimulusPair& pair : all_pairs_of(stimuli))
      counts.push_back(world.answers(pair, each, "all"));
    all += world.error_with(counts) / worlds;
  }
  const double share = answers_needed(error_curves(stimuli, spread, worlds, 12), all) /
                       static_cast<double>(each * all_pairs_of(stimuli).size());
  RecordProperty("share", std::to_string(share));
  EXPECT_LE(share, 0.9) << share;
}

TEST(NextPairs, CountAllItemsAlike) {
  const PairWorld one(5, 8, 1.0), other(6, 8, 1.0);
  const std::vector<StimulusPair> possible = all_pairs_of(8);
  const auto chosen = [&](const std::vector<ComparedItem>& items) {
    std::vector<std::size_t> pairs;
    for (const NextPair& pair : next_pairs(possible, items, 8, {.pairs = 6}).pairs)
      pairs.push_back(pair.pair);
    return pairs;
  };
  const ComparedItem a = {"a", one.ring(6)}, b = {"b", other.ring(6)};
  EXPECT_EQ(chosen({a, a}), chosen({a}));
  EXPECT_EQ(chosen({a, b}), chosen({b, a}));
  EXPECT_NE(chosen({a}), chosen({b}));
  const NextPairs next = next_pairs(possible, {a, b}, 8, {.pairs = 1});
  EXPECT_EQ(next.pairs[0].first_chosen.size(), 2u);
  EXPECT_EQ(next.known.size(), 2u);
  EXPECT_EQ(next.known_then.size(), 2u);
}

// A stimulus without comparisons is asked about first.
TEST(NextPairs, BeginWithWhatIsNotKnownAtAll) {
  std::vector<PairCount> counts;
  const PairWorld world(7, 6, 0.5);
  for (const PairCount& count : world.ring(20))
    if (count.first != 2 && count.second != 2) counts.push_back(count);
  const std::vector<StimulusPair> possible = all_pairs_of(6);
  const NextPair first = next_pairs(possible, {{"a", counts}}, 6, {.pairs = 1}).pairs.front();
  EXPECT_TRUE(possible[first.pair].first == 2 || possible[first.pair].second == 2);
}

TEST(NextPairs, AreNoMoreThanThereAre) {
  const std::vector<StimulusPair> possible = {{0, 1}, {1, 2}};
  const NextPairs next =
      next_pairs(possible, {{"a", {{.first = 0, .second = 1, .first_wins = 2.0}}}}, 3,
                 {.pairs = 5, .answers = 3.0});
  ASSERT_EQ(next.pairs.size(), 2u);
  EXPECT_NE(next.pairs[0].pair, next.pairs[1].pair);
  EXPECT_GE(next.pairs[0].gain, next.pairs[1].gain);
  EXPECT_LT(next.known_then[0], next.known_now[0]);
}

}  // namespace
}  // namespace mien::pipeline
