#include "pipeline/manifest/adaptive_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "motion/text/as_number.h"
#include "pipeline/base/adaptive/staircase.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/factors.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/questionnaire_pairs.h"

namespace mien::pipeline {

namespace {

/// 1 if higher levels are easier, otherwise −1.
double ease_sign(const AdaptiveTrialSettings& adaptive) {
  return adaptive.easier == LevelDirection::rising ? 1.0 : -1.0;
}

bool is_one_of(const std::string& id, const std::vector<std::string>& ids) {
  return std::ranges::find(ids, id) != ids.end();
}

/// The number of factors of the design in which two stimuli have the same level.
std::ptrdiff_t number_of_shared_levels(const Manifest& manifest, const std::string& one,
                                       const std::string& other) {
  return std::ranges::count_if(studied_factors(manifest), [&](const std::string& factor) {
    return level_of(manifest, one, factor) == level_of(manifest, other, factor);
  });
}

}  // namespace

void StaircaseStepsForm::read(const DocumentValue& given, StaircaseSteps& steps) {
  if (given.value.is_number_integer()) {
    assign(&given.value, steps.up);
    assign(&given.value, steps.down);
    return;
  }
  assign(member(given.value, "up"), steps.up);
  assign(member(given.value, "down"), steps.down);
}

OrderedJson StaircaseStepsForm::write(const StaircaseSteps& steps, const WritingOptions&) {
  if (steps.up == steps.down) return steps.up;
  return {{"up", steps.up}, {"down", steps.down}};
}

double adaptive_level_of(const Manifest& manifest, const std::string& stimulus) {
  const std::string level =
      level_of(manifest, stimulus, questionnaire_of(manifest).adaptive.factor);
  return motion::as_finite_number(level).value_or(std::numeric_limits<double>::quiet_NaN());
}

std::vector<std::string> stimuli_above_hardest_level(const Manifest& manifest) {
  const double sign = ease_sign(questionnaire_of(manifest).adaptive);
  std::vector<std::string> ids = questionnaire_stimuli(manifest);
  double hardest = std::numeric_limits<double>::infinity();
  for (const std::string& id : ids)
    if (const double level = adaptive_level_of(manifest, id); !std::isnan(level))
      hardest = std::min(hardest, sign * level);
  std::erase_if(ids, [&](const std::string& id) {
    return !(sign * adaptive_level_of(manifest, id) > hardest);
  });
  return ids;
}

AdaptiveLevels adaptive_levels(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  const std::vector<std::string> signal = signal_stimuli(manifest);
  AdaptiveLevels levels;
  for (const std::string& id : questionnaire_stimuli(manifest)) {
    if (!is_one_of(id, signal)) {
      levels.references.push_back(id);
      continue;
    }
    const double value = adaptive_level_of(manifest, id);
    if (std::isnan(value)) continue;
    auto found = std::ranges::find(levels.grid, value, &AdaptiveLevel::value);
    if (found == levels.grid.end())
      found = levels.grid.insert(found, {value, level_of(manifest, id, asked.adaptive.factor), {}});
    found->stimuli.push_back(id);
  }
  const double sign = ease_sign(asked.adaptive);
  std::ranges::sort(levels.grid, {},
                    [&](const AdaptiveLevel& level) { return sign * level.value; });
  return levels;
}

std::vector<std::string> references_of(const Manifest& manifest, const AdaptiveLevels& levels,
                                       const std::string& stimulus) {
  std::ptrdiff_t most = 0;
  for (const std::string& reference : levels.references)
    most = std::max(most, number_of_shared_levels(manifest, stimulus, reference));
  std::vector<std::string> agreeing = levels.references;
  std::erase_if(agreeing, [&](const std::string& reference) {
    return number_of_shared_levels(manifest, stimulus, reference) < most;
  });
  return agreeing;
}

double staircase_proportion(const AdaptiveTrialSettings& adaptive) {
  return staircase_target({.positive_to_fall = adaptive.down,
                           .negative_to_rise = adaptive.up,
                           .step_down = static_cast<double>(adaptive.step.down),
                           .step_up = static_cast<double>(adaptive.step.up)});
}

double threshold_proportion(const AdaptiveTrialSettings& adaptive) {
  constexpr double usual = 0.75;
  if (adaptive.proportion) return *adaptive.proportion;
  return adaptive.method == AdaptiveMethod::staircase ? staircase_proportion(adaptive) : usual;
}

int most_track_trials(const AdaptiveTrialSettings& adaptive) {
  return adaptive.until ? adaptive.until->at_most : adaptive.trials;
}

int adaptive_noise_trials(const Questionnaire& asked) {
  if (asked.trials == &two_interval_form) return 0;
  const AdaptiveTrialSettings& adaptive = asked.adaptive;
  const double track_trials = 1.0 * adaptive.tracks * most_track_trials(adaptive);
  return std::max(
      1, static_cast<int>(std::lround(adaptive.noise / (1.0 - adaptive.noise) * track_trials)));
}

int adaptive_session_trials(const Questionnaire& asked) {
  const int of_tracks = asked.adaptive.tracks * most_track_trials(asked.adaptive);
  return of_tracks + adaptive_noise_trials(asked);
}

}  // namespace mien::pipeline
