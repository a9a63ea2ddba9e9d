// Best–worst scaling: which of a set of stimuli is best, and which is worst, with respect to each
// scale. Raw answers are places from the left, from 1.

#include <cstdlib>
#include <map>

#include <fmt/format.h>

#include "pipeline/manifest/ratings/answers/best_worst_item.h"
#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

namespace {

/// Attention checks show no stimuli; they offer as many places as the smallest set.
std::vector<std::string> places(const Question& question) {
  const std::size_t shown = question.trial.stimuli.size();
  std::vector<std::string> all;
  for (std::size_t place = 1; place <= (shown == 0 ? best_worst_form.stimuli : shown); ++place)
    all.push_back(std::to_string(place));
  return all;
}

std::string place_fault(const Question& question, const ItemResponse& response) {
  return choice_fault(response, places(question));
}

void complete_place(const Question& question, AnswerRow& row) {
  const auto place = static_cast<std::size_t>(std::strtoul(row.value_raw.c_str(), nullptr, 10));
  row.value = question.trial.stimuli.at(place - 1);
}

/// The same stimulus cannot be best and worst.
std::string best_is_worst(const std::vector<ItemResponse>& responses) {
  std::map<std::string, std::string> chosen;
  for (const ItemResponse& response : responses) {
    const auto item = best_worst_item(response.item);
    if (!item) continue;
    const auto [other, is_first] = chosen.emplace(item->scale, response.value_raw);
    if (!is_first && other->second == response.value_raw)
      return fmt::format("the same stimulus is best and worst on \"{}\"", item->scale);
  }
  return "";
}

std::string simulated_place(const Question& question, const SimulatedView& view) {
  const bool is_best = best_worst_item(question.item.item).value().is_best;
  std::size_t best = 0, worst = 0;
  for (std::size_t i = 1; i < question.trial.stimuli.size(); ++i) {
    if (view.opinion(i) > view.opinion(best)) best = i;
    // Of equal ones the last, so that it is not the best.
    if (view.opinion(i) <= view.opinion(worst)) worst = i;
  }
  return std::to_string((is_best ? best : worst) + 1);
}

}  // namespace

constinit const TrialKind best_worst_trials = {.name = best_worst_form.name,
                                               .form = &best_worst_form,
                                               .attention_answers = places,
                                               .fault = place_fault,
                                               .complete = complete_place,
                                               .contradiction = best_is_worst,
                                               .simulated = simulated_place};

}  // namespace mien::pipeline
