// Ratings of one stimulus on scales: points, a slider, or free text.

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

namespace {

std::vector<std::string> attention_ratings(const Question& question) {
  const ResponseScale& scale = *question.scale;
  if (scale.words) return {"yes"};
  return {shortest(least_raw(scale)), shortest(most_raw(scale))};
}

std::string rating_fault(const Question& question, const ItemResponse& response) {
  // An attention check may have no scale; pages then show the default one.
  const ResponseScale scale = question.scale == nullptr ? ResponseScale() : *question.scale;
  if (scale.words) return response.is_number ? "an answer in words is a number" : "";
  const double least = least_raw(scale), most = most_raw(scale);
  const double raw =
      response.is_number ? std::strtod(response.value_raw.c_str(), nullptr) : std::nan("");
  if (raw >= least && raw <= most && raw == std::floor(raw)) return "";
  return fmt::format("an answer is no whole number from {} to {}", least, most);
}

void complete_rating(const Question& question, AnswerRow& row) {
  row.value = row.value_raw;
  if (question.scale == nullptr || question.scale->words) return;
  const bool flipped = question.item.flipped;
  row.pole_left = flipped ? "high" : "low";
  const double raw = std::strtod(row.value_raw.c_str(), nullptr);
  row.value = shortest(written_value_of_raw(*question.scale, raw, flipped));
}

std::string simulated_rating(const Question& question, const SimulatedView& view) {
  const ResponseScale& scale = *question.scale;
  const double opinion = view.opinion(0);
  if (scale.words)
    return (opinion - scale.least) / (scale.most - scale.least) > 0.5 ? scale.high : scale.low;
  return shortest(raw_of_value(scale, opinion, question.item.flipped));
}

}  // namespace

constinit const TrialKind rating_trials = {.name = rating_form.name,
                                           .form = &rating_form,
                                           .attention_answers = attention_ratings,
                                           .fault = rating_fault,
                                           .complete = complete_rating,
                                           .simulated = simulated_rating};

}  // namespace mien::pipeline
