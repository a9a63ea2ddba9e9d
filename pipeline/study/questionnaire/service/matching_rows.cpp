#include "pipeline/study/questionnaire/service/matching_rows.h"

#include <algorithm>
#include <iterator>

namespace mien::pipeline {

namespace {

struct MatchedChange {
  const MatchedTrial& of;
  const MatchingChange& change;
};

constexpr auto trials_columns = table_of<MatchedTrial>(
    "trials.csv", "trial, practice trials omitted",
    {{"participant", "", "participant id: position in the design, not a name",
      [](auto& r) { return r.participant; }},
     {"target", "", "id of the target", [](auto& r) { return r.trial.stimuli.front(); }},
     {"interface", "", "adjectives, features, weights …",
      [](auto& r) { return r.trial.items.front().item; }},
     {"first_guess_d", "m", "D of the first guess, made without feedback",
      [](auto& r) { return r.match.first_guess_d; }},
     {"time_s", "s", "time from the first guess to the match; without a match, the time limit",
      [](auto& r) { return r.match.time_s; }},
     {"success", "0/1", "1: matched within the limit", [](auto& r) { return r.match.success; }},
     {"simulated", "0/1", "1: simulated trial", [](auto& r) { return r.simulated; }},
     {"trial", "", "number of the trial, from 1", [](auto& r) { return r.trial.number; }},
     {"d", "m", "D of the last setting", [](auto& r) { return r.match.d; }},
     {"guess_s", "s", "time from the start of the trial to the first guess",
      [](auto& r) { return r.match.guess_s; }},
     {"attempt", "", "attempt at the trial, from 1; above 1 after a reload",
      [](auto& r) { return r.match.attempt; }},
     {"session", "", "random id of the browser session", [](auto& r) { return r.session; }},
     {"design", "", "hash of the experiment", [](auto& r) { return r.design; }},
     {"limit_s", "s", "time limit for a match, from the first guess",
      [](auto& r) { return r.limit_s; }},
     {"threshold_m", "m", "D below which motions match", [](auto& r) { return r.threshold_m; }}});

constexpr auto changes_columns = table_of<MatchedChange>(
    "changes.csv", "change of a setting, practice included",
    {{"participant", "", "participant id: position in the design, not a name",
      [](auto& r) { return r.of.participant; }},
     {"trial", "", "number of the trial, from 1", [](auto& r) { return r.of.trial.number; }},
     {"target", "", "id of the target", [](auto& r) { return r.of.trial.stimuli.front(); }},
     {"interface", "", "adjectives, features, weights …",
      [](auto& r) { return r.of.trial.items.front().item; }},
     {"is_practice", "0/1", "1: practice trial", [](auto& r) { return r.of.trial.practice; }},
     {"attempt", "", "attempt at the trial, from 1", [](auto& r) { return r.of.match.attempt; }},
     {"time_s", "s", "time since the start of the trial", [](auto& r) { return r.change.seconds; }},
     {"step", "", "guess or adjust", [](auto& r) { return r.change.step; }},
     {"action", "", "move, add, remove, guess, match or limit",
      [](auto& r) { return r.change.action; }},
     {"slider", "", "the slider moved, added or removed", [](auto& r) { return r.change.slider; }},
     {"value", "", "new value of that slider", [](auto& r) { return r.change.value; }},
     {"d", "m",
      "D of the resulting motion; empty if the next change came before the motion was synthesized",
      [](auto& r) { return r.change.d; }},
     {"simulated", "0/1", "1: simulated trial", [](auto& r) { return r.of.simulated; }}});

}  // namespace

const TableForm matching_trials_form = trials_columns.form();
const TableForm matching_changes_form = changes_columns.form();

std::string matching_trials_csv(const std::vector<MatchedTrial>& trials) {
  const auto counts = [](const MatchedTrial& one) { return !one.trial.practice; };
  std::vector<MatchedTrial> counted;
  std::ranges::copy_if(trials, std::back_inserter(counted), counts);
  return trials_columns.of(counted).csv;
}

std::string matching_changes_csv(const std::vector<MatchedTrial>& trials) {
  std::vector<MatchedChange> rows;
  for (const MatchedTrial& one : trials)
    for (const MatchingChange& change : one.match.changes) rows.push_back({one, change});
  return changes_columns.of(rows).csv;
}

}  // namespace mien::pipeline
