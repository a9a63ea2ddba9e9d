#include "pipeline/manifest/screening.h"

#include <algorithm>

#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"

namespace mien::pipeline {

bool AnswerRange::contains(const std::string& choice) const {
  return std::ranges::find(choices, choice) != choices.end();
}

bool AnswerRange::contains(double number) const {
  return (!from || number >= *from) && (!to || number <= *to);
}

void AnswerRangeForm::read(const DocumentValue& given, AnswerRange& range) {
  range = {};
  if (given.value.is_string()) {
    range.choices = {given.value.get<std::string>()};
    return;
  }
  pipeline::read(given, range.choices);
  assign(member(given.value, "from"), range.from);
  assign(member(given.value, "to"), range.to);
}

OrderedJson AnswerRangeForm::write(const AnswerRange& range, const WritingOptions& how) {
  if (range.empty()) return OrderedJson();
  if (!range.choices.empty()) return written(range.choices, how);
  OrderedJson map = OrderedJson::object();
  if (range.from) map["from"] = *range.from;
  if (range.to) map["to"] = *range.to;
  return map;
}

void AnswersByQuestionForm::read(const DocumentValue& given, AnswersByQuestion& answers) {
  answers.clear();
  if (!given.value.is_object()) return;
  for (const auto& [id, value] : given.value.items()) {
    AnswerRangeForm::read({value, member_path(given.path, id), given.context},
                          answers.emplace_back(id, AnswerRange()).second);
  }
}

OrderedJson AnswersByQuestionForm::write(const AnswersByQuestion& answers,
                                         const WritingOptions& how) {
  OrderedJson map = OrderedJson::object();
  for (const auto& [id, range] : answers) map[id] = AnswerRangeForm::write(range, how);
  return map;
}

}  // namespace mien::pipeline
