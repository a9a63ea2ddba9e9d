// Multiple stimuli with hidden reference and anchor (MUSHRA, ITU-R BS.1534-3): each of a set of
// stimuli is rated on a slider. Raw answers are 0 … 100, which are the values, too.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/ratings/answers/grid_item.h"
#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

namespace {

constexpr double highest_rating = 100.0;

/// Attention checks ask for one slider without a stimulus.
std::vector<std::string> slider_ends(const Question&) { return {"0", shortest(highest_rating)}; }

std::string slider_fault(const Question&, const ItemResponse& response) {
  const double raw =
      response.is_number ? std::strtod(response.value_raw.c_str(), nullptr) : std::nan("");
  const bool is_valid = raw >= 0.0 && raw <= highest_rating && raw == std::floor(raw);
  return is_valid ? "" : "an answer is no whole number from 0 to 100";
}

/// The answer is about the stimulus in its place, compared with the open reference.
void complete_place_of_grid(const Question& question, AnswerRow& row) {
  const GridItem item = grid_item(question.item.item).value();
  row.item = item.scale;
  row.stimulus = question.trial.stimuli.at(item.place - 1);
  row.against = question.trial.reference;
  row.value = row.value_raw;
  row.pole_left = "low";
}

/// The hidden reference, if it is recognised, is rated as the instructions say.
std::string simulated_place_of_grid(const Question& question, const SimulatedView& view) {
  const std::size_t place = grid_item(question.item.item).value().place - 1;
  const Trial& trial = question.trial;
  if (view.is_recognised && trial.stimuli.at(place) == trial.reference)
    return shortest(highest_rating);
  return shortest(std::round(std::clamp(view.opinion(place), 0.0, highest_rating)));
}

}  // namespace

constinit const TrialKind grid_trials = {.name = grid_form.name,
                                         .form = &grid_form,
                                         .attention_answers = slider_ends,
                                         .fault = slider_fault,
                                         .complete = complete_place_of_grid,
                                         .simulated = simulated_place_of_grid};

}  // namespace mien::pipeline
