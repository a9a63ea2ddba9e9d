#include "pipeline/manifest/reported_analyses.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/manifest/adaptive_text.h"
#include "pipeline/manifest/factorial_plan.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/questionnaire_content.h"

namespace mien::pipeline {

namespace {

/// Whether the mood changes in the film of a stimulus that is rated.
bool has_changes_of_mood(const Manifest& manifest) {
  const std::vector<std::string> rated = questionnaire_stimuli(manifest);
  return std::ranges::any_of(manifest.stimuli, [&](const Stimulus& stimulus) {
    if (!stimulus.walk || std::ranges::find(rated, stimulus.id) == rated.end()) return false;
    const WalkPath& path = *stimulus.walk;
    std::vector<Mood> moods;
    const auto add = [&](const Mood& mood) {
      if (!mood.empty() && (moods.empty() || moods.back() != mood)) moods.push_back(mood);
    };
    add(path.mood);
    for (const WalkStep& step : path.script) add(step.mood);
    for (const MoodChange& change : path.moods) add(change.mood);
    return moods.size() > 1;
  });
}

void add_traces(const Manifest& manifest, const std::string& was,
                std::vector<std::string>& sentences) {
  sentences.push_back(
      fmt::format("For each film and scale, the mean trace over participants {} computed ten times "
                  "in each second, with a 95 % interval (Student) of each time alone",
                  was));
  if (has_changes_of_mood(manifest))
    sentences.push_back(fmt::format(
        "For films in which the mood changes, each participant's mean in the part of "
        "each mood {0} computed; its mean over participants, and the mean change from the "
        "part before, {0} given with a 95 % interval (Student)",
        was));
  sentences.push_back(
      fmt::format("The agreement of participants about the course of each film {} measured by "
                  "Cronbach's α and by the intraclass correlations ICC(2,1) and ICC(2,k), with "
                  "times as what is rated",
                  was));
}

/// "the factor mood", "the factors actor and mood"
std::string factors_text(const std::vector<std::string>& factors) {
  return fmt::format("the factor{} {}", factors.size() == 1 ? "" : "s",
                     fmt::join(factors, factors.size() == 2 ? " and " : ", "));
}

void add_factors(const Manifest& manifest, const std::string& were, const char* ratings,
                 std::vector<std::string>& sentences) {
  const std::vector<std::string> factors = design_factors(manifest);
  if (factors.empty()) return;
  const bool is_planned = !questionnaire_of(manifest).analysis.factorial.empty();
  if (!is_planned && factors.size() <= most_factors)
    sentences.push_back(fmt::format(
        "{} on each scale {} analysed by a repeated-measures analysis of variance with {} within "
        "participants, as far as their levels are crossed, with p values corrected by Greenhouse "
        "and Geisser's method",
        ratings, were, factors_text(factors)));
  if (is_planned || factors.size() <= most_factors)
    sentences.push_back(fmt::format(
        "Participants without an analysed rating in each cell of the design {} left out of the "
        "analysis of variance of that scale",
        were));
  sentences.push_back(
      fmt::format("All pairs of levels of {} {} compared within participants by paired t tests and "
                  "Wilcoxon signed-rank tests; the pairs of a factor on all scales {} one family",
                  factors_text(factors), were, were == "were" ? "formed" : "form"));
}

}  // namespace

std::vector<std::string> reported_analyses(const Manifest& manifest, ReportTense tense) {
  const bool is_past = tense == ReportTense::past;
  const TrialForm& form = *questionnaire_of(manifest).trials;
  std::vector<std::string> sentences;
  if (form.is_continuous) add_traces(manifest, is_past ? "was" : "is", sentences);
  if (!questionnaire_of(manifest).adaptive.empty())
    sentences = threshold_sentences(manifest, is_past ? "was" : "is");
  const bool has_ratings = !form.is_detection && !questionnaire_scales(manifest).scales.empty() &&
                           analysed_answers(manifest) == AnalysedAnswers::ratings;
  if (has_ratings)
    add_factors(manifest, is_past ? "were" : "are",
                form.is_continuous ? "The means of trials" : "Ratings", sentences);
  sentences.push_back(fmt::format("The answers of participants who {} not finish {} included",
                                  is_past ? "did" : "do", is_past ? "were" : "are"));
  return sentences;
}

}  // namespace mien::pipeline
