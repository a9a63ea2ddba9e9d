// Detection in one stimulus: is the signal present?

#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

namespace {

/// Observation above which a simulated participant answers "yes".
constexpr double yes_criterion = 0.5;

std::vector<std::string> yes_or_no(const Question&) { return {yes_answer, "no"}; }

std::string yes_no_fault(const Question& question, const ItemResponse& response) {
  return choice_fault(response, yes_or_no(question));
}

void complete_yes_no(const Question&, AnswerRow& row) { row.value = row.value_raw; }

std::string simulated_yes_no(const Question&, const SimulatedView& view) {
  return view.opinion(0) > yes_criterion ? yes_answer : "no";
}

}  // namespace

constinit const TrialKind yes_no_trials = {.name = yes_no_form.name,
                                           .form = &yes_no_form,
                                           .attention_answers = yes_or_no,
                                           .fault = yes_no_fault,
                                           .complete = complete_yes_no,
                                           .simulated = simulated_yes_no};

}  // namespace mien::pipeline
