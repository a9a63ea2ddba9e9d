// Two-interval forced choice: which of two stimuli, shown one after the other, has the signal?

#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

namespace {

constexpr char first_interval[] = "first";

std::vector<std::string> intervals(const Question&) { return {first_interval, "second"}; }

std::string interval_fault(const Question& question, const ItemResponse& response) {
  return choice_fault(response, intervals(question));
}

void complete_interval(const Question&, AnswerRow& row) {
  row.value = row.value_raw == first_interval ? row.stimulus : row.against;
}

std::string simulated_interval(const Question&, const SimulatedView& view) {
  return view.opinion(0) > view.opinion(1) ? first_interval : "second";
}

}  // namespace

constinit const TrialKind two_interval_trials = {.name = two_interval_form.name,
                                                 .form = &two_interval_form,
                                                 .attention_answers = intervals,
                                                 .fault = interval_fault,
                                                 .complete = complete_interval,
                                                 .simulated = simulated_interval};

}  // namespace mien::pipeline
