#include "pipeline/manifest/factor_crossing.h"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

using Settings = std::vector<MatchedSetting>;

/// Acted and modified motions of two emotions by two actors, and the neutral motion of each actor.
FactorTable emotions_by_actors() {
  FactorTable table{{"actor", "made", "emotion"}, {}};
  for (const char* actor : {"woman", "man"}) {
    table.rows.push_back({actor, "as-is", "neutral"});
    for (const char* made : {"acted", "modified"})
      for (const char* emotion : {"sad", "happy"}) table.rows.push_back({actor, made, emotion});
  }
  return table;
}

TEST(FactorCrossing, OfACompleteDesignIsTheDesign) {
  const FactorTable table{{"a", "b"}, {{"x", "1"}, {"x", "2"}, {"y", "2"}, {"y", "1"}, {"x", "1"}}};
  const Crossing crossing = largest_crossing(table);
  EXPECT_EQ(crossing.factors, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(crossing.levels, (std::vector<std::vector<std::string>>{{"x", "y"}, {"1", "2"}}));
  EXPECT_EQ(crossing.cells, (std::vector<std::vector<std::size_t>>{{0, 4}, {1}, {3}, {2}}));
  EXPECT_EQ(crossing.stimuli(), 5u);
  EXPECT_TRUE(crossing.at.empty());
}

TEST(FactorCrossing, LeavesOutLevelsThatDoNotOccurWithAllOthers) {
  const Crossing crossing = largest_crossing(emotions_by_actors());
  EXPECT_EQ(crossing.levels, (std::vector<std::vector<std::string>>{
                                 {"woman", "man"}, {"acted", "modified"}, {"sad", "happy"}}));
  EXPECT_EQ(crossing.cells.size(), 8u);
  for (const auto& cell : crossing.cells) {
    ASSERT_EQ(cell.size(), 1u);
    EXPECT_NE(cell[0] % 5, 0u) << "a neutral motion";
  }
}

TEST(FactorCrossing, KeepsOneLevelOfAFactorThatCannotBeCrossed) {
  // Persons are nested in sexes.
  const FactorTable table{{"sex", "person"},
                          {{"f", "p1"}, {"f", "p2"}, {"f", "p3"}, {"m", "p4"}, {"m", "p5"}}};
  const Crossing crossing = largest_crossing(table);
  EXPECT_EQ(crossing.factors, std::vector<std::size_t>{1});
  EXPECT_EQ(crossing.levels[0], (std::vector<std::string>{"p1", "p2", "p3"}));
  ASSERT_EQ(crossing.at.size(), 1u);
  EXPECT_EQ(crossing.at[0].second, "f");
}

TEST(FactorCrossing, HasNoStimulusWithoutALevel) {
  const FactorTable table{{"a", "b"}, {{"x", "1"}, {"y", "1"}, {"x", ""}, {"", ""}, {"x", "2"}}};
  const Crossing crossing = largest_crossing(table);
  EXPECT_EQ(crossing.factors, std::vector<std::size_t>{1});
  EXPECT_EQ(crossing.at, (std::vector<std::pair<std::size_t, std::string>>{{0, "x"}}));
  EXPECT_EQ(crossing.cells, (std::vector<std::vector<std::size_t>>{{0}, {4}}));
}

TEST(FactorCrossing, IsEmptyWhereNothingIsCrossed) {
  EXPECT_TRUE(largest_crossing({{}, {{}, {}}}).empty());
  EXPECT_TRUE(largest_crossing({{"a"}, {{""}, {""}}}).empty());
  EXPECT_TRUE(largest_crossing({{"a", "b"}, {{"x", "1"}, {"y", "2"}}}).empty());
}

TEST(FactorCrossing, IsNotSearchedWithTooManyLevels) {
  FactorTable table{{"a", "b"}, {}};
  for (int i = 0; i < 17; ++i)
    for (int k = 0; k < 17; ++k)
      table.rows.push_back({"a" + std::to_string(i), "b" + std::to_string(k)});
  EXPECT_FALSE(is_searchable(table));
  EXPECT_EQ(largest_crossing(table).cells.size(), 289u) << "complete: nothing to search";
  table.rows.pop_back();
  EXPECT_TRUE(largest_crossing(table).empty());
}

/// The most cells of a crossing of two factors with at least two levels each, by trying all sets.
std::size_t most_cells(const std::vector<std::vector<bool>>& occurs) {
  const std::size_t rows = occurs.size(), columns = occurs[0].size();
  std::size_t most = 0;
  for (unsigned r = 1; r < (1U << rows); ++r) {
    for (unsigned c = 1; c < (1U << columns); ++c) {
      std::size_t height = 0, width = 0;
      bool is_complete = true;
      for (std::size_t k = 0; k < columns; ++k) width += c >> k & 1U;
      for (std::size_t i = 0; i < rows; ++i) {
        if ((r >> i & 1U) == 0U) continue;
        ++height;
        for (std::size_t k = 0; k < columns; ++k)
          is_complete = is_complete && ((c >> k & 1U) == 0U || occurs[i][k]);
      }
      if (is_complete && height > 1 && width > 1) most = std::max(most, height * width);
    }
  }
  return most;
}

TEST(FactorCrossing, IsTheLargestOfAll) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<std::vector<bool>> occurs(4, std::vector<bool>(5));
    FactorTable table{{"a", "b"}, {}};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 5; ++k) {
        occurs[i][k] = random() % 3 != 0;
        if (occurs[i][k]) table.rows.push_back({std::to_string(i), std::to_string(k)});
      }
    const std::size_t most = most_cells(occurs);
    const Crossing crossing = largest_crossing(table);
    if (most > 0) {
      EXPECT_EQ(crossing.factors.size(), 2u);
      EXPECT_EQ(crossing.cells.size(), most);
    } else {
      EXPECT_LT(crossing.factors.size(), 2u);
    }
  }
}

