#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/questionnaire_forms.h"

namespace mien::pipeline {

/// Answers to a question of the screening: some of its choices, or a range of numbers.
struct AnswerRange {
  std::vector<std::string> choices;
  std::optional<double> from, to;  ///< both included; unset: no limit on that side

  bool empty() const { return choices.empty() && !from && !to; }
  bool contains(const std::string& choice) const;
  bool contains(double number) const;
};

/// `woman`, `[woman, other]`, or `{from: 18, to: 65}`.
struct AnswerRangeForm {
  static void read(const DocumentValue& given, AnswerRange& range);
  static nlohmann::ordered_json write(const AnswerRange& range, const WritingOptions& how);
  static void walk(auto& names) {
    names.add("from");
    names.add("to");
  }
};

/// A question that decides whether a participant may take part. It must be answered.
struct ScreeningQuestion {
  std::string id;       ///< column in the table of participants
  LocalText ask;        ///< the question
  AnswerChoice answer;  ///< a number, or one of several choices
  AnswerRange accept;   ///< empty: every answer
};

void fields_of(auto&& field, MaybeConst<ScreeningQuestion> auto& question) {
  field("id", question.id, concerns::required);
  field.by("ask", question.ask, concerns::required, LocalTextForm());
  field.by("answer", question.answer, concerns::required, AnswerChoiceForm());
  field.by("accept", question.accept, concerns::nothing, AnswerRangeForm());
}

/// Answers by the ids of their questions.
using AnswersByQuestion = std::vector<std::pair<std::string, AnswerRange>>;

/// `{gender: woman, age: {from: 18, to: 30}}`.
struct AnswersByQuestionForm {
  static void read(const DocumentValue& given, AnswersByQuestion& answers);
  static nlohmann::ordered_json write(const AnswersByQuestion& answers, const WritingOptions& how);
  static void walk(auto& names) {
    names.add("from");
    names.add("to");
  }
};

/// A limit on the number of participants with certain answers to questions of the screening.
struct Quota {
  AnswersByQuestion of;  ///< a participant counts who has given an answer of each range
  int at_most = 0;
};

void fields_of(auto&& field, MaybeConst<Quota> auto& quota) {
  field.by("of", quota.of, concerns::required, AnswersByQuestionForm());
  field("at_most", quota.at_most, concerns::required);
}

/// What decides, after consent, whether a participant may take part.
struct Screening {
  std::vector<ScreeningQuestion> questions;
  std::vector<Quota> quotas;  ///< over all sessions of a served study
  /// Smallest width and height of the browser's viewport, CSS pixels.
  std::optional<std::array<int, 2>> window;
  std::optional<double> refresh_hz;  ///< least refresh rate of the screen
  bool sound = false;                ///< participants count tones, to show that they hear

  bool empty() const { return questions.empty() && !window && !refresh_hz && !sound; }
};

void fields_of(auto&& field, MaybeConst<Screening> auto& screening) {
  field.each("questions", screening.questions, concerns::nothing,
             [] { return ScreeningQuestion(); });
  field.each("quotas", screening.quotas, concerns::nothing, [] { return Quota(); });
  field("window", screening.window, concerns::nothing);
  field("refresh_hz", screening.refresh_hz, concerns::nothing);
  field("sound", screening.sound, concerns::nothing);
}

}  // namespace mien::pipeline
