#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/adaptive_levels.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/factors.h"
#include "pipeline/manifest/questionnaire_content.h"

namespace mien::pipeline {

namespace {

/// More trials than anybody answers in a session.
constexpr int most_session_trials = 1000;

/// The probability of a right answer by guessing in two-interval trials.
constexpr double guessed_share = 0.5;

std::string questionnaire_path(std::string_view key) {
  return member_path("questionnaire", std::string(key));
}

std::string adaptive_path(std::string_view key) {
  return member_path(questionnaire_path("adaptive"), std::string(key));
}

/// Checks the adaptive trials of a questionnaire that has them.
class AdaptiveCheck {
 public:
  explicit AdaptiveCheck(const Manifest& manifest)
      : manifest_(manifest),
        asked_(*manifest.questionnaire),
        adaptive_(asked_.adaptive),
        list_(manifest.places) {}

  std::vector<Fault> faults() {
    if (!is_of_detection()) return list_.take();
    check_other_keys();
    check_method_keys();
    check_proportion();
    check_count();
    if (is_factor_known() && are_levels_numbers()) check_levels();
    return list_.take();
  }

 private:
  bool is_staircase() const { return adaptive_.method == AdaptiveMethod::staircase; }
  bool is_two_interval() const { return asked_.trials == &two_interval_form; }

  bool is_of_detection() {
    if (asked_.trials->is_detection) return true;
    list_.add_at_key(questionnaire_path("adaptive"),
                     fmt::format("{} trials are not adaptive", asked_.trials->name),
                     "add trials: two_interval, yes_no or same_different");
    return false;
  }

  void refuse(const std::string& path, const std::string& wrong, const std::string& remedy) {
    if (list_.was_given(path)) list_.add_at_key(path, wrong, remedy);
  }

  /// Keys by which other questionnaires choose and order their trials.
  void check_other_keys() {
    for (const char* key :
         {"per_participant", "pairs", "warm_up", "retest", "order", "no_repeats", "same_different"})
      refuse(questionnaire_path(key), "adaptive trials choose what is shown by the answers",
             "omit it");
    if (is_two_interval())
      refuse(adaptive_path("noise"), "each two-interval trial has one stimulus without the signal",
             "omit it");
  }

  void check_method_keys() {
    if (is_staircase())
      return refuse(adaptive_path("until"), "only QUEST+ knows how well a threshold is known",
                    "use reversals, or method: quest");
    if (adaptive_.until)
      refuse(adaptive_path("trials"), "until already states the greatest number of trials",
             "omit it");
    for (const char* key : {"up", "down", "step", "reversals", "start"})
      refuse(adaptive_path(key), fmt::format("only staircases have {}", key),
             "omit it, or use method: staircase");
  }

  void check_proportion() {
    if (is_two_interval() && adaptive_.proportion && *adaptive_.proportion <= guessed_share)
      list_.add(adaptive_path("proportion"), "half of all guesses are right", "use more than 0.5");
    // Other numbers are out of range, which the schema reports.
    const bool are_numbers_valid =
        std::min({adaptive_.up, adaptive_.down, adaptive_.step.up, adaptive_.step.down}) >= 1;
    if (is_staircase() && are_numbers_valid) check_target();
  }

  /// Guesses and lapses hide levels with very few or very many positive answers.
  void check_target() {
    constexpr double least = 0.15, most = 0.95;
    const double target = staircase_proportion(adaptive_);
    if (is_two_interval() && target <= guessed_share + 1e-9)
      list_.add(adaptive_path("down"),
                fmt::format("a staircase with up: {} and down: {} comes to {:.3g} % right answers, "
                            "and half of all guesses are right",
                            adaptive_.up, adaptive_.down, 100.0 * target),
                "use a larger number, such as down: 2");
    else if (target < least || target > most)
      list_.add(
          adaptive_path("step"),
          fmt::format("the staircase comes to {:.3g} % positive answers", 100.0 * target),
          fmt::format("choose up, down and step for {:g} to {:g} %", 100.0 * least, 100.0 * most));
  }

  void check_count() {
    const int trials = adaptive_session_trials(asked_);
    if (trials > most_session_trials)
      list_.add(adaptive_path(adaptive_.until ? "until.at_most" : "trials"),
                fmt::format("a session would have {} trials", trials),
                fmt::format("use fewer trials or tracks, at most {} in all", most_session_trials));
  }

