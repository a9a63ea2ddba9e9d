#include "pipeline/study/questionnaire/service/record_check.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "pipeline/manifest/asked.h"

namespace mien::pipeline {

namespace {

constexpr char consent_refused[] = "refused";
constexpr char attention_item[] = "attention";

/// The one response that there may be to each of these items, in any order.
void check_items(const PageRecord& record, const std::vector<std::string>& items) {
  std::set<std::string> left(items.begin(), items.end());
  for (const GivenResponse& response : record.responses) {
    if (left.erase(response.item) == 0)
      throw RecordFault("an answer does not belong to this page, or appears twice");
  }
  if (!left.empty()) throw RecordFault(fmt::format("\"{}\" is not answered", *left.begin()));
}

void check_whole(const GivenResponse& response, double least, double most) {
  const double value =
      response.is_number ? std::strtod(response.value_raw.c_str(), nullptr) : std::nan("");
  if (!(value >= least && value <= most && value == std::floor(value)))
    throw RecordFault(fmt::format("an answer is not a whole number from {} to {}", least, most));
}

void check_word(const GivenResponse& response, const std::vector<std::string>& words) {
  if (response.is_number || std::ranges::find(words, response.value_raw) == words.end())
    throw RecordFault("an answer is not one of the choices");
}

void check_on_scale(const GivenResponse& response, const AskedScale& scale) {
  if (!scale.words)
    check_whole(response, scale.slider ? 0 : 1, scale.slider ? 100 : scale.points);
  else if (response.is_number)
    throw RecordFault("a free-text answer is a number");
}

/// As the other trials of the questionnaire are answered: a check looks like them.
TrialKind answered_like(const Trial& trial, const GivenResponse& response) {
  if (trial.kind != TrialKind::attention) return trial.kind;
  if (response.item == emotion_item) return TrialKind::emotion;
  const bool is_pair = trial.expected == "left" || trial.expected == "right";
  return is_pair ? TrialKind::pair : TrialKind::rating;
}

void check_response(const AskedFacts& facts, const SessionPlan& plan, const Trial& trial,
                    const GivenResponse& response) {
  switch (answered_like(trial, response)) {
    case TrialKind::emotion:
      check_word(response, plan.choices.empty() ? facts.choices : plan.choices);
      break;
    case TrialKind::pair:
      check_word(response, {"left", "right"});
      break;
    default: {
      const auto scale = facts.scales.find(response.item);
      check_on_scale(response, scale == facts.scales.end() ? AskedScale() : scale->second);
    }
  }
}

void check_media(const AskedFacts& facts, const Trial& trial, const PageRecord& record) {
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

void check_trial_record(const AskedFacts& facts, const SessionPlan& plan, const Trial& trial,
                        const PageRecord& record) {
  if (record.matching.has_value() != (trial.kind == TrialKind::matching))
    throw RecordFault("the record is of a different kind of trial");
  if (record.matching) {
    check_items(record, {});
    return check_matching_record(facts.matching.value(), trial, *record.matching);
  }
  std::vector<std::string> items;
  for (const AskedItem& item : trial.items) items.push_back(item.item);
  if (items.empty() && trial.kind == TrialKind::attention) items = {attention_item};
  check_items(record, items);
  for (const GivenResponse& response : record.responses)
    check_response(facts, plan, trial, response);
  check_media(facts, trial, record);
}

void check_demographics(const AskedFacts& facts, const PageRecord& record) {
  std::set<std::string> answered;
  for (const GivenResponse& response : record.responses) {
    const auto question = std::ranges::find(facts.questions, response.item, &AskedQuestion::id);
    if (question == facts.questions.end() || !answered.insert(response.item).second)
      throw RecordFault("an answer does not belong to this page, or appears twice");
    if (!question->choices.empty())
      check_word(response, question->choices);
    else if (response.is_number != question->is_number)
      throw RecordFault(fmt::format("\"{}\" is {}", question->id,
                                    question->is_number ? "not a number" : "a number"));
  }
  for (const AskedQuestion& question : facts.questions) {
    if (question.required && !answered.contains(question.id))
      throw RecordFault(fmt::format("\"{}\" is not answered", question.id));
  }
}

void check_consent(const PageRecord& record) {
  check_items(record, {consent_record});
  check_word(record.responses.front(), {"agreed", consent_refused});
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

void check_record(const AskedFacts& facts, const SessionPlan& plan, const PageRecord& record) {
  if (record.matching && trial_of(plan, record.name) == nullptr)
    throw RecordFault("this page has no matching trial");
  if (record.name == consent_record) {
    check_consent(record);
  } else if (record.name == demographics_record) {
    check_demographics(facts, record);
  } else if (record.name == ending_record) {
    check_items(record, {});
  } else if (const Trial* trial = trial_of(plan, record.name)) {
    check_trial_record(facts, plan, *trial, record);
  } else {
    throw RecordFault("there is no such page");
  }
}

}  // namespace mien::pipeline
