// Results of a study against what R says of the same answers (reference/reference.R).

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/statistics/reference_values.h"
#include "pipeline/study/results/best_worst_scores.h"
#include "pipeline/study/results/confusion.h"
#include "pipeline/study/results/detection_results.h"
#include "pipeline/study/results/retest.h"
#include "pipeline/study/results/summaries.h"

namespace mien::pipeline {
namespace {

using test::Expected;
using test::sample;

/// Five stimuli with intended emotions, rated on two scales: columns stimulus, person, ratings.
AnswerSet rated_answers() {
  AnswerSet answers;
  answers.scales = {{.id = "sad-happy", .low = "sad", .high = "happy"},
                    {.id = "weak-strong", .low = "weak", .high = "strong"}};
  int number = 0;
  for (const char* emotion : {"sad", "happy", "weak", "strong", "sad"})
    answers.stimuli.push_back({.id = std::to_string(++number), .emotion = emotion});
  const std::vector<double> rated = sample("rated");
  for (std::size_t i = 0; i < rated.size(); i += 4)
    for (std::size_t scale = 0; scale < 2; ++scale)
      answers.ratings.push_back({.person = static_cast<std::size_t>(rated[i + 1]) - 1,
                                 .stimulus = static_cast<std::size_t>(rated[i]) - 1,
                                 .scale = scale,
                                 .value = rated[i + 2 + scale]});
  return answers;
}

TEST(ReferenceResults, HaveTheConfusionOfR) {
  const std::vector<Confusion> confusions = confusions_of(rated_answers());
  ASSERT_EQ(confusions.size(), 1u);
  const Confusion& found = confusions[0];
  ASSERT_EQ(found.rows.size(), 4u);
  for (const ConfusionRow& row : found.rows) {
    Expected expected("confusion/" + row.emotion);
    for (std::size_t i = 0; i < found.columns.size(); ++i)
      expected.is(found.columns[i], row.points[i]);
    expected.is("recall", row.recall);
    expected.is("judged", row.judged);
    expected.is("hits", row.hits);
    expected.is("decided", row.decided);
    expected.is("showings", row.showings);
    expected.is("low", row.low);
    expected.is("high", row.high);
    expected.is("p", row.p);
  }
}

TEST(ReferenceResults, HaveTheCorrelationsOfR) {
  const std::vector<EndCorrelation> found = end_correlations(rated_answers());
  ASSERT_EQ(found.size(), 6u);
  for (const EndCorrelation& pair : found) {
    Expected expected(fmt::format("ends/{}-{}", pair.one + 1, pair.other + 1));
    expected.is("r", pair.correlation.r);
    expected.is("p", pair.correlation.p);
  }
}

TEST(ReferenceResults, HaveTheMeansOfR) {
  int compared = 0;
  for (const RatingSummary& found : summaries_of(rated_answers())) {
    if (found.scale != 0) continue;
    Expected expected("mean/" + std::to_string(found.stimulus + 1));
    expected.is("mean", found.mean);
    expected.is("sd", found.deviation);
    expected.is("median", found.median);
    expected.is("low", found.low);
    expected.is("high", found.high);
    ++compared;
  }
  EXPECT_EQ(compared, 5);
}

TEST(ReferenceResults, HaveTheRetestOfR) {
  const std::vector<double> again = sample("again");
  std::vector<RetestAnswer> answers;
  for (std::size_t i = 0; i < again.size(); i += 2) {
    RetestAnswer answer;
    answer.participant = "p";
    answer.item = "sad-happy";
    answer.first = shortest(again[i]);
    answer.second = shortest(again[i + 1]);
    answer.difference = again[i + 1] - again[i];
    answers.push_back(answer);
  }
  const RetestSummary found = retest_summaries_of(answers).at(0);
  Expected expected("again");
  expected.is("equal", found.equal);
  expected.is("mean_difference", found.mean_difference);
  expected.is("r", found.retest.r);
  expected.is("low", found.retest.low);
  expected.is("high", found.retest.high);
}

TEST(ReferenceResults, HaveTheScoresOfSetsOfR) {
  AnswerSet answers;
  answers.form = &best_worst_form;
  const std::vector<double> sets = sample("sets");
  for (std::size_t i = 0; i < sets.size(); i += 7) {
    AnalysedSet set{.person = static_cast<std::size_t>(sets[i]), .scale = "sad-happy"};
    for (std::size_t place = 1; place <= 4; ++place)
      set.stimuli.push_back(static_cast<std::size_t>(sets[i + place]));
    set.best = static_cast<std::size_t>(sets[i + 5]) - 1;
    set.worst = static_cast<std::size_t>(sets[i + 6]) - 1;
    answers.sets.push_back(set);
  }
  const std::vector<BestWorstScore> found = best_worst_scores(answers);
  ASSERT_EQ(found.size(), 5u);
  for (const BestWorstScore& score : found) {
    Expected expected("best-worst/" + std::to_string(score.stimulus));
    expected.is("shown", score.shown);
    expected.is("best", score.best);
    expected.is("worst", score.worst);
    expected.is("score", score.score());
    expected.is("low", score.ends.low);
    expected.is("high", score.ends.high);
  }
}

TEST(ReferenceResults, HaveTheSensitivitiesOfR) {
  AnswerSet answers;
  answers.form = &yes_no_form;
  const std::vector<double> detected = sample("detected");
  for (std::size_t i = 0; i < detected.size(); i += 3)
    answers.detections.push_back({.person = static_cast<std::size_t>(detected[i]),
                                  .stimulus = detected[i + 1] == 1.0 ? 0u : 1u,
                                  .is_signal = detected[i + 1] == 1.0,
                                  .is_positive = detected[i + 2] == 1.0});
  const DetectionResults found = detection_results(answers);
  Expected expected("detected");
  expected.is("d", found.rows.at(0).sensitivity.d);
  expected.is("correct", found.rows.at(0).correct());
  expected.is("mean", found.mean_d);
  expected.is("low", found.mean_ends.low);
  expected.is("high", found.mean_ends.high);
}

}  // namespace
}  // namespace mien::pipeline
