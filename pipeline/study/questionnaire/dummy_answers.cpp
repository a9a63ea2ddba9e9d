#include <fmt/format.h>

#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/questionnaire_grid.h"
#include "pipeline/study/questionnaire/frozen_design.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"

namespace mien::pipeline {

namespace {

SimulatedParticipants dummy_people() { return {.attention_pass_rate = 1.0}; }

}  // namespace

std::string dummy_assumptions(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  const TrialForm& form = *asked.trials;
  const SimulatedParticipants people = dummy_people();
  std::string text = "Its answers are simulated without any effect of the stimuli: ";
  if (!asked.adaptive.empty()) {
    return "Its answers are simulated: the thresholds of participants are normally distributed "
           "about the middle of the levels, with a tenth of their range as the standard deviation "
           "and as the width of the logistic psychometric functions. The report shows its form "
           "only, and says nothing about power.\n";
  }
  if (form.is_detection) {
    text += "their true sensitivity is 0 (d' = 0).";
  } else {
    constexpr double range = 100.0;
    const RatingSpread spread = usual_spread(range);
    text += fmt::format(
        "the true rating of every stimulus on every scale is the middle of the scale. Standard "
        "deviations are {:g} % of a scale's range between participants and {:g} % in the answers "
        "of one participant.",
        spread.participant, spread.residual);
  }
  if (&form == &emotion_form)
    text += fmt::format(
        " The intended emotion is chosen in {:g} % of the trials, and in the others "
        "by chance.",
        100.0 * people.recognition_rate);
  if (form.is_grid && is_stated(asked.grid.reference))
    text +=
        fmt::format(" Hidden references are recognised, and rated 100, in {:g} % of the trials.",
                    100.0 * people.reference_recognition_rate);
  if (asked.attention_every > 0) text += " All attention checks are passed.";
  return text +
         " The report shows its form only: significant results in it are due to chance, and it "
         "says nothing about power.\n";
}

std::vector<AnswerRow> dummy_answers(const Manifest& manifest,
                                     const std::vector<SessionPlan>& plans) {
  SimulatedParticipants people = dummy_people();
  if (questionnaire_of(manifest).trials->is_continuous)
    people.film_seconds = video_seconds(manifest);
  return simulated_sessions(manifest, plans, {}, people);
}

}  // namespace mien::pipeline
