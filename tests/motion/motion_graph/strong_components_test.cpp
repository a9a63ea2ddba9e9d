#include "motion/motion_graph/strong_components.h"

#include <gtest/gtest.h>

#include "motion/math/random_number.h"

namespace mien::motion {
namespace {

using Leaving = std::vector<std::vector<int>>;

/// Whether there is a way, for all pairs.
std::vector<std::vector<bool>> ways(const Leaving& leaving) {
  std::vector<std::vector<bool>> way(leaving.size(), std::vector<bool>(leaving.size(), false));
  for (std::size_t from = 0; from < leaving.size(); ++from) {
    std::vector<int> open = {static_cast<int>(from)};
    way[from][from] = true;
    while (!open.empty()) {
      const auto here = static_cast<std::size_t>(open.back());
      open.pop_back();
      for (const int to : leaving[here]) {
        if (way[from][static_cast<std::size_t>(to)]) continue;
        way[from][static_cast<std::size_t>(to)] = true;
        open.push_back(to);
      }
    }
  }
  return way;
}

TEST(StrongComponents, HoldThoseThatReachEachOther) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Leaving leaving(25);
    for (std::uint64_t e = 0; e < 35; ++e) {
      const auto from = random_bits(seed, 2 * e) % leaving.size();
      leaving[from].push_back(static_cast<int>(random_bits(seed, 2 * e + 1) % leaving.size()));
    }
    const std::vector<int> component = strong_components(leaving);
    const auto way = ways(leaving);
    for (std::size_t a = 0; a < leaving.size(); ++a) {
      for (std::size_t b = 0; b < leaving.size(); ++b) {
        EXPECT_EQ(component[a] == component[b], way[a][b] && way[b][a]);
      }
    }
  }
}

TEST(StrongComponents, ALongChainNeedsNoStack) {
  Leaving chain(200000);
  for (std::size_t n = 0; n + 1 < chain.size(); ++n) chain[n] = {static_cast<int>(n) + 1};
  chain.back() = {0};
  const std::vector<int> component = strong_components(chain);
  for (const int number : component) ASSERT_EQ(number, 0);
}

}  // namespace
}  // namespace mien::motion
