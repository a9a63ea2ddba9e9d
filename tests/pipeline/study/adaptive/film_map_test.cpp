#include "pipeline/study/adaptive/film_map.h"

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pipeline/plot_texts.h"
#include "pipeline/study/adaptive/film_report.h"
#include "pipeline/study/adaptive/film_worlds.h"

namespace mien::pipeline {
namespace {

/// A choice of five films after two rounds, on `scales` scales.
FilmChoice choice_of(std::size_t scales, std::size_t rated = 12) {
  FilmChoice choice;
  choice.space = {{"swing", "lean", "tempo"}, {}, world_places(12, 1)};
  for (int i = 0; i < 12; ++i) choice.space.examples.push_back("walk" + std::to_string(i));
  choice.candidates = film_candidates(choice.space.places, 150, true, 1);
  std::vector<std::size_t> films;
  for (std::size_t f = 0; f < rated; ++f) films.push_back(f);
  for (std::size_t s = 0; s < scales; ++s) {
    RatedFilms one = world_films(choice.candidates, films, s + 1);
    one.scale = "low-high-" + std::to_string(s + 1);
    for (std::size_t f = 8; f < rated; ++f) one.rounds[f] = 2;
    choice.rated.scales.push_back(one);
  }
  choice.rated.simulated = true;
  choice.next = next_films(choice.candidates, choice.rated.scales, {.films = 5});
  choice.ids = {"round3-01", "round3-02", "round3-03", "round3-04", "round3-05"};
  choice.rounds = film_rounds(choice.candidates, choice.rated.scales);
  return choice;
}

TEST(FilmMap, KeepsItsTextsToThePageAndApart) {
  for (const std::size_t scales : {1u, 4u, 6u}) {
    const FilmChoice choice = choice_of(scales);
    test::expect_texts_apart(film_map_plot(choice));
  }
}

TEST(FilmMap, NamesScalesFilmsRoundsAndComponents) {
  const FilmChoice choice = choice_of(5);
  const Plot plot = film_map_plot(choice);
  for (const RatedFilms& scale : choice.rated.scales) EXPECT_TRUE(test::says(plot, scale.scale));
  for (const std::string& id : choice.ids) EXPECT_TRUE(test::says(plot, id)) << id;
  EXPECT_TRUE(test::says(plot, "rated film (12)"));
  EXPECT_TRUE(test::says(plot, "chosen for the next round (5)"));
  EXPECT_TRUE(test::says(plot, "film that can be made (150)"));
  int components = 0, expected = 0, deviations = 0;
  for (const DrawnText& text : test::texts_of(plot)) {
    components += text.text.find("principal component, ") != std::string::npos ? 1 : 0;
    expected += text.text == "expected rating" ? 1 : 0;
    deviations += text.text == "standard deviation" ? 1 : 0;
  }
  EXPECT_EQ(components, 2);
  EXPECT_EQ(expected, 5);
  EXPECT_EQ(deviations, 5);
}

TEST(FilmMap, IsMarkedWhereAnswersAreSimulated) {
  FilmChoice choice = choice_of(1);
  EXPECT_TRUE(test::says(film_map_plot(choice), "Simulated answers"));
  choice.rated.simulated = false;
  EXPECT_FALSE(test::says(film_map_plot(choice), "Simulated answers"));
}

TEST(FilmMap, StatesHowManyNamesHaveNoRoom) {
  FilmChoice choice = choice_of(1, 120);
  for (RatedFilms& scale : choice.rated.scales)
    for (std::string& id : scale.ids) id = "a film with a name of many words, " + id;
  int named = 0;
  std::string stated;
  for (const DrawnText& text : test::texts_of(film_map_plot(choice))) {
    named += text.text.starts_with("a film with") || text.text.starts_with("round3-") ? 1 : 0;
    if (text.text.starts_with("Without room for a name: ")) stated = text.text;
  }
  const int all = 120 + static_cast<int>(choice.next.films.size());
  EXPECT_LT(named, all);
  EXPECT_EQ(stated, "Without room for a name: " + std::to_string(all - named) + " films");
  test::expect_texts_apart(film_map_plot(choice));
}

TEST(FilmReport, TellsWhatEachRoundHasBrought) {
  const FilmChoice choice = choice_of(2);
  const std::string text = film_report(choice);
  EXPECT_EQ(text.find("simulated answers\n5 of 150 films that the examples allow, to learn"), 0u);
  EXPECT_NE(text.find(fmt::format("  {:>8} {:>6} {:>8}", 2, 4, 80)), std::string::npos) << text;
  EXPECT_NE(text.find(" round 1  round 2  after the next\n"), std::string::npos) << text;
  EXPECT_NE(text.find(fmt::format("low-high-2               {:8.2f} {:8.2f} {:8.2f}\n",
                                  choice.rounds[0].scales[1].deviation,
                                  choice.rounds[1].scales[1].deviation, choice.next.known_then[1])),
            std::string::npos)
      << text;
  FilmChoice first = choice;
  first.rounds.resize(1);
  EXPECT_EQ(film_report(first).find("round 1"), std::string::npos);
  EXPECT_NE(film_report(first).find("   now  after this round\n"), std::string::npos);
}

TEST(FilmTables, HaveARowForEachRoundAndScale) {
  const FilmChoice choice = choice_of(3);
  const std::vector<WrittenTable> tables = film_tables(choice);
  ASSERT_EQ(tables.size(), 3u);
  EXPECT_EQ(tables[2].form.path, "rounds.csv");
  EXPECT_EQ(std::ranges::count(tables[2].csv, '\n'), 1 + 2 * 3);
  const auto row = [&](const std::string& beginning) {
    const std::size_t from = tables[2].csv.find("\n" + beginning);
    if (from == std::string::npos) return std::string();
    return tables[2].csv.substr(from + 1, tables[2].csv.find('\n', from + 1) - from - 1);
  };
  EXPECT_NE(row("1,low-high-1,8,80,").find(",others,"), std::string::npos) << tables[2].csv;
  EXPECT_NE(row("2,low-high-3,4,40,").find(",before,"), std::string::npos) << tables[2].csv;
}

}  // namespace
}  // namespace mien::pipeline
