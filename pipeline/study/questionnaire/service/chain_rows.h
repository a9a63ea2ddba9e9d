#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/study/questionnaire/service/chain_record.h"

namespace mien::pipeline {

/// An answer to a step of a chain, real or simulated.
struct ChainAnswer {
  std::string participant;  ///< empty if the participant has withdrawn
  std::string session;      ///< browser session; empty for simulated answers
  std::string design;       ///< design_hash
  bool simulated = false;
  std::optional<int> trial;  ///< from 1; unset if the participant has withdrawn
  bool is_practice = false;
  std::string expected;  ///< of an attention check, what it asks for (check_side_words)
  ChainRecord answer;
  std::optional<double> trial_ms;  ///< duration of the trial
  std::string started_at;          ///< by the participant's clock
};

/// The columns of steps.csv.
extern const TableForm chain_steps_form;

/// CSV with a row for each answer, practice and attention checks included.
std::string chain_steps_csv(const std::vector<ChainAnswer>& answers, const ChainDesign& design);

/// Numbers separated by single spaces, each the shortest decimal that reads back as the same one.
std::string point_text(const std::vector<double>& point);

}  // namespace mien::pipeline
