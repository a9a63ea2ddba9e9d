#include <gtest/gtest.h>

#include "motion/examples/example_set.h"

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

TEST(Labels, AreWhatTellsNamesApart) {
  const std::vector<std::string> takes = {"dataset-1_walk_sad_001", "dataset-1_walk_sad_002",
                                          "dataset-1_walk_not-confident_001"};
  EXPECT_EQ(labels_from_names(takes),
            (std::vector<std::string>{"sad_001", "sad_002", "not-confident_001"}));
  const std::vector<std::string> single = {"dataset-1_bye_sad_001", "dataset-1_bye_normal_001"};
  EXPECT_EQ(labels_from_names(single), (std::vector<std::string>{"sad", "normal"}));
}

TEST(Labels, NeverCutWords) {
  const std::vector<std::string> names = {"walk_sadness", "walk_gladness"};
  EXPECT_EQ(labels_from_names(names), (std::vector<std::string>{"sadness", "gladness"}));
}

TEST(Labels, OfOneNameOrOfNestedNamesStayWhole) {
  EXPECT_EQ(labels_from_names(std::vector<std::string>{"walk_1"}),
            (std::vector<std::string>{"walk_1"}));
  const std::vector<std::string> nested = {"walk_", "walk_sad"};
  EXPECT_EQ(labels_from_names(nested), nested);
  EXPECT_TRUE(labels_from_names(std::vector<std::string>{}).empty());
}

}  // namespace
}  // namespace mien::motion
