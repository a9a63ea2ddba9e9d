#include "pipeline/study/thresholds/track_procedure.h"

#include <algorithm>
#include <cmath>

#include "pipeline/manifest/adaptive_levels.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/thresholds/threshold_posterior.h"

namespace mien::pipeline {

namespace {

/// Expected entropies that differ by less are equal but for rounding, nats.
constexpr double entropy_rounding = 1e-9;

/// Standard deviations that differ by a smaller share are equal but for rounding.
constexpr double deviation_rounding = 1e-9;

StaircaseSettings staircase_of(const AdaptiveTrialSettings& adaptive, std::size_t levels) {
  StaircaseSettings staircase = {.positive_to_fall = adaptive.down,
                                 .negative_to_rise = adaptive.up,
                                 .step_down = static_cast<double>(adaptive.step.down),
                                 .step_up = static_cast<double>(adaptive.step.up),
                                 .most_reversals = adaptive.reversals,
                                 .most_trials = adaptive.trials};
  for (std::size_t place = 0; place < levels; ++place)
    staircase.grid.push_back(static_cast<double>(place));
  if (adaptive.start == StaircaseStart::easiest) staircase.start = staircase.grid.back();
  if (adaptive.start == StaircaseStart::middle) staircase.start = 0.5 * staircase.grid.back();
  return staircase;
}

}  // namespace

QuestGrid quest_grid(const std::vector<double>& ease, const TrialForm& form) {
  constexpr int locations = 25, widths = 7;
  constexpr double least_width = 0.05, most_width = 0.5;  // of the range of the levels
  const double range = ease.back() - ease.front();
  QuestGrid grid;
  for (int i = 0; i < locations; ++i)
    grid.location.push_back(ease.front() + range * i / (locations - 1));
  for (int i = 0; i < widths; ++i)
    grid.width.push_back(range * least_width *
                         std::pow(most_width / least_width, 1.0 * i / (widths - 1)));
  grid.guess = {0.0, 0.1, 0.2, 0.3, 0.4};
  if (&form == &two_interval_form) grid.guess = {0.5};
  grid.lapse = {0.0, 0.02, 0.05};
  return grid;
}

TrackProcedure track_procedure(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  const AdaptiveTrialSettings& adaptive = asked.adaptive;
  TrackProcedure procedure{.method = adaptive.method};
  for (const AdaptiveLevel& level : adaptive_levels(manifest).grid) {
    procedure.levels.push_back(level.text);
    procedure.ease.push_back(adaptive.easier == LevelDirection::rising ? level.value
                                                                       : -level.value);
  }
  if (adaptive.until)
    procedure.end =
        QuestEnd{adaptive.until->sd, threshold_proportion(adaptive), adaptive.until->at_most};
  if (adaptive.method == AdaptiveMethod::quest)
    procedure.quest = quest_grid(procedure.ease, *asked.trials);
  else
    procedure.staircase = staircase_of(adaptive, procedure.levels.size());
  return procedure;
}

std::vector<QuestAnswer> quest_answers(const std::vector<TrackAnswer>& answers) {
  std::vector<QuestAnswer> outcomes;
  for (const TrackAnswer& answer : answers)
    outcomes.push_back({answer.place, answer.is_positive ? 1 : 0});
  return outcomes;
}

std::vector<bool> staircase_answers(const std::vector<TrackAnswer>& answers) {
  std::vector<bool> positive;
  for (const TrackAnswer& answer : answers) positive.push_back(answer.is_positive);
  return positive;
}

TrackLevels::TrackLevels(const TrackProcedure& procedure)
    : staircase_(procedure.staircase), end_(procedure.end) {
  if (procedure.method != AdaptiveMethod::quest) return;
  const QuestGrid& grid = procedure.quest;
  quest_ = psychometric_quest(Sigmoid::logistic, procedure.ease, {grid.location}, {grid.width},
                              {grid.guess}, {grid.lapse});
}

StaircaseRun TrackLevels::run(const std::vector<TrackAnswer>& answers) const {
  return staircase_run(staircase_, staircase_answers(answers));
}

Eigen::VectorXd TrackLevels::entropies(const std::vector<TrackAnswer>& answers) const {
  return expected_entropies(*quest_, posterior_after(*quest_, quest_answers(answers)));
}

std::optional<std::size_t> TrackLevels::next(const std::vector<TrackAnswer>& answers) const {
  if (quest_ && end_ && has_ended(answers, end_->deviation)) return std::nullopt;
  if (quest_) return next_stimulus(*quest_, posterior_after(*quest_, quest_answers(answers)));
  const StaircaseRun found = run(answers);
  if (found.is_finished) return std::nullopt;
  return static_cast<std::size_t>(found.next_level);
}

bool TrackLevels::permits(const std::vector<TrackAnswer>& answers, std::size_t place) const {
  if (!quest_) return next(answers) == place;
  const Eigen::VectorXd expected = entropies(answers);
  const auto index = static_cast<Eigen::Index>(place);
  return index < expected.size() && expected[index] <= expected.minCoeff() + entropy_rounding;
}

bool TrackLevels::has_ended(const std::vector<TrackAnswer>& answers, double deviation) const {
  if (answers.empty()) return false;
  if (answers.size() >= static_cast<std::size_t>(end_->most_trials)) return true;
  const Eigen::VectorXd posterior = posterior_after(*quest_, quest_answers(answers));
  return threshold_posterior(*quest_, posterior, end_->proportion).deviation <= deviation;
}

bool TrackLevels::permits_end(const std::vector<TrackAnswer>& answers, bool has_ended) const {
  if (!quest_) return has_ended == !next(answers).has_value();
  if (!end_) return !has_ended;
  const double rounded = deviation_rounding * end_->deviation;
  return has_ended == this->has_ended(answers, end_->deviation + rounded) ||
         has_ended == this->has_ended(answers, end_->deviation - rounded);
}

}  // namespace mien::pipeline
