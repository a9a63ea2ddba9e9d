// Paired comparison: which of two stimuli is closer to the high end of each scale.

#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

namespace {

std::vector<std::string> sides(const Question&) { return {"left", "right"}; }

std::string side_fault(const Question& question, const ItemResponse& response) {
  return choice_fault(response, sides(question));
}

void complete_side(const Question&, AnswerRow& row) {
  row.value = row.value_raw == "left" ? row.stimulus : row.against;
}

std::string simulated_side(const Question&, const SimulatedView& view) {
  return view.opinion(0) > view.opinion(1) ? "left" : "right";
}

}  // namespace

constinit const TrialKind pair_trials = {.name = pair_form.name,
                                         .form = &pair_form,
                                         .attention_answers = sides,
                                         .fault = side_fault,
                                         .complete = complete_side,
                                         .simulated = simulated_side};

}  // namespace mien::pipeline
