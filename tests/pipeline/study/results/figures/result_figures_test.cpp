#include "pipeline/study/results/figures/result_figures.h"

#include <gtest/gtest.h>

#include "pipeline/plot_texts.h"
#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

Results results_of_study(const Manifest& manifest, const std::vector<AnswerRow>& rows) {
  return results_of(collect_answers(manifest, rows), rows, {});
}

std::vector<ResultFigure> figures_of(const Results& results, const std::string& section) {
  std::vector<ResultFigure> figures = result_figures(results);
  std::erase_if(figures, [&](const ResultFigure& one) { return one.section != section; });
  return figures;
}

TEST(ResultFigures, DrawsPairsAgainstChance) {
  const Manifest manifest = pair_study();
  const auto figures =
      figures_of(results_of_study(manifest, answers_to(manifest, {{{"happy", "sad-happy"}, 2.0}})),
                 "preferences");
  ASSERT_EQ(figures.size(), 1u);
  EXPECT_EQ(figures[0].name, "pairs-sad-happy");
  test::expect_texts_apart(figures[0].plot);
  for (const std::string& words : {std::string("chance 50 %"), std::string("not happy"),
                                   std::string("n = 12"), std::string(simulated_ratings_mark),
                                   std::string("Preferred stimulus of each pair: more happy")})
    EXPECT_TRUE(test::says(figures[0].plot, words)) << words;
}

TEST(ResultFigures, DividesManyPairsIntoSeveralFigures) {
  Manifest manifest = pair_study();
  manifest.questionnaire->pairs.clear();
  const auto& stimuli = manifest.stimuli;
  for (std::size_t i = 0; i < stimuli.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      manifest.questionnaire->pairs.push_back({stimuli[i].id, stimuli[k].id});
  const auto figures = figures_of(results_of_study(manifest, answers_to(manifest)), "preferences");
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[1].name, "pairs-sad-happy-2");
  EXPECT_NE(figures[0].caption.find("This figure has pairs 1 to 8 of 10."), std::string::npos);
  EXPECT_NE(figures[1].caption.find("This figure has pairs 9 to 10 of 10."), std::string::npos);
  EXPECT_TRUE(test::says(figures[1].plot,
                         "Preferred stimulus of each pair: more happy (pairs 9 to 10 of 10)"));
  for (const ResultFigure& figure : figures) test::expect_texts_apart(figure.plot);
}

TEST(ResultFigures, DividesWorthsThatCannotBeComparedByHeadings) {
  const Manifest manifest = all_pairs_study(16);
  std::vector<AnswerRow> rows = answers_to(manifest);
  const auto is_happy = [](const std::string& id) { return id == "happy" || id == "acted-happy"; };
  for (AnswerRow& row : rows) {  // both are always preferred to the three others
    if (!row.counts() || is_happy(row.stimulus) == is_happy(row.against)) continue;
    row.value = is_happy(row.stimulus) ? row.stimulus : row.against;
    row.value_raw = is_happy(row.stimulus) ? "left" : "right";
  }
  const auto figures = figures_of(results_of_study(manifest, rows), "worth");
  ASSERT_EQ(figures.size(), 1u);
  test::expect_texts_apart(figures[0].plot);
  for (const char* words : {"Group 1, whose worths can be compared with each other only",
                            "Group 2, whose worths can be compared with each other only",
                            "Log-worth (0: mean of the group)"})
    EXPECT_TRUE(test::says(figures[0].plot, words)) << words;
  const auto whole =
      figures_of(results_of_study(
                     manifest, answers_to(manifest, {}, {.spread = RatingSpread{.residual = 1.5}})),
                 "worth");
  EXPECT_FALSE(test::says(whole[0].plot, "Group 1"));
}

TEST(ResultFigures, DrawsWorthsHighestFirst) {
  const Manifest manifest = all_pairs_study(12);
  std::vector<AnswerRow> rows = answers_to(manifest, {{{"sad", "sad-happy"}, -1.0}});
  for (AnswerRow& row : rows) {  // always chosen
    if (row.counts() && (row.stimulus == "happy" || row.against == "happy")) {
      row.value = "happy";
      row.value_raw = row.stimulus == "happy" ? "left" : "right";
    }
  }
  const auto figures = figures_of(results_of_study(manifest, rows), "worth");
  ASSERT_EQ(figures.size(), 1u);
  EXPECT_EQ(figures[0].name, "worth-sad-happy");
  test::expect_texts_apart(figures[0].plot);
  for (const std::string& words :
       {std::string("Worth of the stimuli: more happy"), std::string("acted-sad"),
        std::string("always chosen: no finite worth"), std::string(simulated_ratings_mark)})
    EXPECT_TRUE(test::says(figures[0].plot, words)) << words;
  const std::vector<DrawnText> texts = test::texts_of(figures[0].plot);
  const auto height_of = [&](const std::string& name) {
    return std::ranges::find(texts, name, &DrawnText::text)->box.y;
  };
  EXPECT_LT(height_of("happy"), height_of("walk"));
  EXPECT_LT(height_of("walk"), height_of("sad"));
}

TEST(ResultFigures, CountsTheWordsThatMostPeopleGave) {
  Manifest manifest = two_emotion_study(4);
  manifest.questionnaire->answer = {.words = true};
  manifest.questionnaire->scales.ids = {"sad-happy"};
  std::vector<AnswerRow> rows = answers_to(manifest);
  for (AnswerRow& row : rows)
    if (row.stimulus == "sad")
      row.value = row.participant == "p001" ? "Tired, slow、TIRED" : "  tired ;悲しい";
  const Results results = results_of_study(manifest, rows);
  std::vector<WordFrequency> own = results.words;
  std::erase_if(own, [](const WordFrequency& count) { return count.stimulus != "sad"; });
  ASSERT_EQ(own.size(), 3u);
  EXPECT_EQ(own[0].word, "tired");
  EXPECT_EQ(own[0].people, 4);
  EXPECT_EQ(own[1].word, "悲しい");
  EXPECT_EQ(own[1].people, 3);
  EXPECT_EQ(own[2].word, "slow");
  EXPECT_EQ(own[2].respondents, 4);
  const auto figures = figures_of(results, "words");
  ASSERT_EQ(figures.size(), 1u);
  test::expect_texts_apart(figures[0].plot);
  EXPECT_TRUE(test::says(figures[0].plot, "悲しい"));
  EXPECT_TRUE(test::says(figures[0].plot, std::string(simulated_ratings_mark)));
}

}  // namespace
}  // namespace mien::pipeline
