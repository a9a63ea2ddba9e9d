#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "pipeline/base/documents/csv.h"
#include "pipeline/study/results/gathered_answers.h"

namespace mien::pipeline {

/// What is told about the session of one participant.
struct ParticipantSummary {
  std::string participant;
  int trials = 0;  ///< practice, warm-up and checks among them
  bool is_unfinished = false;
  int answers = 0;  ///< that count
  int checks = 0;
  int passed = 0;
  bool is_excluded = false;
  double median_rt_ms = 0.0;  ///< of the answers that count; NaN where nobody measured
  int stalls = 0;
  int dropped_frames = 0;
  int blurs = 0;
  bool is_constant = false;  ///< at least three answers that count, all at one place: told, kept
};

/// Of everybody, by name.
std::vector<ParticipantSummary> participant_summaries(const Gathered& gathered,
                                                      std::vector<AnswerRow> rows);

/// What participants said about themselves, one row a person.
struct ParticipantTable {
  CsvTable table;

  bool empty() const { return table.rows.empty(); }
  /// The questions: all columns that participant_form does not name.
  std::vector<std::string> questions() const;
  /// Those whose column finished is 1, also as "participant/session" where there are sessions.
  std::set<std::string> finished() const;
};

/// Reads participants.csv. Throws Error where it has no column participant.
ParticipantTable read_participants(const std::filesystem::path& file);

/// One table of several; rows that are there again are taken once. Throws Error where their columns
/// differ.
ParticipantTable joined(const std::vector<ParticipantTable>& tables);

/// How a question was answered by those who count: numbers by their mean, words by how often.
struct DemographicSummary {
  std::string question;
  std::string answer;  ///< "mean", "standard deviation", "least", "most", or a word
  double value = 0.0;  ///< number, or how many gave it
  int people = 0;      ///< who answered
  bool is_count = false;
};

std::vector<DemographicSummary> demographics_of(const ParticipantTable& participants,
                                                const Gathered& gathered);

}  // namespace mien::pipeline
