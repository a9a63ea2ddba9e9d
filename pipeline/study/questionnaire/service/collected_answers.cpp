#include "pipeline/study/questionnaire/service/collected_answers.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/answers/participant_row.h"
#include "pipeline/manifest/ratings/answers/trace_table.h"
#include "pipeline/study/questionnaire/service/chain_rows.h"
#include "pipeline/study/questionnaire/service/matching_rows.h"
#include "pipeline/study/questionnaire/service/record_check.h"
#include "pipeline/study/questionnaire/service/screening_record.h"

namespace mien::pipeline {

namespace {

/// The records of each session, in order.
std::map<int, std::vector<StoredRecord>> records_by_session(const StudySessions& sessions) {
  std::map<int, std::vector<StoredRecord>> records;
  for (StoredRecord& record : sessions.store().records())
    records[record.session].push_back(std::move(record));
  return records;
}

PageRecord parsed(const StoredRecord& stored) {
  return read_record(nlohmann::json::parse(stored.content));
}

/// Calls `take` with each record of a trial, its plan and its trial.
void for_each_trial(const StudySessions& sessions, const auto& take) {
  std::map<int, std::vector<StoredRecord>> records = records_by_session(sessions);
  for (const SessionState& state : sessions.states()) {
    const SessionPlan plan = sessions.plan_of(state.session);
    for (const StoredRecord& stored : records[state.session.index])
      if (const Trial* trial = trial_of(plan, stored.name)) take(plan, *trial, parsed(stored));
  }
}

/// The values of the kept URL parameters in their order; empty where one was not given.
std::vector<std::string> values_of(const QuestionnaireFacts& facts,
                                   const std::map<std::string, std::string>& given) {
  std::vector<std::string> values;
  for (const std::string& name : facts.recruitment.url_parameters) {
    const auto found = given.find(name);
    values.push_back(found == given.end() ? "" : found->second);
  }
  return values;
}

/// Answers to the questions of the screening, and to those about the participant.
std::vector<ItemResponse> answers_about_participant(const std::vector<StoredRecord>& records) {
  std::vector<ItemResponse> answers;
  for (const StoredRecord& stored : records)
    if (stored.name == screening_record || stored.name == demographics_record)
      std::ranges::move(parsed(stored).responses, std::back_inserter(answers));
  return answers;
}

/// The consent text that was shown; null if its language is unknown and there are several.
const ConsentText* consent_text(const QuestionnaireFacts& facts, const PageRecord& consent) {
  const auto shown = facts.consents.find(consent.language);
  if (shown != facts.consents.end()) return &shown->second;
  if (facts.consents.size() == 1) return &facts.consents.begin()->second;
  return consent.consent ? &*consent.consent : nullptr;
}

/// The row of a session, without answers.
ParticipantRow participant_row(const QuestionnaireFacts& facts, const SessionState& state,
                               const PageRecord& consent) {
  ParticipantRow row = {.participant = state.session.participant,
                        .session = consent.session,
                        .design = facts.design,
                        .has_finished = state.has_finished(),
                        .language = consent.language};
  if (const ConsentText* text = consent_text(facts, consent)) {
    row.consent_version = text->version;
    row.consent_sha256 = text->sha256;
  }
  if (row.has_finished) row.ended = word_of(session_end_words, SessionEnd::completed);
  if (state.ended) row.ended = word_of(session_end_words, *state.ended);
  if (state.ended == SessionEnd::screened_out)
    row.screening_fault = word_of(screening_fault_words, state.screening_fault);
  return row;
}

struct ParticipantLink {
  const std::string& base;
  const SessionState& of;
};

constexpr auto link_columns =
    table_of<ParticipantLink>("links.csv", "participant",
                              {{"participant", "", "the place in the design",
                                [](auto& r) { return r.of.session.participant; }},
                               {"link", "", "the address that the participant opens",
                                [](auto& r) { return r.base + "/s/" + r.of.session.link + "/"; }}});

std::vector<MatchedTrial> matched_trials(const ServedStudy& study, const StudySessions& sessions) {
  std::vector<MatchedTrial> trials;
  if (!study.facts.matching) return trials;
  for_each_trial(sessions, [&](const SessionPlan& plan, const Trial& trial, PageRecord record) {
    if (!record.matching) return;
    trials.push_back({.participant = plan.participant,
                      .session = record.session,
                      .design = study.facts.design,
                      .trial = trial,
                      .match = std::move(*record.matching),
                      .limit_s = study.facts.matching->limit_s,
                      .threshold_m = study.facts.matching->threshold_m});
  });
  return trials;
}

/// Answers to steps whose participants have withdrawn.
void add_withdrawn_steps(const ServedStudy& study, const std::vector<StoredStep>& steps,
                         std::vector<ChainAnswer>& answers) {
  for (const StoredStep& step : steps)
    if (!step.session)
      answers.push_back({.design = study.facts.design,
                         .answer = read_chain_record(nlohmann::json::parse(step.content))});
}

/// Answers to steps of chains across participants: chain, step, person and participant.
using CountedSteps = std::set<std::tuple<std::string, int, int, std::string>>;

CountedSteps counted_steps(const StudySessions& sessions, const std::vector<StoredStep>& steps) {
  const std::vector<SessionState> states = sessions.states();
  CountedSteps counted;
  for (const StoredStep& step : steps)
    if (step.session)
      counted.emplace(step.chain, step.step, step.person,
                      states.at(static_cast<std::size_t>(*step.session)).session.participant);
  return counted;
}

}  // namespace

std::string steps_csv(const ServedStudy& study, const StudySessions& sessions) {
  std::vector<ChainAnswer> answers;
  // Before the records, so that each answer comes with those that led to it. Answers that no longer
  // count, since their participant failed attention checks, are not among them.
  const std::vector<StoredStep> steps = sessions.store().steps();
  const CountedSteps counted = counted_steps(sessions, steps);
  for_each_trial(sessions, [&](const SessionPlan& plan, const Trial& trial, PageRecord record) {
    if (!record.chain) return;
    const ChainRecord& made = *record.chain;
    const bool is_shared =
        study.facts.chains->across_participants && !trial.practice && !trial.is_attention_check();
    if (is_shared && !counted.contains({ChainName{made.word, made.chain, ""}.key(), made.step,
                                        made.person, plan.participant}))
      return;
    answers.push_back({.participant = plan.participant,
                       .session = record.session,
                       .design = study.facts.design,
                       .trial = trial.number,
                       .is_practice = trial.practice,
                       .expected = trial.expected,
                       .answer = std::move(*record.chain),
                       .trial_ms = record.measured.trial_ms,
                       .started_at = table_text(record.started_at)});
  });
  add_withdrawn_steps(study, steps, answers);
  return chain_steps_csv(answers, study.facts.chains->design);
}

std::string trials_csv(const ServedStudy& study, const StudySessions& sessions) {
  return matching_trials_csv(matched_trials(study, sessions));
}

std::string changes_csv(const ServedStudy& study, const StudySessions& sessions) {
  return matching_changes_csv(matched_trials(study, sessions));
}

std::string traces_csv(const ServedStudy& study, const StudySessions& sessions) {
  std::vector<AnswerRow> rows;
  for_each_trial(sessions, [&](const SessionPlan& plan, const Trial& trial, PageRecord record) {
    std::ranges::move(rows_of(study.facts, plan, trial, record), std::back_inserter(rows));
  });
  return traces_csv(rows, study.facts.seconds);
}

std::string answers_csv(const ServedStudy& study, const StudySessions& sessions) {
  std::vector<AnswerRow> rows;
  std::map<std::string, std::map<std::string, std::string>> parameters;  // by participant
  for (const SessionState& state : sessions.states())
    for (const StoredRecord& stored : sessions.store().records_of(state.session.index))
      if (stored.name == consent_record)
        parameters[state.session.participant] = parsed(stored).url_parameters;
  for_each_trial(sessions, [&](const SessionPlan& plan, const Trial& trial, PageRecord record) {
    for (AnswerRow& row : rows_of(study.facts, plan, trial, record)) {
      row.url_parameters = values_of(study.facts, parameters[plan.participant]);
      rows.push_back(std::move(row));
    }
  });
  return to_csv(rows, study.facts.recruitment.url_parameters);
}

std::string participants_csv(const ServedStudy& study, const StudySessions& sessions) {
  std::vector<std::string> questions;
  for (const DemographicQuestion& question : questions_of(study.facts.screening))
    questions.push_back(question.id);
  for (const DemographicQuestion& question : study.facts.questions)
    questions.push_back(question.id);
  std::vector<std::string> columns = questions;
  for (const std::string& name : study.facts.recruitment.url_parameters)
    columns.push_back(parameter_column(name));
  std::vector<ParticipantRow> rows;
  std::map<int, std::vector<StoredRecord>> records = records_by_session(sessions);
  for (const SessionState& state : sessions.states()) {
    const std::vector<StoredRecord>& own = records[state.session.index];
    if (own.empty() || state.ended == SessionEnd::refused) continue;
    ParticipantRow row = participant_row(study.facts, state, parsed(own.front()));
    row.consented_at = own.front().stored_at;
    if (own.back().name == ending_record)
      row.closing_comment = table_text(parsed(own.back()).comment);
    const std::vector<ItemResponse> answers = answers_about_participant(own);
    for (const std::string& question : questions) {
      const auto found = std::ranges::find(answers, question, &ItemResponse::item);
      row.answers.push_back(found == answers.end() ? "" : table_text(found->value_raw));
    }
    std::ranges::move(values_of(study.facts, parsed(own.front()).url_parameters),
                      std::back_inserter(row.answers));
    rows.push_back(std::move(row));
  }
  return to_csv(rows, columns);
}

std::string answers_json(const ServedStudy& study, const StudySessions& sessions) {
  std::map<int, std::vector<StoredRecord>> records = records_by_session(sessions);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const SessionState& state : sessions.states()) {
    const auto plan = static_cast<std::size_t>(state.session.plan);
    const nlohmann::ordered_json& session = study.experiment.at("sessions").at(plan);
    nlohmann::ordered_json given = nlohmann::ordered_json::array();
    for (const StoredRecord& stored : records[state.session.index]) {
      nlohmann::ordered_json record = nlohmann::ordered_json::parse(stored.content);
      record["kept_at"] = stored.stored_at;
      given.push_back(std::move(record));
    }
    list.push_back({{"participant", state.session.participant},
                    {"seed", session.at("seed")},
                    {"came_by", state.session.entry_route},
                    {"begun_at", state.session.begun_at},
                    {"finished", state.has_finished()},
                    {"ended", state.ended ? word_of(session_end_words, *state.ended) : ""},
                    {"trials", session.at("trials")},
                    {"records", std::move(given)}});
  }
  const nlohmann::ordered_json all = {{"format", "mien-answers-1"},
                                      {"study", study.experiment.at("study")},
                                      {"design", study.facts.design},
                                      {"stimuli", study.experiment.at("stimuli")},
                                      {"sessions", std::move(list)}};
  return all.dump(1) + "\n";
}

std::string links_csv(const StudySessions& sessions, const std::string& base) {
  return link_columns.of_parts(base, sessions.states()).csv;
}

}  // namespace mien::pipeline
