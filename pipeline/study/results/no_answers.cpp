#include "pipeline/study/results/no_answers.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <fmt/format.h>

namespace mien::pipeline {

namespace {

/// Why answers are left out, in the order in which a reason is looked for.
enum class Reason { not_analysed, unfinished, participant, answer, empty };

/// The answers and participants of a reason; those of rules by rule.
struct LeftOut {
  std::size_t answers = 0;
  std::set<std::string> people;
  std::map<std::string, std::set<std::string>> people_by_rule;
};

std::map<Reason, LeftOut> left_out_of(const std::vector<AnswerRow>& rows,
                                      const AnswerSet& answer_set) {
  std::set<std::string> unfinished;
  if (answer_set.without_unfinished)
    for (const Unfinished& one : answer_set.unfinished) unfinished.insert(one.participant);
  std::map<Reason, LeftOut> reasons;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string& person = rows[i].participant;
    AnswerRow answered = rows[i];
    answered.value = "answered";
    const bool is_analysed = answered.counts();
    const bool is_excluded_answer = rows[i].counts() && answer_set.quality.leaves_out(i);
    const Reason reason = !is_analysed                            ? Reason::not_analysed
                          : unfinished.contains(person)           ? Reason::unfinished
                          : answer_set.quality.leaves_out(person) ? Reason::participant
                          : is_excluded_answer                    ? Reason::answer
                                                                  : Reason::empty;
    LeftOut& of = reasons[reason];
    ++of.answers;
    of.people.insert(person);
    const auto& flags = reason == Reason::participant ? answer_set.quality.of_participant(person)
                                                      : answer_set.quality.of_answer(i);
    if (reason == Reason::participant || reason == Reason::answer)
      for (const QualityFlag& flag : flags)
        if (is_excluding(flag.rule, answer_set.quality.rules))
          of.people_by_rule[std::string(word_of(quality_rule_words, flag.rule))].insert(person);
  }
  return reasons;
}

/// "max_failed_checks: 3 participants; min_sd: 1 participant"
std::string rules_text(const LeftOut& of) {
  std::string text;
  for (const auto& [rule, people] : of.people_by_rule)
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", rule,
                        counted_noun(people.size(), "participant", "participants"));
  return text;
}

std::string reason_text(Reason reason, const LeftOut& of) {
  const std::string people = counted_noun(of.people.size(), "participant", "participants");
  switch (reason) {
    case Reason::not_analysed:
      return fmt::format("{} to practice, warm-up and check trials", of.answers);
    case Reason::unfinished:
      return fmt::format("{} of {} who did not finish", of.answers, people);
    case Reason::participant:
      return fmt::format("{} of {} who {} excluded ({})", of.answers, people,
                         of.people.size() == 1 ? "is" : "are", rules_text(of));
    case Reason::answer:
      return fmt::format("{} that quality rules exclude ({})", of.answers, rules_text(of));
    case Reason::empty:
      break;
  }
  return fmt::format("{} that {} empty", of.answers, of.answers == 1 ? "is" : "are");
}

std::string remedy_of(Reason reason) {
  switch (reason) {
    case Reason::not_analysed:
      return "wait for participants who answer trials after practice and warm-up";
    case Reason::unfinished:
      return "omit --unfinished leave-out, which includes what they answered";
    case Reason::participant:
      return "look at the answers, then admit more failed checks with --max-failed-checks, or keep "
             "what quality rules flag with questionnaire: analysis: quality: {flagged: kept}; the "
             "report states such deviations";
    case Reason::answer:
      return "keep what quality rules flag with questionnaire: analysis: quality: {flagged: kept}";
    case Reason::empty:
      break;
  }
  return "give the file of answers as the questionnaire wrote it";
}

}  // namespace

void refuse_without_answers(const std::vector<AnswerRow>& rows, const AnswerSet& answer_set) {
  const std::map<Reason, LeftOut> reasons = left_out_of(rows, answer_set);
  std::string counts;
  Reason main = Reason::not_analysed;
  for (const auto& [reason, of] : reasons) {
    counts += (counts.empty() ? "" : ", ") + reason_text(reason, of);
    const bool is_other = reason != Reason::not_analysed;
    if (is_other && (main == Reason::not_analysed || of.answers > reasons.at(main).answers))
      main = reason;
  }
  throw Error(Place{rows.front().place.file, 1, 1},
              fmt::format("holds no answers to analyse: of {}, {}",
                          counted_noun(rows.size(), "answer", "answers"), counts),
              remedy_of(main));
}

}  // namespace mien::pipeline
