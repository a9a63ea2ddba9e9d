#include "pipeline/base/statistics/pair_counts.h"

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

using Numbers = std::vector<std::size_t>;

TEST(WinGroups, AreOneIfEachStimulusWinsAgainstSomeChain) {
  const WinGroups circle = win_groups({{0, 1, 3, 0}, {1, 2, 3, 0}, {2, 3, 3, 0}, {3, 0, 1, 0}}, 4);
  EXPECT_EQ(circle.group, (Numbers{0, 0, 0, 0}));
  EXPECT_EQ(circle.sizes, (Numbers{4}));
  EXPECT_EQ(circle.records[2], WinRecord::estimated);
  EXPECT_EQ(circle.parts, 1);
}

TEST(WinGroups, AreTheStimuliThemselvesInAPerfectOrder) {
  const WinGroups order = win_groups({{0, 1, 3, 0}, {2, 1, 0, 3}, {0, 2, 1, 0}}, 4);
  EXPECT_EQ(order.sizes, (Numbers{1, 1, 1, 1}));
  EXPECT_EQ(order.records,
            (std::vector<WinRecord>{WinRecord::always_won, WinRecord::separated,
                                    WinRecord::always_lost, WinRecord::not_compared}));
  EXPECT_EQ(order.compared, 3);
  EXPECT_EQ(order.parts, 1);
}

TEST(WinGroups, TiesConnectBothWays) {
  EXPECT_EQ(win_groups({{0, 1, 3, 0, 1}}, 2).sizes, (Numbers{2}));
  EXPECT_EQ(win_groups({{0, 1, 3, 0, 0}}, 2).sizes, (Numbers{1, 1}));
}

TEST(WinGroups, AreNumberedInTheOrderOfTheirStimuli) {
  // 0 and 3 beat each other, 1 and 2 as well, and 0 always beats 1.
  const WinGroups groups = win_groups({{0, 3, 1, 1}, {1, 2, 1, 1}, {0, 1, 5, 0}, {4, 5, 1, 1}}, 7);
  EXPECT_EQ(groups.group, (Numbers{0, 1, 1, 0, 2, 2, 3}));
  EXPECT_EQ(groups.sizes, (Numbers{2, 2, 2, 1}));
  EXPECT_EQ(groups.parts, 2);
  EXPECT_EQ(groups.compared, 6);
}

}  // namespace
}  // namespace mien::pipeline
