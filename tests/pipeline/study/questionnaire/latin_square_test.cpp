#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "pipeline/study/questionnaire/orders.h"

namespace mien::pipeline {
namespace {

using Row = std::vector<std::size_t>;

TEST(LatinSquare, OfFourIsThePublishedOne) {
  // Williams 1949, as Bradley 1958 prints it: ABDC, BCAD, CDBA, DACB.
  EXPECT_EQ(williams_row(4, 0), (Row{0, 1, 3, 2}));
  EXPECT_EQ(williams_row(4, 1), (Row{1, 2, 0, 3}));
  EXPECT_EQ(williams_row(4, 2), (Row{2, 3, 1, 0}));
  EXPECT_EQ(williams_row(4, 3), (Row{3, 0, 2, 1}));
}

TEST(LatinSquare, OfSixBeginsWithThePublishedRow) {
  // Bradley 1958: 1 2 6 3 5 4.
  EXPECT_EQ(williams_row(6, 0), (Row{0, 1, 5, 2, 4, 3}));
}

TEST(LatinSquare, BalancesPlacesAndNeighboursForEveryCount) {
  for (std::size_t count = 1; count <= 41; ++count) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> position_counts, succession_counts;
    for (std::size_t row = 0; row < williams_rows(count); ++row) {
      const Row order = williams_row(count, row);
      for (std::size_t place = 0; place < count; ++place) {
        ++position_counts[{order[place], place}];
        if (place > 0) ++succession_counts[{order[place - 1], order[place]}];
      }
    }
    const std::size_t times = count % 2 == 0 ? 1 : 2;
    EXPECT_EQ(position_counts.size(), count * count) << count;
    EXPECT_EQ(succession_counts.size(), count * (count - 1)) << count;
    for (const auto& [key, number] : position_counts) EXPECT_EQ(number, times) << count;
    for (const auto& [key, number] : succession_counts) EXPECT_EQ(number, times) << count;
  }
}

TEST(LatinSquare, GoesRound) { EXPECT_EQ(williams_row(5, 13), williams_row(5, 3)); }

}  // namespace
}  // namespace mien::pipeline
