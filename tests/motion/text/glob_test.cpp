#include "motion/text/glob.h"

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

TEST(Glob, MatchesStarsMarksAndSets) {
  EXPECT_TRUE(matches_glob("*walk*.bvh", "dataset-1_walk_sad_002.bvh"));
  EXPECT_FALSE(matches_glob("*walk*.bvh", "dataset-1_bye_sad_001.bvh"));
  EXPECT_TRUE(matches_glob("*", ""));
  EXPECT_TRUE(matches_glob("a?c", "abc"));
  EXPECT_FALSE(matches_glob("a?c", "ac"));
  EXPECT_TRUE(matches_glob("[kt]_*", "t_run"));
  EXPECT_FALSE(matches_glob("[!kt]_*", "t_run"));
  EXPECT_TRUE(matches_glob("take[0-9]", "take7"));
  EXPECT_FALSE(matches_glob("take[0-9]", "takex"));
  EXPECT_TRUE(matches_glob("odd[", "odd["));
  EXPECT_TRUE(matches_glob("*a*a*a", "aaaa"));
  EXPECT_FALSE(matches_glob("Walk*", "walk"));
}

TEST(Glob, MatchesEitherOfBraces) {
  EXPECT_TRUE(matches_glob("*{walk,run}*.bvh", "a_run_1.bvh"));
  EXPECT_TRUE(matches_glob("*{walk,run}*.bvh", "a_walk_1.bvh"));
  EXPECT_FALSE(matches_glob("*{walk,run}*.bvh", "a_bye_1.bvh"));
  EXPECT_TRUE(matches_glob("{*_{slow,fast}_[12],x}", "walk_fast_2"));
  EXPECT_TRUE(matches_glob("{*_{slow,fast}_[12],x}", "x"));
  EXPECT_FALSE(matches_glob("{*_{slow,fast}_[12],x}", "walk_sad_2"));
  EXPECT_TRUE(matches_glob("take{,_2}", "take"));
  EXPECT_TRUE(matches_glob("odd{", "odd{"));
  EXPECT_TRUE(matches_glob("odd}", "odd}"));
}

}  // namespace
}  // namespace mien::motion
