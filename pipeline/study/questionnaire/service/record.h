#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/screening.h"
#include "pipeline/study/questionnaire/service/chain_record.h"
#include "pipeline/study/questionnaire/service/matching_record.h"
#include "pipeline/study/questionnaire/session_plan.h"
#include "pipeline/study/thresholds/track_procedure.h"
#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

/// A question about the participant.
struct DemographicQuestion {
  std::string id;
  bool is_number = false;
  /// Permitted answers; empty: any text or, if `is_number`, any number.
  std::vector<std::string> choices;
  bool required = false;
};

/// What is needed of a questionnaire's recruitment (recruitment.h).
struct RecruitmentFacts {
  std::vector<std::string> url_parameters;  ///< names
  bool pseudonymise = false;
  int most_failed_checks = 0;
};

/// The consent text that participants agree to.
struct ConsentText {
  std::string version;  ///< as the manifest states it; may be empty
  std::string sha256;   ///< of the text (UTF-8); empty if the study has none

  friend bool operator==(const ConsentText&, const ConsentText&) = default;
};

/// The properties of a questionnaire that are needed, in addition to its plans, to check records
/// and convert them to rows.
struct QuestionnaireFacts {
  std::string design;  ///< design_hash
  bool simulated = false;
  ResponseScales scales;
  std::vector<std::string> choices;  ///< ids of the choices in emotion trials
  /// The consent text in each language of the pages, by tag.
  std::map<std::string, ConsentText> consents;
  Screening screening;
  std::vector<DemographicQuestion> questions;
  RecruitmentFacts recruitment;
  std::map<std::string, std::string> sha256;  ///< hash of the media, by stimulus
  std::map<std::string, double> seconds;      ///< duration of the media, by stimulus
  std::optional<MatchingFacts> matching;      ///< only in a matching experiment
  std::optional<ChainFacts> chains;           ///< only in an adaptive experiment
  std::optional<TrackProcedure> tracks;       ///< only with adaptive trials
};

/// Combines an item of a trial with its scale and choices.
Question question_of(const QuestionnaireFacts& facts, const SessionPlan& plan, const Trial& trial,
                     const TrialItem& item);

/// Reads these properties from experiment.json with all sessions. Throws nlohmann::json::exception
/// for JSON of another form.
QuestionnaireFacts questionnaire_facts(const nlohmann::ordered_json& experiment);

/// A record sent by a participant's page: consent, screening, demographic answers, a trial or the
/// ending.
struct PageRecord {
  std::string name;     ///< "trial-7"
  std::string session;  ///< random name of the browser session
  std::vector<ItemResponse> responses;
  std::string comment;
  std::string started_at;  ///< ISO 8601 time by the participant's clock
  /// Only the columns measured by the browser: counts, times, size of its window, refresh rate.
  AnswerRow measured;
  /// Only of consent: parameters of the participant's link, by name (or hashes of their values).
  std::map<std::string, std::string> url_parameters;
  std::optional<ConsentText> consent;      ///< only of consent: the text that was shown
  std::string language;                    ///< only of consent: that of the page; empty: unknown
  std::vector<std::string> media_sha256;   ///< hashes of the stimuli shown, then of the reference
  std::optional<MatchingRecord> matching;  ///< only for a matching trial
  /// Only for a step of a chain; without it, there was no step left for the trial.
  std::optional<ChainRecord> chain;
  std::optional<int> level;  ///< of an adaptive trial: the place of the level shown, from 0
  /// The track of an adaptive trial had ended, so that nothing was shown.
  bool is_track_ended = false;
};

/// Text as tables have it: control characters other than line breaks and tabs become spaces.
std::string table_text(std::string text);

/// Parses a record. Throws RecordFault for members that are unknown, missing or of a wrong type,
/// numbers out of range, and texts that are too long.
PageRecord read_record(const nlohmann::json& text);

/// Names of a session's records in order: "consent", "screening" (if there is one), "demographics"
/// (if there are demographic questions), "trial-1", …, "ending".
std::vector<std::string> record_names(const SessionPlan& plan, const QuestionnaireFacts& facts);

/// The trial as the record says that it was shown: of an adaptive trial at a level, otherwise as
/// planned.
Trial shown_trial(const QuestionnaireFacts& facts, const Trial& trial, const PageRecord& record);

/// One row for each response of a trial, in their order; of a trial that was left out since its
/// stimuli could not be played (play_fault), one for each item, without an answer. The record must
/// have been checked (record_check.h). Control characters in texts, except line breaks and tabs,
/// become spaces.
std::vector<AnswerRow> rows_of(const QuestionnaireFacts& facts, const SessionPlan& plan,
                               const Trial& trial, const PageRecord& record);

}  // namespace mien::pipeline
