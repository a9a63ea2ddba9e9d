#include "pipeline/study/trials/trial_kind.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "pipeline/manifest/questionnaire_content.h"

namespace mien::pipeline {

constinit const TrialKind matching_trials = {.name = "matching"};
constinit const TrialKind chain_trials = {.name = "chain"};

std::string_view Trial::kind_name() const {
  return is_attention_check() ? attention_kind : kind->name;
}

std::string Trial::against() const {
  if (stimuli.size() < 2) return reference;
  std::string others = stimuli[1];
  for (std::size_t i = 2; i < stimuli.size(); ++i) others += " " + stimuli[i];
  return others;
}

const TrialKind& trial_kind_of(const TrialForm& form) {
  const auto found =
      std::ranges::find(trial_kinds, &form, [](const auto* kind) { return kind->form; });
  assert(found != trial_kinds.end());
  return **found;
}

void set_trial_columns(const Trial& trial, AnswerRow& row) {
  row.trial = trial.number;
  row.block = trial.block;
  row.kind = trial.kind_name();
  if (!trial.stimuli.empty()) row.stimulus = trial.stimuli[0];
  row.against = trial.against();
  row.level = trial.level;
  if (trial.is_adaptive()) row.track = trial.adaptive.track;
  row.is_practice = trial.practice;
  row.is_warmup = trial.warm_up;
  row.is_check = trial.is_check || trial.is_attention_check();
  row.expected = trial.expected;
}

std::string choice_fault(const ItemResponse& response, const std::vector<std::string>& choices) {
  const bool is_chosen =
      !response.is_number && std::ranges::find(choices, response.value_raw) != choices.end();
  return is_chosen ? "" : "an answer is none of those that may be chosen";
}

ResponseScales response_scales_by_item(const Manifest& manifest) {
  const AnswerSettings& answer = questionnaire_of(manifest).answer;
  const PreferenceSettings& preference = questionnaire_of(manifest).preference;
  const bool is_continuous = questionnaire_of(manifest).trials->is_continuous;
  const ContinuousSettings& continuous = questionnaire_of(manifest).continuous;
  ResponseScales scales;
  for (const Scale& scale : questionnaire_scales(manifest).scales)
    scales[scale.id] = {answer.points,
                        has_sliders(questionnaire_of(manifest)),
                        answer.words,
                        scale.least,
                        scale.most,
                        scale.low,
                        scale.high,
                        preference.ties,
                        preference.strength,
                        is_continuous ? continuous.lead : 0.0,
                        is_continuous && continuous.start == TraceStart::low};
  return scales;
}

const ResponseScale* find_scale(const ResponseScales& scales, const std::string& item) {
  const auto found = scales.find(item);
  return found == scales.end() ? nullptr : &found->second;
}

double least_raw(const ResponseScale& scale) { return scale.slider ? 0.0 : 1.0; }

double most_raw(const ResponseScale& scale) { return scale.slider ? 100.0 : scale.points; }

double value_of_raw(const ResponseScale& scale, double raw, bool flipped) {
  const double from_left = (raw - least_raw(scale)) / (most_raw(scale) - least_raw(scale));
  const double share = flipped ? 1.0 - from_left : from_left;
  return scale.least + share * (scale.most - scale.least);
}

double written_value_of_raw(const ResponseScale& scale, double raw, bool flipped) {
  const std::string text = fmt::format("{:.6f}", value_of_raw(scale, raw, flipped));
  return std::strtod(text.c_str(), nullptr) + 0.0;
}

double raw_of_value(const ResponseScale& scale, double value, bool flipped) {
  const double share =
      (std::clamp(value, scale.least, scale.most) - scale.least) / (scale.most - scale.least);
  const double from_left = flipped ? 1.0 - share : share;
  return std::round(least_raw(scale) + from_left * (most_raw(scale) - least_raw(scale)));
}

}  // namespace mien::pipeline
