#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/study/questionnaire/service/matching_record.h"
#include "pipeline/study/questionnaire/session_plan.h"
#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

/// A question about the participant.
struct AskedQuestion {
  std::string id;
  bool is_number = false;
  std::vector<std::string> choices;  ///< one of these; empty: a text, or a number
  bool required = false;
};

/// What must be known of a questionnaire, beside its plans, to understand what is given in it.
struct AskedFacts {
  std::string design;  ///< hash
  bool simulated = false;
  AskedScales scales;
  std::vector<std::string> choices;  ///< of emotion trials: ids
  std::vector<AskedQuestion> questions;
  std::map<std::string, std::string> sha256;  ///< of the media, by stimulus
  std::optional<MatchingFacts> matching;      ///< of a matching experiment
};

/// An item of a trial, asked or answered.
Question question_of(const AskedFacts& facts, const SessionPlan& plan, const Trial& trial,
                     const AskedItem& item);

/// As experiment.json tells it, of all its sessions. Throws nlohmann::json::exception when that is
/// something else.
AskedFacts asked_facts(const nlohmann::ordered_json& experiment);

/// What a page gave: of the consent, the demographics, a trial or the ending.
struct PageRecord {
  std::string name;     ///< "trial-7"
  std::string session;  ///< random name of the browser session
  std::vector<GivenResponse> responses;
  std::string comment;
  std::string started_at;  ///< ISO time by the participant's clock
  AnswerRow measured;      ///< of a row of the trial what the browser counts and times, and no more
  std::vector<std::string> media_sha256;   ///< of what was shown, then of the reference
  std::optional<MatchingRecord> matching;  ///< of a trial of matching
};

/// Throws RecordFault: members that are unknown, missing or of another kind, numbers out of any
/// sense, texts that are too long.
PageRecord read_record(const nlohmann::json& text);

/// Names of a session's records in the order in which they are given: "consent", "demographics"
/// (where something is asked), "trial-1", …, "ending".
std::vector<std::string> record_names(const SessionPlan& plan, const AskedFacts& facts);

/// One row a response of a trial, in the order of the responses. The record must have been checked
/// (record_check.h). What would break lines or end texts in a table is a space there.
std::vector<AnswerRow> rows_of(const AskedFacts& facts, const SessionPlan& plan, const Trial& trial,
                               const PageRecord& record);

}  // namespace mien::pipeline
