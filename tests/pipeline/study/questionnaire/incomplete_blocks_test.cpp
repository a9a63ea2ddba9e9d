#include "pipeline/study/questionnaire/incomplete_blocks.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

using Blocks = std::vector<std::vector<std::size_t>>;

int spread(const std::vector<int>& counts) {
  const auto [least, most] = std::ranges::minmax_element(counts);
  return *most - *least;
}

TEST(IncompleteBlocks, DealEachThingAsOftenAsEveryOtherAfterEveryBlock) {
  for (std::size_t treatments = 2; treatments <= 30; treatments += 7) {
    for (std::size_t size = 1; size <= treatments; size += 3) {
      std::vector<int> dealt(treatments);
      for (const auto& block : incomplete_blocks(treatments, size, 25, treatments + size)) {
        EXPECT_EQ(std::set<std::size_t>(block.begin(), block.end()).size(), size);
        EXPECT_TRUE(std::ranges::is_sorted(block));
        for (const std::size_t treatment : block) ++dealt.at(treatment);
        EXPECT_LE(spread(dealt), 1) << treatments << " " << size;
      }
    }
  }
}

std::vector<int> together(std::size_t treatments, const Blocks& blocks) {
  std::vector<int> counts(treatments * (treatments - 1) / 2);
  for (const auto& block : blocks) {
    for (const std::size_t a : block) {
      for (const std::size_t b : block) {
        if (a < b) ++counts[b * (b - 1) / 2 + a];
      }
    }
  }
  return counts;
}

TEST(IncompleteBlocks, DealPairsNearlyEvenly) {
  // 40 participants see 20 of 40: each two are together 40 · 20 · 19 / (40 · 39) = 9.74 times on
  // the average. Dealt by chance, the standard deviation would be about 2.6.
  const std::vector<int> counts = together(40, incomplete_blocks(40, 20, 40, 3));
  double sum = 0.0, squares = 0.0;
  for (const int count : counts) {
    sum += count;
    squares += count * count;
  }
  const auto n = static_cast<double>(counts.size());
  EXPECT_NEAR(sum / n, 40.0 * 20 * 19 / (40 * 39), 1e-9);
  EXPECT_LT(std::sqrt(squares / n - sum * sum / n / n), 1.9);
  EXPECT_LE(spread(counts), 12);
}

TEST(IncompleteBlocks, HaveEveryKindInEqualShares) {
  // 30 treatments, 18 of kind 0 and 12 of kind 1: ten of them are six and four, or nearly.
  std::vector<std::vector<std::size_t>> kinds;
  for (std::size_t treatment = 0; treatment < 30; ++treatment)
    kinds.push_back({treatment < 18 ? 0U : 1U});
  for (const auto& block : incomplete_blocks(30, 10, 40, 1, kinds)) {
    const auto first =
        std::ranges::count_if(block, [](std::size_t treatment) { return treatment < 18; });
    EXPECT_GE(first, 5);
    EXPECT_LE(first, 7);
  }
}

TEST(IncompleteBlocks, StayWhenMoreAreDealt) {
  const Blocks few = incomplete_blocks(30, 12, 10, 5);
  const Blocks many = incomplete_blocks(30, 12, 40, 5);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  EXPECT_NE(few, incomplete_blocks(30, 12, 10, 6));
}

}  // namespace
}  // namespace mien::pipeline
