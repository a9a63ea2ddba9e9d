#include "pipeline/study/questionnaire/service/record_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/manifest/ratings/answers/trace.h"
#include "pipeline/study/questionnaire/service/screening_record.h"

namespace mien::pipeline {

namespace {

constexpr char consent_refused[] = "refused";
constexpr char attention_item[] = "attention";

/// Why stimuli could not be played (page/src/questionnaire/experiment.ts).
constexpr std::array<std::string_view, 3> play_faults = {"not_loaded", "not_decoded", "stalled"};

void refuse(const std::string& fault) {
  if (!fault.empty()) throw RecordFault(fault);
}

/// Refuses a record without exactly one response to each of these items, in any order.
void check_items(const PageRecord& record, const std::vector<std::string>& items) {
  std::set<std::string> left(items.begin(), items.end());
  for (const ItemResponse& response : record.responses)
    if (left.erase(response.item) == 0)
      throw RecordFault("an answer does not belong to this page, or appears twice");
  if (!left.empty()) throw RecordFault(fmt::format("\"{}\" is not answered", *left.begin()));
}

void check_known_name(const ItemResponse& response, const std::vector<std::string>& words) {
  refuse(choice_fault(response, words));
}

void check_media(const QuestionnaireFacts& facts, const Trial& trial, const PageRecord& record) {
  if (record.media_sha256.empty()) return;
  std::vector<std::string> shown = trial.stimuli;
  if (!trial.reference.empty()) shown.push_back(trial.reference);
  bool is_same = record.media_sha256.size() <= shown.size();
  for (std::size_t at = 0; is_same && at < record.media_sha256.size(); ++at) {
    const auto hash = facts.sha256.find(shown[at]);
    is_same = record.media_sha256[at].empty() ||
              (hash != facts.sha256.end() && hash->second == record.media_sha256[at]);
  }
  if (!is_same) throw RecordFault("the media shown were not those of this trial");
}

/// A trial whose stimuli could not be played has no answers.
void check_left_out(const QuestionnaireFacts& facts, const Trial& trial, const PageRecord& record) {
  if (std::ranges::find(play_faults, record.measured.play_fault) == play_faults.end())
    throw RecordFault("\"play_fault\" is not a known fault");
  if (trial.stimuli.empty()) throw RecordFault("this trial shows nothing that could fail to play");
  check_items(record, {});
  check_media(facts, trial, record);
}

/// A trace is of the whole film.
void check_trace(const QuestionnaireFacts& facts, const Trial& trial,
                 const ItemResponse& response) {
  const auto seconds = facts.seconds.find(trial.stimuli.front());
  if (seconds == facts.seconds.end()) throw RecordFault("the duration of the film is not known");
  const std::size_t wanted = trace_samples(seconds->second);
  const auto count = static_cast<std::size_t>(std::ranges::count(response.value_raw, ' ')) + 1;
  if (count != wanted)
    throw RecordFault(fmt::format("a trace of {} samples, and its film has {}", count, wanted));
}

/// A trial of chains across participants may have no step: they may be complete before.
void check_chain_trial(const ChainFacts& facts, const SessionPlan& plan, const Trial& trial,
                       const PageRecord& record) {
  check_items(record, {});
  if (record.chain) return check_chain_record(facts, plan, trial, *record.chain);
  if (!facts.across_participants || trial.practice) throw RecordFault("the trial has no step");
}

/// Checks what a record says about the level of a trial, apart from whether it follows from earlier
/// answers (track_check.h).
void check_level_member(const QuestionnaireFacts& facts, const Trial& trial,
                        const PageRecord& record) {
  const bool is_adaptive = trial.is_adaptive() && facts.tracks;
  if (record.is_track_ended && !is_adaptive) throw RecordFault("this trial belongs to no track");
  if (record.level.has_value() != (is_adaptive && !record.is_track_ended))
    throw RecordFault(is_adaptive ? "the level of an adaptive trial is missing, or not expected"
                                  : "this trial has no levels");
  if (record.level && *record.level >= static_cast<int>(facts.tracks->levels.size()))
    throw RecordFault(fmt::format("there is no level {}", *record.level));
}

void check_trial_record(const QuestionnaireFacts& facts, const SessionPlan& plan,
                        const Trial& planned, const PageRecord& record) {
  check_level_member(facts, planned, record);
  if (record.chain && planned.kind != &chain_trials)
    throw RecordFault("the record is of a different kind of trial");
  if (record.is_track_ended) return check_items(record, {});
  const Trial trial = shown_trial(facts, planned, record);
  if (record.matching.has_value() != (trial.kind == &matching_trials))
    throw RecordFault("the record is of a different kind of trial");
  if (record.matching) {
    check_items(record, {});
    return check_matching_record(facts.matching.value(), trial, *record.matching);
  }
  if (trial.kind == &chain_trials)
    return check_chain_trial(facts.chains.value(), plan, trial, record);
  if (!record.measured.play_fault.empty()) return check_left_out(facts, trial, record);
  std::vector<TrialItem> asked = trial.items;
  if (asked.empty() && trial.is_attention_check()) asked = {{attention_item}};
  std::vector<std::string> items;
  for (const TrialItem& item : asked) items.push_back(item.item);
  check_items(record, items);
  for (const ItemResponse& response : record.responses) {
    const TrialItem& item = *std::ranges::find(asked, response.item, &TrialItem::item);
    refuse(trial.kind->fault(question_of(facts, plan, trial, item), response));
    if (trial.kind == &continuous_trials && !trial.is_attention_check())
      check_trace(facts, trial, response);
  }
  if (trial.kind->contradiction != nullptr) refuse(trial.kind->contradiction(record.responses));
  check_media(facts, trial, record);
}

/// Checks answers to questions about the participant.
void check_questions(const std::vector<DemographicQuestion>& questions, const PageRecord& record) {
  std::set<std::string> answered;
  for (const ItemResponse& response : record.responses) {
    const auto question = std::ranges::find(questions, response.item, &DemographicQuestion::id);
    if (question == questions.end() || !answered.insert(response.item).second)
      throw RecordFault("an answer does not belong to this page, or appears twice");
    if (!question->choices.empty())
      check_known_name(response, question->choices);
    else if (response.is_number != question->is_number)
      throw RecordFault(fmt::format("\"{}\" is {}", question->id,
                                    question->is_number ? "not a number" : "a number"));
  }
  for (const DemographicQuestion& question : questions)
    if (question.required && !answered.contains(question.id))
      throw RecordFault(fmt::format("\"{}\" is not answered", question.id));
}

/// A window that is too small, a slow screen, or sound that is not heard turns participants away
/// before any question.
void check_screening(const Screening& screening, const PageRecord& record) {
  const ScreeningFault fault = screening_fault(screening, record);
  const bool is_measured = fault == ScreeningFault::window || fault == ScreeningFault::refresh_hz;
  if (fault == ScreeningFault::sound) return check_questions(tone_questions_of(screening), record);
  if (!is_measured || !record.responses.empty()) check_questions(questions_of(screening), record);
}

void check_consent(const QuestionnaireFacts& facts, const PageRecord& record) {
  check_items(record, {consent_record});
  const auto shown =
      record.language.empty() ? facts.consents.begin() : facts.consents.find(record.language);
  if (shown == facts.consents.end())
    throw RecordFault("the pages of this study are not in this language");
  const bool is_known =
      record.language.empty()
          ? std::ranges::any_of(facts.consents,
                                [&](const auto& one) { return one.second == record.consent; })
          : shown->second == record.consent;
  if (record.consent && !is_known) throw RecordFault("the text of the consent was a different one");
  check_known_name(record.responses.front(), {"agreed", consent_refused});
}

void check_url_parameters(const QuestionnaireFacts& facts, const PageRecord& record) {
  const std::vector<std::string>& kept = facts.recruitment.url_parameters;
  for (const auto& [name, value] : record.url_parameters)
    if (record.name != consent_record || std::ranges::find(kept, name) == kept.end())
      throw RecordFault(
          fmt::format("this study keeps no URL parameter {}", motion::in_quotes(name)));
}

/// Tolerance between the browser's and the server's distance, metres.
constexpr double distance_slack_m = 1e-9;

void check_distance(LiveMotions& live, const Trial& trial, const SliderSetting& setting,
                    double told) {
  motion::LiveSetting sliders;
  sliders.kind = meaning_of(motion::interface_kinds, trial.items.front().item).value();
  sliders.sliders = setting.sliders;
  sliders.values = setting.values;
  double found = 0.0;
  try {
    found = live.distance(trial.stimuli.front(), sliders).mean;
  } catch (const Error& error) {
    throw RecordFault(error.what());
  }
  if (std::abs(found - told) > distance_slack_m)
    throw RecordFault("a distance does not match its slider settings");
}

}  // namespace

const Trial* trial_of(const SessionPlan& plan, const std::string& record_name) {
  const auto found = std::ranges::find_if(plan.trials, [&](const Trial& trial) {
    return fmt::format("trial-{}", trial.number) == record_name;
  });
  return found == plan.trials.end() ? nullptr : &*found;
}

bool is_refusal(const PageRecord& record) {
  return record.name == consent_record && !record.responses.empty() &&
         record.responses.front().value_raw == consent_refused;
}

void check_record(const QuestionnaireFacts& facts, const SessionPlan& plan,
                  const PageRecord& record) {
  const bool is_of_trial = record.matching || record.chain || record.level || record.is_track_ended;
  if (is_of_trial && trial_of(plan, record.name) == nullptr)
    throw RecordFault("this page has no trial");
  check_url_parameters(facts, record);
  if (!record.language.empty() && record.name != consent_record)
    throw RecordFault("only the record of consent has a language");
  if (record.consent && record.name != consent_record)
    throw RecordFault("this page has no consent text");
  if (record.name == consent_record) {
    check_consent(facts, record);
  } else if (record.name == screening_record) {
    check_screening(facts.screening, record);
  } else if (record.name == demographics_record) {
    check_questions(facts.questions, record);
  } else if (record.name == ending_record) {
    check_items(record, {});
  } else if (const Trial* trial = trial_of(plan, record.name)) {
    check_trial_record(facts, plan, *trial, record);
  } else {
    throw RecordFault("there is no such page");
  }
}

void check_distances(LiveMotions& live, const Trial& trial, const MatchingRecord& record) {
  check_distance(live, trial, record.first, record.first_guess_d);
  check_distance(live, trial, record.last, record.d);
}

}  // namespace mien::pipeline
