#include "pipeline/study/questionnaire/service/matching_rows.h"

#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {

namespace {

std::string number_or_nothing(const std::optional<double>& number) {
  return number ? shortest(*number) : std::string();
}

const char* flag(bool is_set) { return is_set ? "1" : "0"; }

}  // namespace

std::string matching_trials_csv(const std::vector<MatchedTrial>& trials) {
  CsvWriter table({"participant", "target", "interface", "first_guess_d", "time_s", "success",
                   "simulated", "trial", "d", "guess_s", "attempt", "session", "design", "limit_s",
                   "threshold_m"});
  for (const MatchedTrial& one : trials) {
    if (one.trial.practice) continue;
    table.row({one.participant, one.trial.stimuli.front(), one.trial.items.front().item,
               shortest(one.match.first_guess_d), shortest(one.match.time_s),
               flag(one.match.success), flag(one.simulated), std::to_string(one.trial.number),
               shortest(one.match.d), shortest(one.match.guess_s),
               std::to_string(one.match.attempt), one.session, one.design, shortest(one.limit_s),
               shortest(one.threshold_m)});
  }
  return table.text();
}

std::string matching_changes_csv(const std::vector<MatchedTrial>& trials) {
  CsvWriter table({"participant", "trial", "target", "interface", "is_practice", "attempt",
                   "time_s", "step", "action", "slider", "value", "d", "simulated"});
  for (const MatchedTrial& one : trials) {
    for (const MatchingChange& change : one.match.changes)
      table.row({one.participant, std::to_string(one.trial.number), one.trial.stimuli.front(),
                 one.trial.items.front().item, flag(one.trial.practice),
                 std::to_string(one.match.attempt), shortest(change.seconds), change.step,
                 change.action, change.slider, number_or_nothing(change.value),
                 number_or_nothing(change.d), flag(one.simulated)});
  }
  return table.text();
}

}  // namespace mien::pipeline
