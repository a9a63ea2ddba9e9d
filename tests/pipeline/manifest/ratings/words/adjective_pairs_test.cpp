#include "pipeline/manifest/ratings/words/adjective_pairs.h"

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

using Cluster = std::optional<Primary> AdjectivePair::*;

long count_in(Cluster table, std::optional<Primary> cluster) {
  return std::ranges::count(adjective_pairs(), cluster, table);
}

TEST(AdjectivePairs, AreFortyOneWithIdsInOrder) {
  ASSERT_EQ(adjective_pairs().size(), 41u);
  for (int i = 0; i < 41; ++i) EXPECT_EQ(adjective_pairs()[static_cast<size_t>(i)].id, i + 1);
}

TEST(AdjectivePairs, KeyIsLowAndHighWithAHyphenAndUnique) {
  std::set<std::string_view> keys;
  for (const AdjectivePair& pair : adjective_pairs()) {
    EXPECT_EQ(pair.key, std::string(pair.low) + "-" + std::string(pair.high));
    EXPECT_TRUE(keys.insert(pair.key).second) << pair.key;
  }
}

TEST(AdjectivePairs, JapaneseNamesTellThePairsApart) {
  std::set<std::pair<std::string_view, std::string_view>> names;
  for (const AdjectivePair& pair : adjective_pairs()) {
    EXPECT_FALSE(pair.ja_low.empty());
    EXPECT_NE(pair.ja_low, pair.ja_high);
    EXPECT_TRUE(names.insert({pair.ja_low, pair.ja_high}).second) << pair.key;
  }
}

TEST(AdjectivePairs, ClustersOfTable2HaveThePublishedSizes) {
  EXPECT_EQ(count_in(&AdjectivePair::table_2, Primary::quickness), 3);
  EXPECT_EQ(count_in(&AdjectivePair::table_2, Primary::clearness), 10);
  EXPECT_EQ(count_in(&AdjectivePair::table_2, Primary::activeness), 9);
  EXPECT_EQ(count_in(&AdjectivePair::table_2, Primary::largeness), 5);
}

TEST(AdjectivePairs, ClustersOfTable3HaveThePublishedSizes) {
  EXPECT_EQ(count_in(&AdjectivePair::table_3, Primary::quickness), 2);
  EXPECT_EQ(count_in(&AdjectivePair::table_3, Primary::clearness), 7);
  EXPECT_EQ(count_in(&AdjectivePair::table_3, Primary::activeness), 12);
  EXPECT_EQ(count_in(&AdjectivePair::table_3, Primary::largeness), 8);
}

TEST(AdjectivePairs, TablesShare22PairsOf14InTheSameClusterAndLeave7Out) {
  const auto both = [](const AdjectivePair& pair) { return pair.table_2 && pair.table_3; };
  const auto same = [&](const AdjectivePair& pair) {
    return both(pair) && pair.table_2 == pair.table_3;
  };
  const auto neither = [](const AdjectivePair& pair) { return !pair.table_2 && !pair.table_3; };
  EXPECT_EQ(std::ranges::count_if(adjective_pairs(), both), 22);
  EXPECT_EQ(std::ranges::count_if(adjective_pairs(), same), 14);
  EXPECT_EQ(std::ranges::count_if(adjective_pairs(), neither), 7);
}

TEST(AdjectivePairs, AreFoundByKey) {
  ASSERT_NE(find_adjective_pair("sad-happy"), nullptr);
  EXPECT_EQ(find_adjective_pair("sad-happy")->id, 14);
  EXPECT_EQ(find_adjective_pair("happy-sad"), nullptr);
  EXPECT_EQ(find_adjective_pair(""), nullptr);
}

TEST(AdjectivePairs, NarrowBroadAndNarrowWideAreDifferentPairs) {
  EXPECT_EQ(find_adjective_pair("narrow-broad")->table_2, Primary::largeness);
  EXPECT_EQ(find_adjective_pair("narrow-broad")->table_3, std::nullopt);
  EXPECT_EQ(find_adjective_pair("narrow-wide")->table_2, std::nullopt);
  EXPECT_EQ(find_adjective_pair("narrow-wide")->table_3, Primary::largeness);
}

}  // namespace
}  // namespace mien::pipeline
