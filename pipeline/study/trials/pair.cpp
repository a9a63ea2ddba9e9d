// Paired comparison: which of two stimuli is closer to the high end of each scale.

#include <cmath>

#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

namespace {

/// Differences of opinion, as shares of the scale, below which a simulated participant sees none or
/// a slight one.
constexpr double least_seen_share = 0.1;
constexpr double least_strong_share = 0.3;

bool allows_ties(const Question& question) {
  return question.scale != nullptr && question.scale->ties;
}

bool has_strength(const Question& question) {
  return question.scale != nullptr && question.scale->strength;
}

/// What an attention check may ask for.
std::vector<std::string> outer_sides(const Question& question) {
  if (has_strength(question)) return {"left_much", "right_much"};
  return {"left", "right"};
}

/// All raw answers, from left to right.
std::vector<std::string> sides(const Question& question) {
  std::vector<std::string> all = outer_sides(question);
  if (has_strength(question)) all = {"left_much", "left_slightly", "right_slightly", "right_much"};
  if (allows_ties(question))
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), tie_value);
  return all;
}

std::string side_fault(const Question& question, const ItemResponse& response) {
  return choice_fault(response, sides(question));
}

void complete_side(const Question&, AnswerRow& row) {
  if (row.value_raw == tie_value)
    row.value = tie_value;
  else
    row.value = row.value_raw.starts_with("left") ? row.stimulus : row.against;
}

std::string simulated_side(const Question& question, const SimulatedView& view) {
  const double difference = view.opinion(0) - view.opinion(1);
  const double range =
      question.scale == nullptr ? 1.0 : question.scale->most - question.scale->least;
  const double share = std::abs(difference) / range;
  if (allows_ties(question) && share < least_seen_share) return tie_value;
  const std::string side = difference > 0.0 ? "left" : "right";
  if (!has_strength(question)) return side;
  return side + (share < least_strong_share ? "_slightly" : "_much");
}

}  // namespace

constinit const TrialKind pair_trials = {.name = pair_form.name,
                                         .form = &pair_form,
                                         .attention_answers = outer_sides,
                                         .fault = side_fault,
                                         .complete = complete_side,
                                         .simulated = simulated_side};

}  // namespace mien::pipeline
