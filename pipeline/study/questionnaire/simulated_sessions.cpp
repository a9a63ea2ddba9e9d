#include "pipeline/study/questionnaire/simulated_sessions.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/base/statistics/named_random.h"
#include "pipeline/manifest/asked.h"
#include "pipeline/study/questionnaire/balance.h"
#include "pipeline/study/questionnaire/raw_answer.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

namespace {

/// One participant who is not there.
class SimulatedSession {
 public:
  SimulatedSession(const Manifest& manifest, const SessionPlan& plan, const StatedTruth& truth,
                   const SimulatedPeople& people, const ScaleSet& scales)
      : manifest_(manifest),
        asked_(questionnaire_of(manifest)),
        plan_(plan),
        truth_(truth),
        people_(people),
        scales_(scales) {}

  void add_rows(std::vector<AnswerRow>& rows) const {
    for (const Trial& trial : plan_.trials) {
      for (const AskedItem& item : trial.items) rows.push_back(row_of(trial, item));
    }
  }

 private:
  AnswerRow row_of(const Trial& trial, const AskedItem& item) const {
    AnswerRow row;
    row.participant = plan_.participant;
    row.session = "simulated";
    row.trial = trial.number;
    row.block = trial.block;
    row.kind = word_of(trial_kind_words, trial.kind);
    if (!trial.stimuli.empty()) row.stimulus = trial.stimuli[0];
    row.against = trial.stimuli.size() > 1 ? trial.stimuli[1] : trial.reference;
    row.item = item.item;
    row.is_practice = trial.practice;
    row.is_warmup = trial.warm_up;
    row.is_catch = trial.is_catch;
    row.expected = trial.expected;
    row.rt_ms = std::round(1000.0 * people_.answer_seconds *
                           std::exp(0.4 * normal(plan_.seed, name("time", trial, item))));
    row.seed = plan_.seed;
    row.simulated = true;
    answer(trial, item, row);
    return row;
  }

  static std::string name(const char* what, const Trial& trial, const AskedItem& item) {
    return fmt::format("{}/{}/{}", what, trial.number, item.item);
  }

  void answer(const Trial& trial, const AskedItem& item, AnswerRow& row) const {
    const Scale* scale = find_scale(scales_, item.item);
    const bool has_poles =
        scale != nullptr && asked_.trials != TrialForm::pair && !asked_.answer.words;
    if (has_poles) row.pole_left = item.flipped ? "high" : "low";
    if (trial.kind == TrialKind::attention) return pass_or_fail(trial, item, row);
    if (trial.kind == TrialKind::pair) return choose_of_two(trial, item, row);
    if (item.item == emotion_item) return choose_emotion(trial, item, row);
    if (asked_.answer.words) return say(trial, item, *scale, row);
    const double raw = raw_of_value(*scale, asked_.answer, opinion(trial, 0, item), item.flipped);
    row.value_raw = shortest(raw);
    row.value = shortest(value_of_raw(*scale, asked_.answer, raw, item.flipped));
  }

  /// What the participant thinks of a stimulus in this trial.
  double opinion(const Trial& trial, std::size_t which, const AskedItem& item) const {
    const Scale* scale = find_scale(scales_, item.item);
    const std::string& stimulus = trial.stimuli[which];
    const auto known = truth_.find({stimulus, item.item});
    const double mean = known != truth_.end() ? known->second : 0.5 * (scale->least + scale->most);
    const double lean = people_.spread.participant * normal(plan_.seed, "lean/" + item.item);
    const double rest =
        people_.spread.residual * normal(plan_.seed, name("rest", trial, item) + "/" + stimulus);
    return mean + lean + rest;
  }

  void pass_or_fail(const Trial& trial, const AskedItem& item, AnswerRow& row) const {
    row.passed = uniform(plan_.seed, name("attention", trial, item)) < people_.attentive;
    row.value_raw = *row.passed ? trial.expected : missed(trial);
    const Scale* scale = find_scale(scales_, item.item);
    if (row.pole_left.empty() || scale == nullptr) {
      row.value = row.value_raw;
      return;
    }
    row.value =
        shortest(value_of_raw(*scale, asked_.answer, std::stod(row.value_raw), item.flipped));
  }

