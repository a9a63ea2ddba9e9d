// Two stimuli: are they the same or different?

#include <cmath>

#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

namespace {

constexpr char same_answer[] = "same";

/// Difference of observations, in their standard deviations, above which a simulated participant
/// answers "different".
constexpr double least_difference = 1.5;

std::vector<std::string> same_or_different(const Question&) {
  return {same_answer, different_answer};
}

std::string same_different_fault(const Question& question, const ItemResponse& response) {
  return choice_fault(response, same_or_different(question));
}

void complete_same_different(const Question&, AnswerRow& row) { row.value = row.value_raw; }

std::string simulated_same_different(const Question&, const SimulatedView& view) {
  const double difference = std::abs(view.opinion(0) - view.opinion(1));
  return difference > least_difference ? different_answer : same_answer;
}

}  // namespace

constinit const TrialKind same_different_trials = {.name = same_different_form.name,
                                                   .form = &same_different_form,
                                                   .attention_answers = same_or_different,
                                                   .fault = same_different_fault,
                                                   .complete = complete_same_different,
                                                   .simulated = simulated_same_different};

}  // namespace mien::pipeline
