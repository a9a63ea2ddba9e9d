// Detection and same–different questionnaires of simulated participants whose d′ is known.

#include "pipeline/study/results/detection_results.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

/// Without bias, so that d′ is that of the truth.
const SimulatedParticipants unbiased_people = {
    .spread = RatingSpread{.participant = 0.0, .stimulus = 0.0, .residual = 0.4},
    .attention_pass_rate = 1.0};

Manifest detection_study(const TrialForm& form, int participants) {
  Manifest manifest = two_emotion_study(participants);
  Questionnaire& asked = *manifest.questionnaire;
  asked.trials = &form;
  asked.scales = {};
  asked.question.text = "Is she sad?";
  if (form.has_key("signal")) asked.signal.levels = {{"emotion", {"sad"}}};
  return manifest;
}

DetectionResults results_of_answers(const Manifest& manifest, const std::vector<AnswerRow>& rows) {
  return detection_results(collect_answers(manifest, rows));
}

/// The result of a stimulus or pair.
const DetectionResult& result_of(const DetectionResults& results, std::size_t stimulus,
                                 std::optional<std::size_t> other = std::nullopt) {
  for (const DetectionResult& one : results.rows)
    if (one.stimulus == stimulus && one.other == other) return one;
  throw Error("no such result", "");
}

// Stimuli in the order of the manifest: walk, acted-sad, acted-happy, sad, happy.

TEST(DetectionResults, OfYesAndNoFindTheTruth) {
  const Manifest manifest = detection_study(yes_no_form, 600);
  const StatedTruth truth = {{{"sad", "yes_no"}, 1.2}, {{"acted-sad", "yes_no"}, 2.0}};
  const auto rows = answers_to(manifest, truth, unbiased_people);
  const DetectionResults results = results_of_answers(manifest, rows);
  const DetectionResult& all = results.rows.at(0);
  EXPECT_EQ(all.counts.signal_trials, 1200);
  EXPECT_EQ(all.counts.noise_trials, 1800);
  EXPECT_NEAR(result_of(results, 3).sensitivity.d, 1.2, 0.2);
  EXPECT_NEAR(result_of(results, 1).sensitivity.d, 2.0, 0.25);
  EXPECT_EQ(result_of(results, 1).counts.noise_trials, 1800);
  // Yes above 0.5: c is 0.5 less half of d'.
  EXPECT_NEAR(result_of(results, 3).sensitivity.criterion, 0.5 - 0.6, 0.1);
  EXPECT_EQ(results.people, 600);
  EXPECT_EQ(results.rows.size(), 1U + 600U + 2U);
  EXPECT_LT(results.mean_ends.low, results.mean_d);
  EXPECT_GT(results.mean_ends.high, results.mean_d);
}

TEST(DetectionResults, OfTwoIntervalsFindTheTruth) {
  const Manifest manifest = detection_study(two_interval_form, 400);
  const StatedTruth truth = {{{"sad", "two_interval"}, 1.0}, {{"acted-sad", "two_interval"}, 1.8}};
  const DetectionResults results =
      results_of_answers(manifest, answers_to(manifest, truth, unbiased_people));
  // Two stimuli with the signal, three without.
  EXPECT_EQ(results.rows.size(), 1U + 400U + 6U);
  const DetectionResult& one = result_of(results, 0, 3);  // walk and sad
  EXPECT_EQ(one.counts.signal_trials, 200);
  EXPECT_EQ(one.counts.noise_trials, 200);
  EXPECT_NEAR(one.sensitivity.d, 1.0, 0.3);
  EXPECT_NEAR(result_of(results, 1, 4).sensitivity.d, 1.8, 0.35);
  EXPECT_NEAR(results.rows.at(0).sensitivity.criterion, 0.0, 0.06);
}

TEST(DetectionResults, OfSameAndDifferentFindTheTruth) {
  const Manifest manifest = detection_study(same_different_form, 400);
  const StatedTruth truth = {{{"sad", "same_different"}, -1.5}, {{"happy", "same_different"}, 1.5}};
  const auto rows = answers_to(manifest, truth, unbiased_people);
  const DetectionResults results = results_of_answers(manifest, rows);
  const DetectionResult& all = results.rows.at(0);
  EXPECT_EQ(all.counts.signal_trials, 4000);
  EXPECT_EQ(all.counts.noise_trials, 4000);
  EXPECT_NEAR(result_of(results, 3, 4).sensitivity.d, 3.0, 0.4);
  EXPECT_NEAR(result_of(results, 0, 4).sensitivity.d, 1.5, 0.4);
  EXPECT_LT(result_of(results, 0, 1).sensitivity.d, 0.6);
  EXPECT_EQ(result_of(results, 0, 1).sensitivity.d_ends.low, 0.0);
  EXPECT_NEAR(all.sensitivity.criterion, 1.5, 0.06);
  EXPECT_NEAR(1.0 * all.counts.false_alarms / all.counts.noise_trials, std::erfc(0.75),
              0.03);  // 2 Φ(−1.5/√2)
  // False alarms of a pair are those to its own two stimuli.
  EXPECT_EQ(result_of(results, 3, 4).counts.noise_trials, 1600);
}

TEST(DetectionResults, CountRightAnswersToBothKindsOfTrialsAlike) {
  DetectionResult result;
  result.counts = {10, 9, 40, 10};
  EXPECT_DOUBLE_EQ(result.correct(), 0.5 * (0.9 + 0.75));
  result.counts = {10, 9, 0, 0};
  EXPECT_TRUE(std::isnan(result.correct()));
}

TEST(DetectionResults, RefuseAnswersThatNoPageOffers) {
  for (const TrialForm* form : {&yes_no_form, &two_interval_form, &same_different_form}) {
    const Manifest manifest = detection_study(*form, 4);
    auto rows = answers_to(manifest);
    rows[0].value = "maybe";
    EXPECT_THROW(collect_answers(manifest, rows), Faults) << form->name;
  }
}

TEST(DetectionResults, AreNoneOfRatings) {
  const Manifest manifest = two_emotion_study(4);
  const AnswerSet answers = collect_answers(manifest, answers_to(manifest));
  EXPECT_TRUE(detection_results(answers).rows.empty());
}

}  // namespace
}  // namespace mien::pipeline
