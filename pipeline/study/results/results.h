#pragma once

#include <utility>
#include <vector>

#include "pipeline/study/results/catch_trials.h"
#include "pipeline/study/results/comparisons.h"
#include "pipeline/study/results/confusion.h"
#include "pipeline/study/results/gathered_answers.h"
#include "pipeline/study/results/given_words.h"
#include "pipeline/study/results/group_comparisons.h"
#include "pipeline/study/results/pair_preferences.h"
#include "pipeline/study/results/participants.h"
#include "pipeline/study/results/summaries.h"

namespace mien::pipeline {

/// All statistics of a questionnaire's answers.
struct Results {
  Gathered gathered;
  std::vector<RatingSummary> summaries;
  std::vector<Comparison> comparisons;
  std::vector<OverallComparison> overall;
  std::vector<Confusion> confusions;
  std::vector<EndCorrelation> correlations;
  std::vector<Reliability> reliability;
  std::vector<PreferenceCount> preferences;
  std::vector<GivenWord> words;
  std::vector<ParticipantSummary> participants;
  std::vector<CatchAnswer> catch_answers;  ///< of all participants
  std::vector<CatchSummary> catch_summaries;
  std::vector<GroupComparison> groups;  ///< by demographic answers
  ParticipantTable demographics;        ///< empty where no table of participants was given
};

inline Results results_of(Gathered gathered, const std::vector<AnswerRow>& rows,
                          ParticipantTable demographics) {
  Results results;
  results.gathered = std::move(gathered);
  results.summaries = summaries_of(results.gathered);
  results.comparisons = compare(results.gathered);
  results.overall = compare_overall(results.gathered);
  results.confusions = confusions_of(results.gathered);
  results.correlations = end_correlations(results.gathered);
  results.reliability = reliability_of(results.gathered);
  results.preferences = preferences_of(results.gathered);
  results.words = given_words_of(results.gathered);
  results.participants = participant_summaries(results.gathered, rows);
  results.catch_answers = catch_answers_of(results.gathered, rows);
  results.catch_summaries = catch_summaries_of(results.catch_answers);
  results.groups = compare_groups(demographics, results.gathered);
  results.demographics = std::move(demographics);
  return results;
}

}  // namespace mien::pipeline
