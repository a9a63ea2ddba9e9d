// Forced choice of the emotion that a stimulus shows. Additional scales are answered as in ratings.

#include <algorithm>

#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

namespace {

bool is_choice(const Question& question) { return question.item.item == emotion_form.item; }

std::vector<std::string> attention_emotions(const Question& question) {
  return is_choice(question) ? question.choices : rating_trials.attention_answers(question);
}

std::string emotion_fault(const Question& question, const ItemResponse& response) {
  return is_choice(question) ? choice_fault(response, question.choices)
                             : rating_trials.fault(question, response);
}

void complete_emotion(const Question& question, AnswerRow& row) {
  rating_trials.complete(question, row);  // a choice has no value on a scale
}

std::string simulated_emotion(const Question& question, const SimulatedView& view) {
  if (!is_choice(question)) return rating_trials.simulated(question, view);
  const std::vector<std::string>& choices = question.choices;
  const bool is_offered = std::ranges::find(choices, view.shown) != choices.end();
  if (is_offered && view.is_recognised) return view.shown;
  return choices[static_cast<std::size_t>(static_cast<double>(choices.size()) * view.chance)];
}

}  // namespace

constinit const TrialKind emotion_trials = {.name = emotion_form.name,
                                            .form = &emotion_form,
                                            .attention_answers = attention_emotions,
                                            .fault = emotion_fault,
                                            .complete = complete_emotion,
                                            .simulated = simulated_emotion};

}  // namespace mien::pipeline
