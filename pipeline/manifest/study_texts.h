#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/documents/places.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Calls `visit(path, text)` for each text of a question about the participant: a LocalText or
/// LocalWords.
void visit_question_texts(const std::string& path, auto& questions, const auto& visit) {
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const std::string at = element_path(path, i);
    visit(member_path(at, "ask"), questions[i].ask);
    visit(member_path(at, "answer"), questions[i].answer.choices);
  }
}

/// Calls `visit(path, text)` for each text for participants that a questionnaire or an experiment
/// has of its own: a LocalText, LocalWords or a TextSource.
void visit_texts(MaybeConst<Questionnaire> auto& asked, const auto& visit) {
  const auto at = [](const char* key) { return member_path("questionnaire", key); };
  visit(at("title"), asked.title);
  visit(at("consent"), asked.consent);
  visit(at("instructions"), asked.instructions);
  visit(at("debriefing"), asked.debriefing);
  visit(at("ending"), asked.ending);
  visit(at("question"), asked.question);
  for (auto& [id, shown] : asked.choices) visit(member_path(at("choices"), id), shown);
  visit(member_path(at("answer"), "suggest"), asked.answer.suggest);
  visit_question_texts(member_path(at("screening"), "questions"), asked.screening.questions, visit);
  visit_question_texts(at("demographics"), asked.demographics, visit);
}

void visit_texts(MaybeConst<Matching> auto& asked, const auto& visit) {
  const auto at = [](const char* key) { return member_path("matching", key); };
  visit(at("title"), asked.title);
  visit(at("consent"), asked.consent);
  visit(at("instructions"), asked.instructions);
  visit(at("ending"), asked.ending);
  visit_question_texts(at("demographics"), asked.demographics, visit);
}

void visit_texts(MaybeConst<Adaptive> auto& asked, const auto& visit) {
  const auto at = [](const char* key) { return member_path("adaptive", key); };
  visit(at("title"), asked.title);
  visit(at("consent"), asked.consent);
  visit(at("instructions"), asked.instructions);
  visit(at("ending"), asked.ending);
  for (auto& [id, shown] : asked.words) visit(member_path(at("words"), id), shown);
  visit_question_texts(at("demographics"), asked.demographics, visit);
}

/// Calls `visit` with the questionnaire and with the matching and adaptive experiments of a
/// manifest, if it has them.
void visit_experiments(MaybeConst<Manifest> auto& manifest, const auto& visit) {
  if (manifest.questionnaire) visit(*manifest.questionnaire);
  if (manifest.matching) visit(*manifest.matching);
  if (manifest.adaptive) visit(*manifest.adaptive);
}

/// Sets the texts that are given by language to those of the first language offered.
void choose_first_language(Manifest& manifest);

/// The manifest as if its pages were in this language alone. `language` must be one of those
/// offered.
Manifest in_language(Manifest manifest, const std::string& language);

/// The texts of pages in a language: the study's own ones, or the built-in ones.
const nlohmann::json& page_texts(const OwnTexts& own, std::string_view language);

}  // namespace mien::pipeline
