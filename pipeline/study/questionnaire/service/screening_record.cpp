#include "pipeline/study/questionnaire/service/screening_record.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "motion/text/as_number.h"
#include "pipeline/base/reading/field_reader.h"

namespace mien::pipeline {

namespace {

/// Whether an answer is one of the range; every answer is one of an empty range.
bool is_within(const AnswerRange& range, const ItemResponse& answer) {
  if (range.empty()) return true;
  if (!answer.is_number) return range.contains(answer.value_raw);
  const auto number = motion::as_number<double>(answer.value_raw);
  return number && range.contains(*number);
}

const ItemResponse* answer_to(const std::string& question,
                              const std::vector<ItemResponse>& answers) {
  const auto found = std::ranges::find(answers, question, &ItemResponse::item);
  return found == answers.end() ? nullptr : &*found;
}

constexpr int tone_attempts = 2;

std::string tone_item(int attempt) { return fmt::format("tones_{}", attempt); }

bool has_counted_tones(const PageRecord& record) {
  for (int attempt = 1; attempt <= tone_attempts; ++attempt) {
    const ItemResponse* answer = answer_to(tone_item(attempt), record.responses);
    if (answer != nullptr && answer->is_number &&
        answer->value_raw == std::to_string(tone_count(record.session, attempt)))
      return true;
  }
  return false;
}

}  // namespace

Screening screening_of(const nlohmann::ordered_json& experiment) {
  Screening screening;
  const auto found = experiment.find("screening");
  if (found == experiment.end()) return screening;
  const nlohmann::json given = *found;
  const Places no_places;
  read(DocumentValue{given, "screening", ReadingContext{no_places, {}}}, screening);
  return screening;
}

nlohmann::ordered_json public_screening(const nlohmann::ordered_json& screening) {
  nlohmann::ordered_json seen = screening;
  seen.erase("quotas");
  if (const auto questions = seen.find("questions"); questions != seen.end())
    for (nlohmann::ordered_json& question : *questions) question.erase("accept");
  return seen;
}

std::vector<DemographicQuestion> tone_questions_of(const Screening& screening) {
  std::vector<DemographicQuestion> questions;
  for (int attempt = 1; screening.sound && attempt <= tone_attempts; ++attempt)
    questions.push_back({.id = tone_item(attempt), .is_number = true, .required = attempt == 1});
  return questions;
}

int tone_count(const std::string& session, int attempt) {
  std::uint32_t hash = 0x811c9dc5U;
  for (const unsigned char byte : fmt::format("{}/{}", session, attempt))
    hash = (hash ^ byte) * 0x01000193U;
  return 3 + static_cast<int>((hash >> 8U) % 5U);
}

std::vector<DemographicQuestion> questions_of(const Screening& screening) {
  std::vector<DemographicQuestion> questions = tone_questions_of(screening);
  for (const ScreeningQuestion& one : screening.questions)
    questions.push_back({.id = one.id,
                         .is_number = one.answer.is_number,
                         .choices = one.answer.choices.words,
                         .required = true});
  return questions;
}

ScreeningFault screening_fault(const Screening& screening, const PageRecord& record) {
  if (screening.window) {
    const auto& [width, height] = *screening.window;
    if (record.measured.viewport_width.value_or(0) < width ||
        record.measured.viewport_height.value_or(0) < height)
      return ScreeningFault::window;
  }
  if (screening.refresh_hz && record.measured.refresh_hz &&
      *record.measured.refresh_hz < *screening.refresh_hz)
    return ScreeningFault::refresh_hz;
  if (screening.sound && !has_counted_tones(record)) return ScreeningFault::sound;
  for (const ScreeningQuestion& question : screening.questions) {
    const ItemResponse* answer = answer_to(question.id, record.responses);
    if (answer == nullptr || !is_within(question.accept, *answer)) return ScreeningFault::answer;
  }
  return ScreeningFault::none;
}

bool counts_for(const Quota& quota, const std::vector<ItemResponse>& answers) {
  return std::ranges::all_of(quota.of, [&](const auto& wanted) {
    const ItemResponse* answer = answer_to(wanted.first, answers);
    return answer != nullptr && is_within(wanted.second, *answer);
  });
}

}  // namespace mien::pipeline
