#include "pipeline/study/questionnaire/simulated_people.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/base/statistics/named_random.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/ratings/answers/participant_row.h"
#include "pipeline/manifest/ratings/answers/session_end.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"

namespace mien::pipeline {

namespace {

constexpr double youngest = 18.0, oldest = 65.0;

std::string answer_of(const std::string& id, const AnswerChoice& answer, const AnswerRange& accept,
                      std::uint64_t seed) {
  const double share = uniform(seed, "about/" + id);
  const auto chosen = [&](const std::vector<std::string>& from) {
    const auto at = static_cast<std::size_t>(share * static_cast<double>(from.size()));
    return from[std::min(at, from.size() - 1)];
  };
  if (!accept.choices.empty()) return chosen(accept.choices);
  if (!answer.choices.words.empty()) return chosen(answer.choices.words);
  if (!answer.is_number) return "simulated";
  constexpr double years = oldest - youngest;
  const double from = std::ceil(accept.from.value_or(accept.to ? *accept.to - years : youngest));
  const double to = std::floor(accept.to.value_or(from + years));
  return fmt::format("{:.0f}", std::min(to, from + std::floor(share * (to - from + 1.0))));
}

}  // namespace

bool asks_about_participants(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  return !asked.demographics.empty() || !asked.screening.questions.empty();
}

std::string simulated_people_csv(const Manifest& manifest, const std::vector<SessionPlan>& plans) {
  const Questionnaire& asked = questionnaire_of(manifest);
  std::vector<std::string> columns;
  for (const ScreeningQuestion& question : asked.screening.questions)
    columns.push_back(question.id);
  for (const Demographic& question : asked.demographics) columns.push_back(question.id);
  columns.emplace_back("simulated");
  const std::string design = design_hash(manifest, plan_sessions(manifest));
  std::vector<ParticipantRow> rows;
  for (const SessionPlan& plan : plans) {
    ParticipantRow row;
    row.participant = plan.participant;
    row.session = "simulated";
    row.design = design;
    row.has_finished = true;
    row.ended = word_of(session_end_words, SessionEnd::completed);
    row.language = asked.language.offered.empty() ? "" : asked.language.offered.front();
    row.consent_version = asked.consent_version;
    for (const ScreeningQuestion& question : asked.screening.questions)
      row.answers.push_back(answer_of(question.id, question.answer, question.accept, plan.seed));
    for (const Demographic& question : asked.demographics)
      row.answers.push_back(answer_of(question.id, question.answer, {}, plan.seed));
    row.answers.emplace_back("1");
    rows.push_back(std::move(row));
  }
  return to_csv(rows, columns);
}

}  // namespace mien::pipeline
