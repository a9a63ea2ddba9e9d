#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/quality_rules.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/questionnaire_grid.h"

namespace mien::pipeline {

namespace {

bool is_played_by_browsers(render::VideoKind kind) {
  using render::VideoKind;
  return kind == VideoKind::mp4 || kind == VideoKind::webm || kind == VideoKind::webm_av1;
}

std::vector<Fault> attention_warnings(const Manifest& manifest) {
  const Questionnaire& asked = *manifest.questionnaire;
  if (asked.attention_every == 0) {
    FaultList none(manifest.places);
    if (none.was_given("questionnaire.attention.every"))
      none.add("questionnaire.attention.every", "0: sessions have no attention checks",
               "omit attention, or give the number of trials between two checks, such as 10");
    return none.take();
  }
  const int trials = main_trials(manifest) * static_cast<int>(scales_in_turn(manifest));
  const int checks = attention_checks(manifest);
  const int failed = asked.analysis.max_failed_checks;
  if (checks > failed) return {};
  FaultList list(manifest.places);
  const std::string path = "questionnaire.attention.every";
  if (checks == 0) {
    list.add(path, fmt::format("a session of {} trials has no attention check", trials),
             "use a smaller number, or omit it");
  } else {
    list.add(path,
             fmt::format("attention checks exclude nobody: a session of {} trials has {}, and "
                         "analysis.max_failed_checks allows {} failure{}",
                         trials, checks, failed, failed == 1 ? "" : "s"),
             "use a smaller number, or analysis: {max_failed_checks: 0}");
  }
  return list.take();
}

/// Scales with a stated range of whole numbers whose points are not those numbers.
std::vector<Fault> points_warnings(const Manifest& manifest) {
  const Questionnaire& asked = *manifest.questionnaire;
  const AnswerSettings& answer = asked.answer;
  if (!asked.trials->is_on_scale || asked.trials->is_on_slider || answer.slider || answer.words)
    return {};
  FaultList list(manifest.places);
  for (const Scale& scale : questionnaire_scales(manifest).scales) {
    const double range = scale.most - scale.least;
    const bool is_usual = scale.least == -2.0 && scale.most == 2.0;
    if (is_usual || range != std::round(range) || range + 1.0 == answer.points) continue;
    const std::string path = "questionnaire.answer.points";
    list.add(
        list.was_given(path) ? path : "questionnaire.scales",
        fmt::format("{} goes from {:g} to {:g}, but is answered with {} points, which are {:g} "
                    "apart",
                    motion::in_quotes(scale.id), scale.least, scale.most, answer.points,
                    std::round(1000.0 * range / (answer.points - 1)) / 1000.0),
        fmt::format("for one point per number, answer: {{points: {:g}}}", range + 1.0));
    return list.take();
  }
  return list.take();
}

/// Stimuli of the practice that are also in the main part because it has all stimuli.
std::vector<Fault> practice_warnings(const Manifest& manifest) {
  const Questionnaire& asked = *manifest.questionnaire;
  FaultList list(manifest.places);
  if (!asked.stimuli.ids.empty() || !asked.stimuli.levels.empty() || !asked.pairs.empty() ||
      !asked.grid.sets.empty())
    return {};
  for (std::size_t i = 0; i < asked.practice.size(); ++i)
    list.add(element_path("questionnaire.practice", i),
             fmt::format("{} is also shown in the main part and analysed there, which has all "
                         "stimuli",
                         motion::in_quotes(asked.practice[i])),
             "if it is only for practice, name those of the main part: stimuli: […]");
  return list.take();
}

/// An analysis of variance for which no participant sees every cell.
std::vector<Fault> factorial_warnings(const Manifest& manifest) {
  const Questionnaire& asked = *manifest.questionnaire;
  const FactorialPlan& plan = asked.analysis.factorial;
  if (plan.factors.empty() || analysed_answers(manifest) != AnalysedAnswers::ratings) return {};
  const std::size_t cells = largest_crossing(design_table(manifest)).cells.size();
  const auto own = static_cast<std::size_t>(rated_stimuli_of_session(manifest));
  if (own >= cells) return {};
  FaultList list(manifest.places);
  list.add("questionnaire.analysis.factors",
           fmt::format("the analysis of variance includes nobody: it needs an answer in each of "
                       "{} cells, and a participant rates {} stimuli",
                       cells, own),
           "raise per_participant, or name fewer factors");
  return list.take();
}

/// The stimuli with a sound that the questionnaire shows.
std::vector<std::string> heard_stimuli(const Manifest& manifest) {
  const std::vector<std::string> shown = shown_stimuli(manifest);
  std::vector<std::string> heard;
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (stimulus.sound && std::ranges::find(shown, stimulus.id) != shown.end())
      heard.push_back(stimulus.id);
  }
  return heard;
}

std::vector<Fault> sound_warnings(const Manifest& manifest) {
  if (manifest.questionnaire->screening.sound || heard_stimuli(manifest).empty()) return {};
  FaultList list(manifest.places);
  list.add("questionnaire", "nobody tests whether participants hear the sound of the videos",
           "add screening: {sound: true}");
  return list.take();
}

/// Where a single bad rating is more than the post-screening allows.
std::vector<Fault> post_screening_warnings(const Manifest& manifest) {
  const Questionnaire& asked = *manifest.questionnaire;
  if (!asked.trials->is_grid || !is_stated(asked.grid.reference) ||
      asked.analysis.quality.post_screening != FlaggedAnswers::excluded)
    return {};
  const int trials = analysed_trials(manifest);
  if (1.0 / trials <= post_screening_share) return {};
  FaultList list(manifest.places);
  list.add("questionnaire.analysis.quality.post_screening",
           fmt::format("a single rating of a hidden reference below {:g} excludes a participant, "
                       "because a session has {} set{}",
                       post_screening_rating, trials, trials == 1 ? "" : "s"),
           fmt::format("show at least {:.0f} sets, or omit post_screening",
                       std::ceil(1.0 / post_screening_share)));
  return list.take();
}

}  // namespace

