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
struct DemographicQuestion {
  std::string id;
  bool is_number = false;
  std::vector<std::string> choices;  ///< one of these; empty: a text, or a number
  bool required = false;
};

/// The properties of a questionnaire, beside its plans, by which records are checked and written as
/// rows.
struct QuestionnaireFacts {
  std::string design;  ///< hash
  bool simulated = false;
  ResponseScales scales;
  std::vector<std::string> choices;  ///< of emotion trials: ids
  std::vector<DemographicQuestion> questions;
  std::map<std::string, std::string> sha256;  ///< of the media, by stimulus
  std::optional<MatchingFacts> matching;      ///< of a matching experiment
};

/// An item of a trial with its scale and choices.
Question question_of(const QuestionnaireFacts& facts, const SessionPlan& plan, const Trial& trial,
                     const TrialItem& item);

/// Reads them from experiment.json with all sessions. Throws nlohmann::json::exception for other
/// JSON.
QuestionnaireFacts questionnaire_facts(const nlohmann::ordered_json& experiment);

/// A record sent by a participant's page: consent, demographics, a trial or the ending.
struct PageRecord {
  std::string name;     ///< "trial-7"
  std::string session;  ///< random name of the browser session
  std::vector<ItemResponse> responses;
  std::string comment;
  std::string started_at;                  ///< ISO time by the participant's clock
  AnswerRow measured;                      ///< only the columns that the browser counts or times
  std::vector<std::string> media_sha256;   ///< of the stimuli shown, then of the reference
  std::optional<MatchingRecord> matching;  ///< of a matching trial
};

/// Throws RecordFault for members that are unknown, missing or of another type, numbers out of
/// range, and texts that are too long.
PageRecord read_record(const nlohmann::json& text);

/// Names of a session's records in order: "consent", "demographics" (where there are such
/// questions), "trial-1", …, "ending".
std::vector<std::string> record_names(const SessionPlan& plan, const QuestionnaireFacts& facts);

/// One row for each response of a trial, in their order. The record must have been checked
/// (record_check.h). Control characters in texts, except line breaks and tabs, become spaces.
std::vector<AnswerRow> rows_of(const QuestionnaireFacts& facts, const SessionPlan& plan,
                               const Trial& trial, const PageRecord& record);

}  // namespace mien::pipeline
