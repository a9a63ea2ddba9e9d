#include <gtest/gtest.h>

#include "pipeline/production/run/run.h"

namespace mien::pipeline {
namespace {

using Lines = std::vector<std::string>;

TEST(WarningsOfStimuli, OfOneCauseAreOneLine) {
  std::vector<std::pair<std::string, std::string>> said;
  for (int i = 1; i <= 43; ++i) said.emplace_back("s" + std::to_string(i), "the left foot slides");
  said.emplace_back("s2", "the rate was changed");
  EXPECT_EQ(grouped_warnings(said),
            (Lines{"s1, s2, s3, s4, s5, s6 and 37 more: the left foot slides",
                   "s2: the rate was changed"}));
}

TEST(WarningsOfStimuli, KeepTheOrderInWhichTheyAreSaidAndNameEachOnce) {
  EXPECT_EQ(grouped_warnings({{"b", "x"}, {"a", "y"}, {"a", "x"}, {"b", "x"}}),
            (Lines{"b, a: x", "a: y"}));
  EXPECT_TRUE(grouped_warnings({}).empty());
}

}  // namespace
}  // namespace mien::pipeline
