// What readers of a report could misread.

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

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

/// The page of a study of these stimuli, of which each is rated.
std::string page_of(Manifest manifest, const std::vector<std::string>& stimuli) {
  std::erase_if(manifest.stimuli, [&](const Stimulus& stimulus) {
    return std::ranges::find(stimuli, stimulus.id) == stimuli.end();
  });
  const std::vector<AnswerRow> rows = answers_to(manifest);
  const Results results = results_of(collect_answers(manifest, rows), rows, {});
  return results_page(results, result_figures(results), {}, {});
}

int count_in(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(ReportReading, RefersOnlyToSectionsThatThereAre) {
  const std::string differences = "Modified, acted and neutral motions";
  const std::string actors = "Actors and other factors";
  const std::string factor = "Videos that differ in one factor";
  const std::vector<std::string> all = {"walk", "acted-sad", "acted-happy", "sad", "happy"};

  // One actor: no section on levels of other factors.
  const std::string one_actor = page_of(two_emotion_study(6), all);
  EXPECT_EQ(count_in(one_actor, differences), 3);  // in the list of sections, heading and text
  EXPECT_NE(one_actor.find("In both sections, rows marked *"), std::string::npos);
  EXPECT_EQ(count_in(one_actor, actors) + count_in(one_actor, factor), 0);

  // Two videos of each speed, of which no emotion is intended.
  const std::vector<std::string> rated = {"acted-sad", "acted-happy", "sad", "happy"};
  Manifest speeds = two_emotion_study(6);
  for (Stimulus& stimulus : speeds.stimuli) {
    const bool is_fast = stimulus.id.starts_with("acted");
    stimulus.factors = {{"speed", is_fast ? "fast" : "slow"}};
  }
  const std::string one_factor = page_of(speeds, rated);
  EXPECT_EQ(count_in(one_factor, differences) + count_in(one_factor, actors), 0);
  EXPECT_EQ(count_in(one_factor, factor), 3);

  for (Stimulus& stimulus : speeds.stimuli) stimulus.factors[0].first = "actor";
  EXPECT_EQ(count_in(page_of(speeds, rated), actors), 3);

  for (Stimulus& stimulus : speeds.stimuli) stimulus.factors = {{"emotion", "sad"}};
  const std::string neither = page_of(speeds, rated);
  EXPECT_EQ(count_in(neither, differences) + count_in(neither, actors), 0);
  EXPECT_EQ(neither.find("In the section"), std::string::npos);
  EXPECT_NE(neither.find("Rows marked *"), std::string::npos);
}

TEST(ReportReading, HasThePlannedAnalysisFirst) {
  Manifest manifest = two_emotion_study(6);
  const std::vector<std::string> rated = {"acted-sad", "acted-happy", "sad", "happy"};
  const auto is_first = [&] {
    const std::string page = page_of(manifest, rated);
    const std::size_t factors = page.find("<section id=\"factors\">");
    EXPECT_NE(factors, std::string::npos);
    EXPECT_EQ(count_in(page, "<section id=\"factors\">"), 1);
    return factors < page.find("<section id=\"means\">");
  };
  EXPECT_FALSE(is_first());
  manifest.questionnaire->analysis.factorial.factors = {"made", "emotion"};
  EXPECT_TRUE(is_first());
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
