#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/study/chains/chain_plan.h"

namespace mien::pipeline {

/// The properties of an adaptive experiment against which its records are checked.
struct ChainFacts {
  ChainDesign design;
  bool across_participants = false;
  double answer_within_s = 180.0;
  int max_failed_checks = 0;  ///< a server ends the session of whoever fails more
  /// Where chains across participants start, by ChainName::key.
  std::map<std::string, std::vector<double>> starts;
  /// The steps of each session, one for each trial; with an empty word if a server assigns them.
  std::vector<std::vector<PlannedStep>> sessions;
};

/// Reads these properties from experiment.json.
ChainFacts chain_facts(const nlohmann::ordered_json& experiment);

/// The record of a step of a chain.
struct ChainRecord {
  std::string word;
  int chain = 1;              ///< from 1
  int step = 0;               ///< from 0
  int person = 0;             ///< from 0, among the people of the step
  std::vector<double> point;  ///< of the chain before the answer
  // In Gibbs sampling:
  std::size_t dimension = 0;  ///< which one was free
  GibbsSlider slider;         ///< how the slider was shown
  double value = 0.0;         ///< of that dimension, as chosen
  int moves = 0;              ///< number of times that the slider changed
  // In Markov chain Monte Carlo:
  std::vector<double> proposal;
  bool is_proposal_first = false;
  bool chose_proposal = false;
  int attempt = 1;  ///< greater than 1 if the page was reloaded and the trial restarted
};

/// Parses a record. Throws RecordFault for missing, unknown or malformed members.
ChainRecord read_chain_record(const nlohmann::json& text);

/// The record as read_chain_record reads it.
nlohmann::ordered_json chain_json(const ChainRecord& record);

/// Whether the answer to an attention check is what it asks for: the slider within 5 % of the end,
/// or the motion at the side. `expected`: of the trial.
bool passes_check(const ChainDesign& design, const std::string& expected,
                  const ChainRecord& record);

/// Throws RecordFault if a record is not of the step that the plan has for the trial (counted from
/// 1) of the session or, where a server assigns steps, of a step that the experiment does not have;
/// if the view is not the one of that step and person, if the point, the value or the proposal is
/// outside the space, or if the proposal is not the one that the view makes of the point.
void check_chain_record(const ChainFacts& facts, const SessionPlan& plan, const Trial& trial,
                        const ChainRecord& record);

}  // namespace mien::pipeline
