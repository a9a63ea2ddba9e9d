// Adaptive trials: what is asked, which levels there are, and how they are chosen.

#include <string>

#include <fmt/format.h>

#include "pipeline/manifest/adaptive_levels.h"
#include "pipeline/manifest/adaptive_text.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/production/methods/methods_parts.h"
#include "pipeline/production/methods/prose.h"

namespace mien::pipeline {

std::string adaptive_task_text(const Manifest& manifest) {
  const TrialForm* form = manifest.questionnaire->trials;
  if (form == &two_interval_form)
    return "In each trial, participants saw two films one after the other, one of them with the "
           "signal, and said which one had it";
  if (form == &same_different_form)
    return "In each trial, participants saw " +
           (pair_presentation(*manifest.questionnaire) == PairPresentation::in_turn
                ? std::string("two films one after the other")
                : std::string("two films side by side")) +
           " and said whether they were the same or different";
  return "In each trial, participants saw one film and said whether the signal was present";
}

void describe_levels(MethodsText& out) {
  const Questionnaire& asked = *out.manifest.questionnaire;
  const AdaptiveTrialSettings& adaptive = asked.adaptive;
  out.say(
      fmt::format("There were {}, of which each trial showed one that depended on the "
                  "participant’s answers so far",
                  levels_text(out.manifest)));
  if (adaptive.method == AdaptiveMethod::quest)
    out.say("Levels were chosen by QUEST+" + out.cite({"watson2017"}) +
            ", for a logistic psychometric function with unknown location, width and lapse rate" +
            (asked.trials == &two_interval_form ? "" : ", and unknown guess rate"));
  else
    out.say(fmt::format(
        "Levels were chosen by a staircase ({} up, {} down; steps of {} up and {} down in places "
        "of "
        "the list of levels) that began with the {} level and converges to {:.3g} % {}{}",
        adaptive.up, adaptive.down, adaptive.step.up, adaptive.step.down,
        word_of(staircase_start_words, adaptive.start), 100.0 * staircase_proportion(adaptive),
        positive_answers_text(*asked.trials),
        out.cite(adaptive.step.up == adaptive.step.down ? Names{"levitt1971"}
                                                        : Names{"levitt1971", "kaernbach1991"})));
  out.say(fmt::format("There {} with levels of {} own; {} ended after {}",
                      adaptive.tracks == 1
                          ? std::string("was one track")
                          : fmt::format("were {} interleaved tracks", adaptive.tracks),
                      adaptive.tracks == 1 ? "its" : "their", adaptive.tracks == 1 ? "it" : "each",
                      track_end_text(adaptive)));
  if (const int noise = adaptive_noise_trials(asked); noise > 0)
    out.say(fmt::format("Among them, at random places, were {} without the signal",
                        count_of(static_cast<std::size_t>(noise), "trial", "trials")));
  out.say("Psychometric functions were fitted as described by Wichmann and Hill" +
          out.cite({"wichmann2001a", "wichmann2001b"}));
}

}  // namespace mien::pipeline
