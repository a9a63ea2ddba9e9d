#include "pipeline/manifest/adaptive_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/manifest/adaptive_levels.h"
#include "pipeline/manifest/questionnaire_content.h"

namespace mien::pipeline {

namespace {

std::string count_text(int count, const std::string& one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

/// "1 negative answer", "3 positive answers in succession"
std::string run_of_answers(int count, const char* which) {
  return count_text(count, fmt::format("{} answer", which)) + (count > 1 ? " in succession" : "");
}

/// "easiest", "middle"
std::string first_level_text(const AdaptiveTrialSettings& adaptive) {
  return std::string(word_of(staircase_start_words, adaptive.start));
}

std::string share_text(double share) { return fmt::format("{:.3g} %", 100.0 * share); }

std::string shown_pairs_text(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  const std::size_t count = adaptive_levels(manifest).references.size();
  const std::string without = count == 1 ? "the one without the signal"
                                         : fmt::format("one of {} without the signal", count);
  const std::string further = count_text(adaptive_noise_trials(asked), "further trial");
  if (asked.trials == &two_interval_form)
    return fmt::format("Each trial shows a stimulus of the level and {}, in random order", without);
  if (asked.trials == &same_different_form)
    return fmt::format(
        "Each trial of a track shows a stimulus of the level and {}, in random order; {} at random "
        "places show one without the signal twice",
        without, further);
  return fmt::format("{} at random places show {}", further,
                     count == 1 ? "the stimulus without the signal"
                                : fmt::format("one of {} stimuli without the signal", count));
}

}  // namespace

std::string levels_text(const Manifest& manifest) {
  const AdaptiveLevels levels = adaptive_levels(manifest);
  std::vector<std::string> names;
  for (const AdaptiveLevel& level : levels.grid) names.push_back(level.text);
  return fmt::format("{} levels of {} ({})", names.size(),
                     questionnaire_of(manifest).adaptive.factor, fmt::join(names, ", "));
}

std::string positive_answers_text(const TrialForm& form) {
  if (&form == &yes_no_form) return "answers “yes”";
  if (&form == &same_different_form) return "answers “different”";
  return "right answers";
}

std::string level_rule_text(const Manifest& manifest) {
  const AdaptiveTrialSettings& adaptive = questionnaire_of(manifest).adaptive;
  if (adaptive.method == AdaptiveMethod::quest)
    return fmt::format(
        "QUEST+ chooses the level whose answer is expected to tell the most about the "
        "location, the width{} and the lapse rate of a logistic psychometric function, with "
        "equal probabilities of their values before the first answer",
        questionnaire_of(manifest).trials == &two_interval_form ? "" : ", the guess rate");
  return fmt::format(
      "A staircase begins with the {} level; after {} it goes {} to a harder level, after {} {} to "
      "an easier one, and so comes to {} {}",
      first_level_text(adaptive), run_of_answers(adaptive.down, "positive"),
      count_text(adaptive.step.down, "place"), run_of_answers(adaptive.up, "negative"),
      count_text(adaptive.step.up, "place"), share_text(staircase_proportion(adaptive)),
      positive_answers_text(*questionnaire_of(manifest).trials));
}

std::string track_end_text(const AdaptiveTrialSettings& adaptive) {
  const std::string trials = count_text(most_track_trials(adaptive), "trial");
  if (adaptive.until)
    return fmt::format(
        "the first trial with a posterior standard deviation of the threshold of at most {:g}, or "
        "{}",
        adaptive.until->sd, trials);
  if (adaptive.reversals == 0) return trials;
  return fmt::format("{}, or {}", count_text(adaptive.reversals, "reversal"), trials);
}

std::vector<std::string> adaptive_sentences(const Manifest& manifest) {
  const AdaptiveTrialSettings& adaptive = questionnaire_of(manifest).adaptive;
  return {fmt::format("{}, from the hardest to the easiest.", levels_text(manifest)),
          shown_pairs_text(manifest) + ".", level_rule_text(manifest) + ".",
          fmt::format(
              "There {} with answers of {} own{}; {} after {}.",
              adaptive.tracks == 1 ? "is 1 track" : fmt::format("are {} tracks", adaptive.tracks),
              adaptive.tracks == 1 ? "its" : "their",
              adaptive.tracks == 1 ? "" : ", interleaved at random in the plans",
              adaptive.tracks == 1 ? "it ends" : "each ends", track_end_text(adaptive))};
}

std::vector<std::string> threshold_sentences(const Manifest& manifest, const std::string& was) {
  const Questionnaire& asked = questionnaire_of(manifest);
  const AdaptiveTrialSettings& adaptive = asked.adaptive;
  const std::string rates = asked.trials == &two_interval_form
                                ? "a guess rate of 0.5 and a lapse rate from 0 to 0.06"
                                : "a guess rate from 0 to 0.5, to which trials without the signal "
                                  "contribute, and a lapse "
                                  "rate from 0 to 0.06";
  std::vector<std::string> sentences = {
      fmt::format("A logistic psychometric function with {} {} fitted by maximum likelihood to the "
                  "answers of each participant and to all answers together",
                  rates, was),
      fmt::format("The threshold {} the level of {} at which the function gives {} {}", was,
                  adaptive.factor, share_text(threshold_proportion(adaptive)),
                  positive_answers_text(*asked.trials)),
      fmt::format("Intervals of thresholds and slopes (95 %) and the probability of the deviance "
                  "{} determined by the parametric bootstrap",
                  was == "is" ? "are" : "were"),
      fmt::format(
          "The mean of the participants’ thresholds {} given with a 95 % interval (Student)", was)};
  if (adaptive.method == AdaptiveMethod::staircase)
    sentences.push_back(fmt::format(
        "For each track, the mean level of the reversals after the first two {} given", was));
  else
    sentences.push_back(fmt::format(
        "For each participant, the mean of the posterior distribution of the threshold {} given "
        "with its 95 % credible interval",
        was));
  return sentences;
}

std::string adaptive_plan_text(const Manifest& manifest) {
  if (questionnaire_of(manifest).adaptive.empty()) return "";
  std::string text = "Adaptive trials.";
  for (const std::string& sentence : adaptive_sentences(manifest)) text += " " + sentence;
  return text + "\n";
}

}  // namespace mien::pipeline
