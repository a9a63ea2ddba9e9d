#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/study/results/answer_set.h"
#include "pipeline/study/results/best_worst_scores.h"
#include "pipeline/study/results/comparisons.h"
#include "pipeline/study/results/confusion.h"
#include "pipeline/study/results/detection_results.h"
#include "pipeline/study/results/factor_contrasts.h"
#include "pipeline/study/results/factor_effects.h"
#include "pipeline/study/results/grid_results.h"
#include "pipeline/study/results/group_comparisons.h"
#include "pipeline/study/results/pair_preferences.h"
#include "pipeline/study/results/pair_worth.h"
#include "pipeline/study/results/participant_flow.h"
#include "pipeline/study/results/participants.h"
#include "pipeline/study/results/quality_lists.h"
#include "pipeline/study/results/retest.h"
#include "pipeline/study/results/summaries.h"
#include "pipeline/study/results/threshold_results.h"
#include "pipeline/study/results/trace_results.h"
#include "pipeline/study/results/word_frequencies.h"

namespace mien::pipeline {

/// All statistics of a questionnaire's answers.
struct Results {
  AnswerSet answer_set;
  std::vector<RatingSummary> summaries;
  std::vector<Comparison> comparisons;
  std::vector<OverallComparison> overall;
  FactorEffects effects;  ///< analysis of variance by the factors of the design
  std::vector<FactorContrast> contrasts;
  std::vector<Confusion> confusions;
  std::vector<EndCorrelation> correlations;
  std::vector<Reliability> reliability;
  std::vector<PreferenceCount> preferences;
  std::vector<PairWorth> worths;
  DetectionResults detection;
  ThresholdResults thresholds;
  std::vector<BestWorstScore> best_worst;
  GridResults grid;
  TraceResults traces;
  std::vector<WordFrequency> words;
  std::vector<ParticipantSummary> participants;
  std::vector<RetestAnswer> retest_answers;  ///< including those of excluded participants
  std::vector<RetestSummary> retest_summaries;
  std::vector<RuleCount> rule_counts;  ///< empty without quality rules, like the flags
  std::vector<ListedFlag> quality_flags;
  std::vector<GroupComparison> groups;  ///< comparisons of groups by demographic answers
  std::vector<FlowStage> flow;          ///< empty if no table of participants was given
  ParticipantTable demographics;        ///< empty if no table of participants was given
};

/// Computes all statistics. `rows` are the answers as read; `demographics` may be empty.
inline Results results_of(AnswerSet answer_set, const std::vector<AnswerRow>& rows,
                          ParticipantTable demographics) {
  Results results;
  results.answer_set = std::move(answer_set);
  results.summaries = summaries_of(results.answer_set);
  results.comparisons = compare(results.answer_set);
  results.overall = compare_overall(results.answer_set);
  results.effects = factor_effects(results.answer_set, demographics);
  results.contrasts = factor_contrasts(results.answer_set);
  results.confusions = confusions_of(results.answer_set);
  results.correlations = end_correlations(results.answer_set);
  results.reliability = reliability_of(results.answer_set);
  results.preferences = preferences_of(results.answer_set);
  results.worths = worths_of(results.answer_set);
  results.detection = detection_results(results.answer_set);
  results.thresholds = threshold_results(results.answer_set);
  results.best_worst = best_worst_scores(results.answer_set);
  results.grid = grid_results(results.answer_set);
  results.traces = trace_results(results.answer_set);
  results.words = word_frequencies_of(results.answer_set);
  results.flow = participant_flow(results.answer_set, demographics);
  results.participants = participant_summaries(results.answer_set, rows);
  results.retest_answers = retest_answers_of(results.answer_set, rows);
  results.retest_summaries = retest_summaries_of(results.retest_answers);
  results.rule_counts = rule_counts(results.answer_set, rows);
  results.quality_flags = listed_flags(results.answer_set, rows);
  results.groups = compare_groups(demographics, results.answer_set);
  for (std::string& sentence : ungrouped_sentences(demographics, results.answer_set))
    results.answer_set.notes.push_back(std::move(sentence));
  results.demographics = std::move(demographics);
  return results;
}

}  // namespace mien::pipeline
