#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "pipeline/manifest/quality_rules.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/answers/counted_answers.h"

namespace mien::pipeline {

/// A rule that an answer or a participant breaks, with the number that breaks it: "longest run of
/// equal answers 14 > 12".
struct QualityFlag {
  QualityRule rule;
  std::string reason;
};

/// The flags of the answers and participants of a questionnaire. Each rule is applied to the
/// answers as given, regardless of what other rules flag.
struct QualityFlags {
  QualityRules rules;
  std::vector<StatedRule> stated;  ///< those that are applied, the post-screening among them
  /// By participant: failed attention checks, and the rules about whole participants.
  std::map<std::string, std::vector<QualityFlag>> participants;
  /// By index of the answer's row: the rules about single answers.
  std::map<std::size_t, std::vector<QualityFlag>> answers;

  /// Whether the analysis leaves out the participant for any of the flags (is_excluding).
  bool leaves_out(const std::string& participant) const;
  /// Whether the analysis leaves out that row for flags of its own.
  bool leaves_out(std::size_t row) const;

  const std::vector<QualityFlag>& of_participant(const std::string& participant) const;
  const std::vector<QualityFlag>& of_answer(std::size_t row) const;
};

/// The reasons, separated by semicolons.
std::string reasons_text(const std::vector<QualityFlag>& flags);

/// The length of the longest run of equal successive numbers ("longstring", Johnson 2005); 0 for an
/// empty list.
int longest_run(std::span<const double> numbers);

/// The standard deviation with divisor n − 1; NaN for fewer than two numbers.
double sample_deviation(std::span<const double> numbers);

/// Applies the rules that are set, except those of attention checks and repeated participation, to
/// rows in which separate_participants has been called.
///
/// Only analysed answers (AnswerRow::counts) are considered: neither those in practice and warm-up
/// nor those to attention checks and repeated stimuli. A number that equals its bound is not
/// flagged, nor is one that was not measured.
///
/// - min_rt_ms, max_rt_ms: the response time of each answer, of any kind.
/// - max_blur_ms: the total time for which the window was left during the answer's trial; all
///   answers of the trial are flagged.
/// - max_longstring: the longest run of equal raw answers (positions from the left) on scales, in
///   the order of trials and, within a trial, of rows. Choices and words are passed over; they
///   neither end a run nor extend it.
/// - min_sd: the standard deviation (n − 1) of the same raw answers, in points or, for sliders, in
///   hundredths of the scale. Participants with fewer than two are not flagged.
QualityFlags quality_flags(const Questionnaire& questionnaire, const std::vector<AnswerRow>& rows);

/// Adds the flags of participants whom attention checks exclude.
void add_failed_attention(const std::vector<Attention>& attention, const AttentionRule& rule,
                          QualityFlags& flags);

}  // namespace mien::pipeline