  bool is_factor_known() {
    const std::vector<std::string> known = factors_of(manifest_);
    if (known.empty())
      list_.add(adaptive_path("factor"), "the stimuli have no factors",
                "add factors: {sadness: 0.4} to the stimuli");
    list_.check_known_name(adaptive_path("factor"), adaptive_.factor, "factor", known);
    return std::ranges::find(known, adaptive_.factor) != known.end();
  }

  /// Stimuli without the signal may be without a level in two-interval trials.
  bool are_levels_numbers() {
    const AdaptiveLevels levels = adaptive_levels(manifest_);
    for (const std::string& id : questionnaire_stimuli(manifest_)) {
      if (!std::isnan(adaptive_level_of(manifest_, id))) continue;
      const bool is_reference = std::ranges::find(levels.references, id) != levels.references.end();
      if (is_reference && is_two_interval() && !is_default_signal()) continue;
      const std::string level = level_of(manifest_, id, adaptive_.factor);
      list_.add(adaptive_path("factor"),
                level.empty()
                    ? fmt::format("{} has no level of {}", motion::in_quotes(id), adaptive_.factor)
                    : fmt::format("the level {} of {} is not a number", motion::in_quotes(level),
                                  motion::in_quotes(id)),
                fmt::format("add factors: {{{}: 0.4}} to it, or leave it out of stimuli",
                            adaptive_.factor));
      return false;
    }
    return true;
  }

  bool is_default_signal() const {
    return asked_.signal.ids.empty() && asked_.signal.levels.empty();
  }

  void check_levels() {
    const AdaptiveLevels levels = adaptive_levels(manifest_);
    const std::size_t count = levels.grid.size();
    if (count < least_adaptive_levels)
      return list_.add(
          adaptive_path("factor"),
          fmt::format("there are {} levels of {} with the signal", count, adaptive_.factor),
          fmt::format("show stimuli of at least {}{}", least_adaptive_levels,
                      is_default_signal() ? ", and of one without the signal" : ""));
    if (count > most_adaptive_levels)
      return list_.add(adaptive_path("factor"),
                       fmt::format("there are {} levels of {}", count, adaptive_.factor),
                       fmt::format("use at most {}", most_adaptive_levels));
    if (levels.references.empty())
      return list_.add(questionnaire_path("signal"), "all of the stimuli have the signal",
                       "show stimuli without the signal, too");
    check_reference_levels(levels);
    check_deviation(levels);
    check_steps(static_cast<int>(count));
  }

  /// Answers without the signal are fitted together with the others.
  void check_reference_levels(const AdaptiveLevels& levels) {
    if (is_two_interval()) return;
    const bool is_rising = adaptive_.easier == LevelDirection::rising;
    const double hardest = levels.grid.front().value;
    for (const std::string& id : levels.references) {
      const double level = adaptive_level_of(manifest_, id);
      if (is_rising ? level < hardest : level > hardest) continue;
      return list_.add(adaptive_path("factor"),
                       fmt::format("{} has no signal, but its level {:g} is not {} all levels with "
                                   "the signal",
                                   motion::in_quotes(id), level, is_rising ? "below" : "above"),
                       "use trials: two_interval, or another level");
    }
  }

  /// Before the first answer, the standard deviation is more than 0.28 of the range (uniform).
  void check_deviation(const AdaptiveLevels& levels) {
    constexpr double most_share = 0.25;
    const double range = std::abs(levels.grid.back().value - levels.grid.front().value);
    if (adaptive_.until && adaptive_.until->sd > most_share * range)
      list_.add(adaptive_path("until.sd"),
                fmt::format("a threshold is known as well as that before the first answer: levels "
                            "are from {:g} to {:g}",
                            levels.grid.front().value, levels.grid.back().value),
                fmt::format("use at most {:g}", most_share * range));
  }

  void check_steps(int levels) {
    if (std::max(adaptive_.step.up, adaptive_.step.down) >= levels)
      list_.add(adaptive_path("step"),
                fmt::format("a step is as large as the grid of {} levels", levels),
                "use smaller steps, in places of the grid");
  }

  const Manifest& manifest_;
  const Questionnaire& asked_;
  const AdaptiveTrialSettings& adaptive_;
  FaultList list_;
};

}  // namespace

std::vector<Fault> check_adaptive_trials(const Manifest& manifest) {
  if (!manifest.questionnaire || manifest.questionnaire->adaptive.empty()) return {};
  return AdaptiveCheck(manifest).faults();
}

}  // namespace mien::pipeline
