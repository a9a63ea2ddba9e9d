#include "pipeline/base/statistics/transitivity.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "pipeline/base/statistics/published_pairs.h"

namespace mien::pipeline {
namespace {

/// Answers in which `winners` says, for each pair 0:1, 0:2 … 1:2 …, whether the first was chosen.
std::vector<PairCount> round_robin(std::size_t stimuli, const std::vector<int>& winners) {
  std::vector<PairCount> counts;
  std::size_t next = 0;
  for (std::size_t i = 0; i < stimuli; ++i)
    for (std::size_t k = i + 1; k < stimuli; ++k, ++next)
      counts.push_back({i, k, 1.0 * winners[next], 1.0 - winners[next]});
  return counts;
}

/// Circular triads, counted one by one.
int counted_triads(const std::vector<PairCount>& counts, std::size_t stimuli) {
  std::vector<std::vector<bool>> wins(stimuli, std::vector<bool>(stimuli));
  for (const PairCount& one : counts) {
    wins[one.first][one.second] = one.first_wins > 0.0;
    wins[one.second][one.first] = one.second_wins > 0.0;
  }
  int circular = 0;
  for (std::size_t a = 0; a < stimuli; ++a)
    for (std::size_t b = a + 1; b < stimuli; ++b)
      for (std::size_t c = b + 1; c < stimuli; ++c)
        circular +=
            (wins[a][b] && wins[b][c] && wins[c][a]) || (wins[b][a] && wins[c][b] && wins[a][c])
                ? 1
                : 0;
  return circular;
}

TEST(CircularTriads, AreThoseCountedOneByOneInAllAnswersToFourAndFiveStimuli) {
  for (const std::size_t stimuli : {3UL, 4UL, 5UL}) {
    const std::size_t pairs = stimuli * (stimuli - 1) / 2;
    int most = 0;
    double sum = 0.0;
    for (std::size_t bits = 0; bits < (1UL << pairs); ++bits) {
      std::vector<int> winners;
      for (std::size_t i = 0; i < pairs; ++i) winners.push_back((bits >> i) & 1UL ? 1 : 0);
      const auto counts = round_robin(stimuli, winners);
      const auto found = circular_triads(counts, stimuli);
      ASSERT_TRUE(found);
      ASSERT_EQ(found->circular, counted_triads(counts, stimuli));
      EXPECT_NEAR(found->zeta, 1.0 - 1.0 * found->circular / found->most, 1e-12);
      most = std::max(most, found->circular);
      sum += found->circular;
    }
    const auto any = circular_triads(round_robin(stimuli, std::vector<int>(pairs, 1)), stimuli);
    EXPECT_EQ(any->most, most) << stimuli;
    EXPECT_NEAR(any->by_chance, sum / static_cast<double>(1UL << pairs), 1e-12) << stimuli;
    EXPECT_EQ(any->zeta, 1.0);
  }
}

TEST(CircularTriads, NeedAMajorityInEachPair) {
  std::vector<PairCount> counts = {{0, 1, 1, 0}, {1, 2, 1, 0}, {2, 0, 1, 0}};
  EXPECT_EQ(circular_triads(counts, 3)->zeta, 0.0);
  counts.push_back({1, 0, 1, 0});  // once each
  EXPECT_FALSE(circular_triads(counts, 3));
  counts.push_back({1, 0, 1, 0});  // 1 is preferred to 0, two to one
  EXPECT_EQ(circular_triads(counts, 3)->zeta, 1.0);
  EXPECT_FALSE(circular_triads({{0, 1, 1, 0}, {1, 2, 1, 0}, {2, 0, 0, 0, 1}}, 3));
  EXPECT_FALSE(circular_triads({{0, 1, 1, 0}, {1, 2, 1, 0}}, 3));
  EXPECT_FALSE(circular_triads({{0, 1, 1, 0}}, 2));
}

TransitivityViolations of_shares(double ab, double bc, double ac) {
  return transitivity_violations(
      {{0, 1, 10 * ab, 10 - 10 * ab}, {1, 2, 10 * bc, 10 - 10 * bc}, {0, 2, 10 * ac, 10 - 10 * ac}},
      3);
}

TEST(Transitivity, IsViolatedByDegrees) {
  const auto forms = [](const TransitivityViolations& found) {
    EXPECT_EQ(found.triads, 1);
    return 100 * found.weak + 10 * found.moderate + found.strong;
  };
  EXPECT_EQ(forms(of_shares(0.6, 0.7, 0.8)), 0);
  EXPECT_EQ(forms(of_shares(0.6, 0.7, 0.7)), 0);
  EXPECT_EQ(forms(of_shares(0.6, 0.8, 0.7)), 1);
  EXPECT_EQ(forms(of_shares(0.7, 0.8, 0.6)), 11);
  EXPECT_EQ(forms(of_shares(0.7, 0.8, 0.4)), 111);
  EXPECT_EQ(forms(of_shares(0.4, 0.3, 0.2)), 0);  // the same, from last to first
  EXPECT_EQ(forms(of_shares(0.5, 0.5, 0.5)), 0);
  EXPECT_EQ(forms(of_shares(0.5, 0.8, 0.8)), 0);
  EXPECT_EQ(forms(of_shares(0.5, 0.8, 0.7)), 0);   // in the order 1, 0, 2
  EXPECT_EQ(forms(of_shares(0.5, 0.8, 0.4)), 11);  // in the order 1, 2, 0
}

TEST(Transitivity, LeavesOutTriadsThatWereNotCompared) {
  EXPECT_EQ(transitivity_violations({{0, 1, 1, 0}, {1, 2, 1, 0}}, 3).triads, 0);
  EXPECT_EQ(transitivity_violations(test::flavours, 9).triads, 84);
}

TEST(Transitivity, CountsTiesAsHalf) {
  // 0.7, 0.7 and 0.75; without the ties the first would be 0.83.
  const auto found = transitivity_violations({{0, 1, 5, 1, 4}, {1, 2, 7, 3}, {0, 2, 15, 5}}, 3);
  EXPECT_EQ(found.triads, 1);
  EXPECT_EQ(found.strong, 0);
}

}  // namespace
}  // namespace mien::pipeline
