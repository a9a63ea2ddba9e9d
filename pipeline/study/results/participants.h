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
  int trials = 0;  ///< including practice, warm-up and checks
  bool is_unfinished = false;
  int answers = 0;  ///< included in the analysis
  int checks = 0;
  int passed = 0;
  bool is_excluded = false;
  double median_rt_ms = 0.0;  ///< of included answers; NaN where not measured
  int stalls = 0;
  int dropped_frames = 0;
  int blurs = 0;
  bool is_straight_lining = false;  ///< straight-lining: at least three included answers, all
                                    ///< equal; reported, not excluded
};

/// Summaries of all participants, by name.
std::vector<ParticipantSummary> participant_summaries(const AnswerSet& answer_set,
                                                      std::vector<AnswerRow> rows);

/// Answers to the demographic questions, a row for each participant.
struct ParticipantTable {
  CsvTable table;

  bool empty() const { return table.rows.empty(); }
  /// The demographic questions: all columns that participant_form does not name.
  std::vector<std::string> questions() const;
  /// Participants whose column `finished` is 1, also as "participant/session" where there are
  /// sessions.
  std::set<std::string> finished() const;
};

/// Reads participants.csv. Throws Error where it has no column participant.
ParticipantTable read_participants(const std::filesystem::path& file);

/// Merges tables, dropping duplicate rows. Throws Error where their columns differ.
ParticipantTable joined(const std::vector<ParticipantTable>& tables);

/// A row of the summary of a demographic question over included participants: a statistic of
/// numbers, or the frequency of a word.
struct DemographicSummary {
  std::string question;
  std::string answer;  ///< "mean", "standard deviation", "least", "most", or a word
  double value = 0.0;  ///< the statistic, or the frequency
  int people = 0;      ///< who answered
  bool is_count = false;
};

std::vector<DemographicSummary> demographics_of(const ParticipantTable& participants,
                                                const AnswerSet& answer_set);

}  // namespace mien::pipeline