TEST(MatchedSettings, HaveAllLevelsThatAreCompared) {
  FactorTable table = emotions_by_actors();
  table.rows.push_back({"woman", "modified", "angry"});  // acted by nobody
  const Settings settings =
      matched_settings(table, {{"made", {{"modified", 1.0}, {"acted", -1.0}}}});
  ASSERT_EQ(settings.size(), 4u);
  std::set<std::string> names;
  for (const MatchedSetting& setting : settings) {
    ASSERT_EQ(setting.levels.size(), 2u);
    names.insert(setting.levels[0].second + " " + setting.levels[1].second);
    ASSERT_EQ(setting.cells.size(), 2u);
    EXPECT_EQ(setting.cells[0].first + setting.cells[1].first, 0.0);
    for (const auto& [weight, stimuli] : setting.cells) {
      ASSERT_EQ(stimuli.size(), 1u);
      EXPECT_EQ(table.rows[stimuli[0]][1], weight > 0.0 ? "modified" : "acted");
    }
  }
  EXPECT_EQ(names, (std::set<std::string>{"woman sad", "woman happy", "man sad", "man happy"}));
}

TEST(MatchedSettings, MultiplyTheWeightsOfSeveralFactors) {
  const Settings settings =
      matched_settings(emotions_by_actors(), {{"made", {{"modified", 1.0}, {"acted", -1.0}}},
                                              {"emotion", {{"sad", 2.0}, {"happy", -2.0}}}});
  ASSERT_EQ(settings.size(), 2u);  // the actors
  const FactorTable table = emotions_by_actors();
  ASSERT_EQ(settings[0].cells.size(), 4u);
  for (const auto& [weight, stimuli] : settings[0].cells) {
    const std::vector<std::string>& levels = table.rows[stimuli.at(0)];
    EXPECT_EQ(weight, (levels[1] == "modified" ? 1.0 : -1.0) * (levels[2] == "sad" ? 2.0 : -2.0));
  }
}

TEST(MatchedSettings, CanBeRestrictedAndIgnoreWeightsOfZero) {
  const std::vector<std::pair<std::string, LevelWeights>> weights = {
      {"emotion", {{"sad", 1.0}, {"happy", -1.0}, {"neutral", 0.0}}}};
  EXPECT_EQ(matched_settings(emotions_by_actors(), weights).size(), 4u);
  const Settings settings = matched_settings(emotions_by_actors(), weights, {{"actor", "man"}});
  ASSERT_EQ(settings.size(), 2u);
  EXPECT_EQ(settings[0].levels[0].second, "man");
}

TEST(MatchedSettings, AreNoneWhereLevelsNeverOccurTogether) {
  EXPECT_TRUE(
      matched_settings(emotions_by_actors(), {{"emotion", {{"sad", 1.0}, {"neutral", -1.0}}}})
          .empty());
}

}  // namespace
}  // namespace mien::pipeline
