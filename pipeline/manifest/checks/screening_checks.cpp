#include <algorithm>
#include <set>
#include <string>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/screening.h"

namespace mien::pipeline {

namespace {

/// Checks answers to a question: choices that it has, or a range of numbers.
void check_range(FaultList& list, const std::string& path, const ScreeningQuestion& question,
                 const AnswerRange& range) {
  const std::string name = motion::in_quotes(question.id);
  if (question.answer.is_number) {
    if (!range.choices.empty())
      list.add(path, "the answer to " + name + " is a number", "write {from: 18, to: 65}");
    else if (range.from && range.to && *range.from > *range.to)
      list.add(path, "no number is in this range", "exchange from and to");
    return;
  }
  if (range.from || range.to)
    return list.add(path, "the answer to " + name + " is one of a list",
                    "name some of its choices");
  for (std::size_t i = 0; i < range.choices.size(); ++i) {
    const bool is_single = list.was_given(element_path(path, 0));
    list.check_known_name(is_single ? element_path(path, i) : path, range.choices[i], "choice",
                          question.answer.choices.words);
  }
}

const ScreeningQuestion* question_of(const Screening& screening, const std::string& id) {
  const auto found = std::ranges::find(screening.questions, id, &ScreeningQuestion::id);
  return found == screening.questions.end() ? nullptr : &*found;
}

}  // namespace

std::vector<Fault> check_screening(const Manifest& manifest) {
  if (!manifest.questionnaire) return {};
  const Screening& screening = manifest.questionnaire->screening;
  FaultList list(manifest.places);
  const std::string at = member_path("questionnaire", "screening");
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < screening.questions.size(); ++i) {
    const ScreeningQuestion& question = screening.questions[i];
    const std::string path = element_path(member_path(at, "questions"), i);
    ids.push_back(question.id);
    if (!question.accept.empty())
      check_range(list, member_path(path, "accept"), question, question.accept);
    const bool is_all =
        !question.answer.choices.empty() &&
        std::ranges::all_of(question.answer.choices.words,
                            [&](const std::string& one) { return question.accept.contains(one); });
    if (is_all) list.add(member_path(path, "accept"), "every answer is accepted", "remove it");
  }
  for (std::size_t i = 0; i < screening.quotas.size(); ++i) {
    const std::string path = member_path(element_path(member_path(at, "quotas"), i), "of");
    for (const auto& [id, range] : screening.quotas[i].of) {
      const std::string own = member_path(path, id);
      if (const ScreeningQuestion* question = question_of(screening, id))
        check_range(list, own, *question, range);
      else
        list.add_at_key(own, motion::in_quotes(id) + " is no screening question",
                        "quotas are for answers to the questions of screening: add it there");
    }
  }
  return list.take();
}

}  // namespace mien::pipeline