  /// Some other answer than the one that a check asks for.
  std::string missed(const Trial& trial) const {
    if (asked_.trials == TrialForm::pair) return trial.expected == "left" ? "right" : "left";
    if (trial.items.front().item == emotion_item)
      return plan_.choices[trial.expected == plan_.choices[0] ? 1 : 0];
    if (asked_.answer.words) return "no";
    const bool is_least = trial.expected == shortest(least_raw(asked_.answer));
    return shortest(is_least ? most_raw(asked_.answer) : least_raw(asked_.answer));
  }

  void choose_of_two(const Trial& trial, const AskedItem& item, AnswerRow& row) const {
    const bool is_left = opinion(trial, 0, item) > opinion(trial, 1, item);
    row.value_raw = is_left ? "left" : "right";
    row.value = trial.stimuli[is_left ? 0 : 1];
  }

  void choose_emotion(const Trial& trial, const AskedItem& item, AnswerRow& row) const {
    const std::string own = level_of(manifest_, trial.stimuli[0], emotion_item);
    const bool is_offered = std::ranges::find(plan_.choices, own) != plan_.choices.end();
    const bool is_seen = uniform(plan_.seed, name("seen", trial, item)) < people_.seen;
    const auto count = static_cast<double>(plan_.choices.size());
    const auto other =
        static_cast<std::size_t>(count * uniform(plan_.seed, name("chosen", trial, item)));
    row.value_raw = is_offered && is_seen ? own : plan_.choices[other];
    row.value = row.value_raw;
  }

  void say(const Trial& trial, const AskedItem& item, const Scale& scale, AnswerRow& row) const {
    const double share = share_of(scale, opinion(trial, 0, item));
    row.value_raw = share > 0.5 ? scale.high : scale.low;
    row.value = row.value_raw;
  }

  const Manifest& manifest_;
  const Questionnaire& asked_;
  const SessionPlan& plan_;
  const StatedTruth& truth_;
  const SimulatedPeople& people_;
  const ScaleSet& scales_;
};

}  // namespace

std::vector<AnswerRow> simulated_sessions(const Manifest& manifest,
                                          const std::vector<SessionPlan>& plans,
                                          const StatedTruth& truth, const SimulatedPeople& people) {
  const ScaleSet scales = asked_scales(manifest);
  // Of the study as it is planned, however many plans are answered: further participants change
  // nothing for the earlier ones.
  const std::string design = design_hash(manifest, plan_sessions(manifest));
  std::vector<AnswerRow> rows;
  for (const SessionPlan& plan : plans)
    SimulatedSession(manifest, plan, truth, people, scales).add_rows(rows);
  for (AnswerRow& row : rows) row.design = design;
  return rows;
}

std::string design_hash(const Manifest& manifest, const std::vector<SessionPlan>& plans) {
  Questionnaire asked = questionnaire_of(manifest);
  // Neither shows in a session; and a text is itself, not the file that it was read from.
  asked.pace = {};
  asked.analysis = {};
  for (TextSource* text : {&asked.consent, &asked.instructions, &asked.ending}) text->file.clear();
  asked.scales.file.clear();
  std::string all = title_of(manifest) + "\n" + written(asked, Writing{}).dump() + "\n";
  for (const Scale& scale : asked_scales(manifest).scales) {
    all +=
        fmt::format("{}|{}|{}|{}|{}|{}|{}\n", scale.id, scale.low, scale.high, scale.japanese_low,
                    scale.japanese_high, shortest(scale.least), shortest(scale.most));
  }
  for (const SessionPlan& plan : plans) all += fmt::format("{}\n", fmt::join(plan.choices, "|"));
  return hash_of(all + plans_csv(plans));
}

}  // namespace mien::pipeline
