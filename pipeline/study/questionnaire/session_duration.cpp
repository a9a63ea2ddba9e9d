#include "pipeline/study/questionnaire/session_duration.h"

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/base/documents/utf8.h"
#include "pipeline/manifest/questionnaire_content.h"

namespace mien::pipeline {

namespace {

/// Between the two stimuli of a pair that are shown one after the other (page/…/stage.ts).
constexpr double seconds_between_pair = 0.5;

/// To read about the test of sound, hear about five tones and enter their number.
constexpr double seconds_of_sound_test = 15.0;

/// To hold a card against the screen and move its picture, and to look for the blind spot a few
/// times (page/…/display.ts, blind_spot.ts).
constexpr double seconds_of_card = 30.0;
constexpr double seconds_of_blind_spot = 60.0;

bool is_blank(char letter) { return letter == ' ' || letter == '\n' || letter == '\t'; }

/// Characters from U+3000 on are of scripts written without spaces.
bool is_wide(std::string_view word) {
  return std::ranges::any_of(word,
                             [](char byte) { return static_cast<unsigned char>(byte) >= 0xE3U; });
}

/// The duration of the films of a trial whose level is not known yet, if all levels are equally
/// probable.
double adaptive_seconds(const AdaptiveTrial& adaptive, bool is_in_turn, const auto& video) {
  double sum = 0.0;
  for (const std::vector<std::string>& shown : adaptive.by_level) {
    const double first = video(shown.front()), last = shown.size() > 1 ? video(shown.back()) : 0.0;
    sum += is_in_turn && shown.size() > 1 ? first + last + seconds_between_pair
                                          : std::max(first, last);
  }
  return sum / static_cast<double>(adaptive.by_level.size());
}

}  // namespace

double word_count(std::string_view text) {
  double words = 0.0;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = begin;
    while (end < text.size() && !is_blank(text[end])) ++end;
    const std::string_view word = text.substr(begin, end - begin);
    if (!word.empty())
      words += is_wide(word) ? 0.5 * static_cast<double>(count_characters(word)) : 1.0;
    begin = end + 1;
  }
  return words;
}

double session_seconds(const Manifest& manifest, const SessionPlan& plan,
                       const VideoSeconds& seconds) {
  const Questionnaire& questionnaire = questionnaire_of(manifest);
  const Pace& pace = questionnaire.pace;
  const auto video = [&](const std::string& stimulus) {
    const auto found = seconds.find(stimulus);
    return found == seconds.end() ? usual_video_seconds : found->second;
  };
  // Each video is played, one after the other.
  const auto all_videos = [&](const Trial& trial) {
    double all = trial.reference.empty() ? 0.0 : video(trial.reference);
    for (const std::string& stimulus : trial.stimuli) all += video(stimulus);
    return all;
  };
  const double words =
      word_count(questionnaire.consent.text) + word_count(questionnaire.instructions.text) +
      word_count(questionnaire.debriefing.text) + word_count(questionnaire.ending.text);
  double sum = 60.0 * words / pace.words_per_minute +
               pace.demographic * static_cast<double>(questionnaire.demographics.size() +
                                                      questionnaire.screening.questions.size());
  if (questionnaire.screening.sound) sum += seconds_of_sound_test;
  const DisplaySize::Kind size = questionnaire.display.size.kind;
  if (size == DisplaySize::Kind::cm || size == DisplaySize::Kind::degrees) sum += seconds_of_card;
  if (questionnaire.display.blind_spot) sum += seconds_of_blind_spot;
  for (const Trial& trial : plan.trials) {
    double longest = trial.reference.empty() ? 0.0 : video(trial.reference);
    for (const std::string& stimulus : trial.stimuli) longest = std::max(longest, video(stimulus));
    if (pair_presentation(questionnaire) == PairPresentation::in_turn && trial.stimuli.size() == 2)
      longest = video(trial.stimuli[0]) + video(trial.stimuli[1]) + seconds_between_pair;
    if (trial.is_adaptive())
      longest = adaptive_seconds(
          trial.adaptive, pair_presentation(questionnaire) == PairPresentation::in_turn, video);
    if (trial.kind->form != nullptr && trial.kind->form->is_grid) longest = all_videos(trial);
    const bool is_answered_meanwhile = trial.kind->form != nullptr &&
                                       trial.kind->form->is_continuous &&
                                       !trial.is_attention_check();
    const auto answers = is_answered_meanwhile ? 0.0 : static_cast<double>(trial.items.size());
    sum += longest + pace.answer * answers + pace.between;
    if (questionnaire.comments && !trial.is_attention_check()) sum += pace.comment;
  }
  return sum;
}

std::string duration_text(const std::vector<SessionPlan>& plans) {
  const auto [shortest, longest] =
      std::ranges::minmax_element(plans, {}, &SessionPlan::expected_seconds);
  const std::string least = fmt::format("{:.1f}", shortest->expected_seconds / 60.0);
  const std::string most = fmt::format("{:.1f}", longest->expected_seconds / 60.0);
  return least == most ? most + " min" : least + " to " + most + " min";
}

}  // namespace mien::pipeline