int rated_stimuli_of_session(const Manifest& manifest) {
  if (!manifest.questionnaire->trials->is_grid) return analysed_trials(manifest);
  std::vector<int> sizes;
  for (const GridSet& set : grid_sets(manifest))
    sizes.push_back(static_cast<int>(set.stimuli.size()));
  std::ranges::sort(sizes, std::ranges::greater{});
  sizes.resize(static_cast<std::size_t>(analysed_trials(manifest)));
  return std::accumulate(sizes.begin(), sizes.end(), 0);
}

std::vector<Fault> check_shown_videos(const Manifest& manifest) {
  if (!manifest.questionnaire || manifest.questionnaire->view != ShownAs::video) return {};
  const std::vector<std::string> shown = shown_stimuli(manifest);
  const Stimulus* first = nullptr;
  int others = -1;
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (std::ranges::find(shown, stimulus.id) == shown.end()) continue;
    if (std::ranges::any_of(stimulus.output.video, is_played_by_browsers)) continue;
    if (++others == 0) first = &stimulus;
  }
  if (first == nullptr) return {};
  FaultList list(manifest.places);
  const char* of_all = "output.video";
  list.add(list.was_given(of_all) ? of_all : first->path,
           fmt::format("{}{} shown by the questionnaire without a video format that browsers play",
                       first->id, others == 0 ? " is" : fmt::format(" and {} more are", others)),
           "add mp4 or webm to output: video:");
  return list.take();
}

std::vector<Fault> check_heard_sounds(const Manifest& manifest) {
  if (!manifest.questionnaire) return {};
  const Questionnaire& asked = *manifest.questionnaire;
  FaultList list(manifest.places);
  const std::vector<std::string> heard = heard_stimuli(manifest);
  if (heard.empty()) return {};
  const auto is_heard = [&](const std::string& id) {
    return std::ranges::find(heard, id) != heard.end();
  };
  if (asked.view == ShownAs::turn) {
    list.add("questionnaire.view", "figures that are turned have no sound",
             "omit view, or show stimuli without audio");
  } else if (asked.trials->stimuli > 1 && heard.size() > 1 &&
             pair_presentation(asked) == PairPresentation::together) {
    list.add("questionnaire.preference", "two sounds would be heard at the same time",
             "show pairs one after the other: preference: {shown: in_turn}");
  } else if (!asked.reference.empty() && is_heard(asked.reference)) {
    list.add("questionnaire.reference",
             "the reference is shown beside the stimuli, and both would be heard at the same time",
             "name a reference without audio, or omit it");
  }
  return list.take();
}

std::vector<Fault> questionnaire_warnings(const Manifest& manifest) {
  if (!manifest.questionnaire) return {};
  std::vector<Fault> warnings = attention_warnings(manifest);
  append(warnings, points_warnings(manifest));
  append(warnings, quality_warnings(manifest));
  append(warnings, post_screening_warnings(manifest));
  append(warnings, sound_warnings(manifest));
  append(warnings, practice_warnings(manifest));
  append(warnings, factorial_warnings(manifest));
  return warnings;
}

}  // namespace mien::pipeline
