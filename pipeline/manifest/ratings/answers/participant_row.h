#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"

namespace mien::pipeline {

/// Who took part: what the page and the server write, and the report reads.
struct ParticipantRow {
  std::string participant;
  std::string session;
  std::string design;
  std::string consented_at;
  bool has_finished = false;
  std::vector<std::string> answers;  ///< to the questions about the participant
};

/// The columns in their order; the last stands for one of each question.
extern const TableForm participant_form;

/// The rows as CSV, in the order given; `questions` are their ids, as many as each has answers.
std::string to_csv(const std::vector<ParticipantRow>& rows,
                   const std::vector<std::string>& questions);

}  // namespace mien::pipeline
