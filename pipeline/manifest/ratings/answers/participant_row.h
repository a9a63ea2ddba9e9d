#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/documents/table.h"

namespace mien::pipeline {

/// A participant: the row written by the page and the server and read by the report.
struct ParticipantRow {
  std::string participant;
  std::string session;
  std::string design;
  std::string consented_at;
  bool has_finished = false;
  std::string ended;            ///< "completed" or "screened_out"; empty: under way or broken off
  std::string screening_fault;  ///< why the screening turned the participant away; or empty
  std::string language;         ///< of the pages (BCP 47); empty: unknown
  std::string consent_version;  ///< of the consent text; may be empty
  std::string consent_sha256;   ///< of the consent text; empty if the study has none
  std::string closing_comment;  ///< what the participant wrote on the last page; or empty
  std::vector<std::string> answers;  ///< answers to the questions about the participant
};

/// The columns in order; the last stands for one column per question.
extern const TableForm participant_form;

/// Whether a column of tables of participants may be the answer to a question about them: it is no
/// other one of participant_form, no parameter of a link (is_parameter_column), no count of tones
/// by which pages test the sound, and not `simulated`.
bool is_question_column(std::string_view name);

/// Returns the rows as CSV, in the given order. `questions` are the ids of the questions, one per
/// answer of each row.
std::string to_csv(const std::vector<ParticipantRow>& rows,
                   const std::vector<std::string>& questions);

}  // namespace mien::pipeline
