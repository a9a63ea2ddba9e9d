// What readers of a report could misread.

#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/study/results/figures/result_figures.h"
#include "pipeline/study/results/report/dataset.h"
#include "pipeline/study/results/report/page_style.h"
#include "pipeline/study/results/report/results_report.h"
#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

/// Emotions are chosen from a list, and rated on the scales.
Results chosen_and_rated() {
  Manifest manifest = two_emotion_study(12);
  manifest.questionnaire->trials = &emotion_form;
  manifest.questionnaire->choices = {{"sad", {"sad"}}, {"happy", {"happy"}}};
  const std::vector<AnswerRow> rows = answers_to(manifest);
  return results_of(collect_answers(manifest, rows), rows, {});
}

TEST(ReportReading, KeepsTheTwoMeasuresOfConfusionApart) {
  const Results results = chosen_and_rated();
  const std::vector<ResultFigure> figures = result_figures(results);
  const std::string page = results_page(results, figures, {}, {});
  const std::size_t ratings = page.find("<h3>By ratings</h3>");
  const std::size_t choices = page.find("<h3>By choices</h3>");
  ASSERT_NE(ratings, std::string::npos);
  ASSERT_NE(choices, std::string::npos);
  const std::size_t points = page.find("recall (share of points)", ratings);
  const std::size_t shares = page.find("recall (share of choices)", choices);
  EXPECT_LT(ratings, points);
  EXPECT_LT(points, choices);
  EXPECT_LT(choices, shares);
  int by_ratings = 0, by_choices = 0;
  for (const ResultFigure& figure : figures) {
    by_ratings += figure.plot.title == "Perceived emotions by ratings: all videos";
    by_choices += figure.plot.title == "Perceived emotions by choices: all videos";
  }
  EXPECT_EQ(by_ratings, 1);
  EXPECT_EQ(by_choices, 1);
}

std::string readme_of_dataset(const ParticipantTable& people) {
  const Manifest manifest = two_emotion_study(6);
  const std::vector<AnswerRow> rows = answers_to(manifest);
  const Results results = results_of(collect_answers(manifest, rows), rows, people);
  for (const DatasetFile& file : dataset_files(results, rows, {}))
    if (file.path == "README.md") return file.bytes;
  return "";
}

TEST(ReportReading, NamesATableOfParticipantsOnlyWhereThereIsOne) {
  EXPECT_NE(readme_of_dataset({}).find("- data/: the answers (one row each) and the stimuli\n"),
            std::string::npos);
  const ParticipantTable people{parse_csv(
      "participant,session,design,consented_at,finished,age\np001,s,d,,1,20\n", "people.csv")};
  EXPECT_NE(readme_of_dataset(people).find("the stimuli and the participants"), std::string::npos);
}

TEST(ReportReading, KeepsTheFirstColumnOfWideTablesInView) {
  const std::string style(results_style);
  EXPECT_TRUE(std::regex_search(
      style, std::regex(R"(\.wide td:first-child[^}]*position: sticky; left: 0)")));
}

}  // namespace
}  // namespace mien::pipeline
