#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "pipeline/base/documents/csv.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// Summary of a participant's session.
struct ParticipantSummary {
  std::string participant;
  int trials = 0;  ///< number of answered trials, including practice, warm-up and checks
  bool is_unfinished = false;
  /// Number of answers to analysed trials, also if the participant is excluded, without those that
  /// quality rules leave out.
  int answers = 0;
  int checks = 0;  ///< number of attention checks
  int passed = 0;  ///< number of passed checks
  bool is_excluded = false;
  double median_rt_ms = 0.0;  ///< median response time of `answers`, ms; NaN if not measured
  int stalls = 0;             ///< buffering interruptions of videos
  int dropped_frames = 0;
  int blurs = 0;  ///< tab switches during trials
  /// There are at least three `answers`, and all their raw values are equal; this is reported, but
  /// is not a reason for exclusion.
  bool is_straight_lining = false;
  int flagged_answers = 0;  ///< number of answers that quality rules flag, included or not
  std::string reasons;      ///< for which quality rules flag the participant; or empty
};

/// Summaries of all participants, sorted by name.
std::vector<ParticipantSummary> participant_summaries(const AnswerSet& answer_set,
                                                      std::vector<AnswerRow> rows);

/// Answers to the demographic questions, a row for each participant.
struct ParticipantTable {
  CsvTable table;

  bool empty() const { return table.rows.empty(); }
  /// The demographic questions (is_question_column).
  std::vector<std::string> questions() const;
  /// Participants whose column `finished` is 1, as "participant/session", or as "participant" where
  /// the table has no session.
  std::set<std::string> finished() const;
};

/// Reads participants.csv. Throws Error if it has no column participant.
ParticipantTable read_participants(const std::filesystem::path& file);

/// Merges tables, dropping duplicate rows. Throws Error if their columns differ.
ParticipantTable joined(const std::vector<ParticipantTable>& tables);

/// A row of the summary of a demographic question over included participants: a statistic of
/// the answers if they are numbers, otherwise the frequency of an answer. The last question is the
/// language of the pages, if there were several.
struct DemographicSummary {
  std::string question;
  std::string answer;     ///< "mean", "standard deviation", "least", "most", or the answer
  double value = 0.0;     ///< the statistic, or the frequency
  int people = 0;         ///< number of participants who answered
  bool is_count = false;  ///< `value` is a frequency
};

/// Rows belong to participants as in people_of_rows. A participant with several rows counts once if
/// their answers are equal, and not at all if they differ.
std::vector<DemographicSummary> demographics_of(const ParticipantTable& participants,
                                                const AnswerSet& answer_set);

}  // namespace mien::pipeline
