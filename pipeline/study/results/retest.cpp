#include "pipeline/study/results/retest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "motion/text/as_number.h"
#include "pipeline/manifest/ratings/answers/counted_answers.h"
#include "pipeline/manifest/ratings/answers/trial_form.h"

namespace mien::pipeline {

namespace {

/// Identifies a question: participant, item and stimuli, whichever side they are on.
using RetestKey = std::tuple<std::string, std::string, std::string, std::string, std::string>;

RetestKey retest_key(const AnswerRow& row) {
  const TrialForm* form = find_trial_form(row.kind);
  const bool is_turned = form != nullptr && form->stimuli > 1 && row.against < row.stimulus;
  return {row.participant, row.kind, is_turned ? row.against : row.stimulus,
          is_turned ? row.stimulus : row.against, row.item};
}

bool is_answered(const AnswerRow& row) { return !row.value.empty() && row.value != "NA"; }

/// Whether a row is of a repetition: repetitions and attention checks share a column.
bool is_shown_again(const AnswerRow& row) { return row.is_check && row.kind != attention_kind; }

RetestAnswer retest_answer(const AnswerSet& answer_set, const AnswerRow& first,
                           const AnswerRow& second) {
  RetestAnswer answer;
  answer.participant = second.participant;
  answer.is_excluded = !std::ranges::binary_search(answer_set.people, second.participant);
  answer.stimulus = first.stimulus;
  answer.against = first.against;
  answer.item = second.item;
  answer.first_trial = first.trial;
  answer.second_trial = second.trial;
  answer.first = first.value;
  answer.second = second.value;
  if (!is_on_scale(second) || !answer_set.words.empty()) return answer;
  const auto before = motion::as_number<double>(first.value);
  const auto after = motion::as_number<double>(second.value);
  if (before && after) answer.difference = *after - *before;
  return answer;
}

/// The summary of the answers for which `is_asked` holds.
RetestSummary retest_summary(const std::vector<RetestAnswer>& answers, auto is_asked) {
  RetestSummary summary;
  std::vector<double> first, second;
  double sum = 0.0;
  for (const RetestAnswer& answer : answers) {
    if (!is_asked(answer)) continue;
    ++summary.answers;
    summary.equal += answer.is_equal() ? 1 : 0;
    if (!answer.difference) continue;
    sum += std::abs(*answer.difference);
    first.push_back(*motion::as_number<double>(answer.first));
    second.push_back(*motion::as_number<double>(answer.second));
  }
  summary.mean_difference = first.empty() ? std::numeric_limits<double>::quiet_NaN()
                                          : sum / static_cast<double>(first.size());
  summary.retest = pearson(first, second);
  return summary;
}

}  // namespace

bool RetestAnswer::is_equal() const { return difference ? *difference == 0.0 : first == second; }

std::vector<RetestAnswer> retest_answers_of(const AnswerSet& answer_set,
                                            std::vector<AnswerRow> rows) {
  separate_participants(rows);
  std::map<RetestKey, const AnswerRow*> first;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].counts() && !answer_set.quality.leaves_out(i))
      first.emplace(retest_key(rows[i]), &rows[i]);
  std::vector<RetestAnswer> answers;
  for (const AnswerRow& row : rows) {
    if (!is_shown_again(row) || !is_answered(row)) continue;
    const auto found = first.find(retest_key(row));
    if (found != first.end()) answers.push_back(retest_answer(answer_set, *found->second, row));
  }
  std::ranges::stable_sort(answers, {}, [](const RetestAnswer& answer) {
    return std::tuple(answer.participant, answer.second_trial);
  });
  return answers;
}

std::vector<RetestSummary> retest_summaries_of(const std::vector<RetestAnswer>& answers) {
  std::vector<RetestSummary> all;
  const auto counts = [](const RetestAnswer& answer) { return !answer.is_excluded; };
  if (std::ranges::any_of(answers, counts)) all.push_back(retest_summary(answers, counts));
  std::vector<std::string> items, people;
  for (const RetestAnswer& answer : answers) {
    if (counts(answer) && std::ranges::find(items, answer.item) == items.end())
      items.push_back(answer.item);
    if (people.empty() || people.back() != answer.participant) people.push_back(answer.participant);
  }
  std::ranges::sort(items);
  for (const std::string& item : items) {
    if (items.size() < 2) break;
    all.push_back(retest_summary(answers, [&](const RetestAnswer& answer) {
      return counts(answer) && answer.item == item;
    }));
    all.back().item = item;
  }
  for (const std::string& person : people) {
    const auto is_own = [&](const RetestAnswer& answer) { return answer.participant == person; };
    all.push_back(retest_summary(answers, is_own));
    all.back().participant = person;
    all.back().is_excluded = std::ranges::find_if(answers, is_own)->is_excluded;
  }
  return all;
}

}  // namespace mien::pipeline
