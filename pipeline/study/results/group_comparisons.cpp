#include "pipeline/study/results/group_comparisons.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/statistics/exact_number.h"
#include "pipeline/base/statistics/t_test.h"
#include "pipeline/study/results/comparisons.h"
#include "pipeline/study/results/people_of_rows.h"
#include "pipeline/study/results/summaries.h"

namespace mien::pipeline {

namespace {

std::vector<double> participant_means(const std::map<std::size_t, ExactSum>& sums,
                                      const std::vector<std::size_t>& people) {
  std::vector<double> means;
  for (const std::size_t person : people) {
    const auto found = sums.find(person);
    if (found != sums.end()) means.push_back(found->second.mean().value());
  }
  return means;
}

GroupComparison group_comparison(const ParticipantGroups& groups, const std::vector<double>& one,
                                 const std::vector<double>& other) {
  GroupComparison result{.question = groups.question, .one = groups.one, .other = groups.other};
  result.people_one = static_cast<int>(one.size());
  result.people_other = static_cast<int>(other.size());
  result.mean_one = exact_mean(one);
  result.mean_other = exact_mean(other);
  result.welch = welch_t_test(one, other);
  result.g = hedges_g(one, other);
  if (all_equal(one) && all_equal(other))
    result.welch.standard_error = result.welch.t = result.welch.p = result.g =
        std::numeric_limits<double>::quiet_NaN();
  return result;
}

/// What the table of participants has of a person.
struct OwnRows {
  int rows = 0;
  std::vector<std::string> answers;  ///< to the question; one for each row with an answer

  bool is_grouped() const { return answers.size() == 1; }
};

/// By index into AnswerSet::people; empty if the table has no such column.
std::vector<OwnRows> own_rows(const ParticipantTable& participants, const std::string& question,
                              const AnswerSet& answer_set) {
  const int found = participants.empty() ? -1 : find_column(participants.table, question);
  if (found < 0) return {};
  const auto column = static_cast<std::size_t>(found);
  const std::vector<std::string> people = people_of_rows(participants, answer_set);
  std::vector<OwnRows> all(answer_set.people.size());
  for (std::size_t i = 0; i < people.size(); ++i) {
    const auto person = std::ranges::find(answer_set.people, people[i]);
    if (person == answer_set.people.end()) continue;
    OwnRows& own = all[static_cast<std::size_t>(person - answer_set.people.begin())];
    ++own.rows;
    const std::string& answer = participants.table.rows[i][column].text;
    if (!answer.empty()) own.answers.push_back(answer);
  }
  return all;
}

constexpr std::string_view no_answer = "the question was not answered";

/// Why a person is in no group, with the remedy; the names of separated people are not ids.
std::string_view reason_of_no_group(const OwnRows& own, bool is_separated, bool has_sessions) {
  if (own.answers.size() > 1)
    return "the table of participants has several rows with an answer; keep the right one";
  if (own.rows > 0) return no_answer;
  if (is_separated && !has_sessions)
    return "the table of participants has no column session, which tells apart people with the "
           "same id; give one that has it";
  return "the table of participants has no row with the id and session of the answers; give the "
         "tables of all participants with --participants";
}

/// People in no group: the reason and their names.
std::map<std::string, std::vector<std::string>> ungrouped_people(
    const ParticipantTable& participants, const std::string& question,
    const AnswerSet& answer_set) {
  std::set<std::string> separated;
  for (const auto& [session, person] : answer_set.person_of_session)
    if (person != session.first) separated.insert(person);
  const bool has_sessions = find_column(participants.table, "session") >= 0;
  const std::vector<OwnRows> all = own_rows(participants, question, answer_set);
  std::map<std::string, std::vector<std::string>> people;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& person = answer_set.people[i];
    if (all[i].is_grouped()) continue;
    const std::string_view reason =
        reason_of_no_group(all[i], separated.contains(person), has_sessions);
    people[std::string(reason)].push_back(motion::in_quotes(person));
  }
  return people;
}

}  // namespace

std::map<std::string, std::vector<std::size_t>> people_by_answer(
    const ParticipantTable& participants, const std::string& question,
    const AnswerSet& answer_set) {
  const std::vector<OwnRows> all = own_rows(participants, question, answer_set);
  std::map<std::string, std::vector<std::size_t>> people;
  for (std::size_t person = 0; person < all.size(); ++person)
    if (all[person].is_grouped()) people[all[person].answers.front()].push_back(person);
  return people;
}

std::vector<std::string> ungrouped_sentences(const ParticipantTable& participants,
                                             const AnswerSet& answer_set) {
  const std::string& planned = answer_set.factorial.between;
  std::vector<std::string> sentences;
  if (!planned.empty() && (participants.empty() || find_column(participants.table, planned) < 0))
    sentences.push_back(
        fmt::format("there are no groups by {}: {}; give the tables of all "
                    "participants with --participants",
                    motion::in_quotes(planned),
                    participants.empty() ? "there is no table of participants"
                                         : "the table of participants has no such column"));
  if (participants.empty()) return sentences;
  std::set<std::string> compared = {planned};
  for (const ParticipantGroups& groups : participant_groups(participants, answer_set))
    compared.insert(groups.question);
  std::set<std::string> asked = answer_set.worded_questions;
  if (!planned.empty()) asked.insert(planned);
  std::map<std::pair<std::string, std::vector<std::string>>, std::vector<std::string>> questions;
  for (const std::string& question : asked)
    for (const auto& [reason, people] : ungrouped_people(participants, question, answer_set))
      if (reason != no_answer || compared.contains(question))
        questions[{reason, people}].push_back(motion::in_quotes(question));
  for (const auto& [left_out, of] : questions) {
    const auto& [reason, people] = left_out;
    sentences.push_back(fmt::format("{} {} {} in no group by {}, because {}",
                                    people.size() == 1 ? "participant" : "participants",
                                    fmt::join(people, ", "), people.size() == 1 ? "is" : "are",
                                    fmt::join(of, ", "), reason));
  }
  return sentences;
}

std::vector<ParticipantGroups> participant_groups(const ParticipantTable& participants,
                                                  const AnswerSet& answer_set) {
  std::vector<ParticipantGroups> all;
  if (participants.empty()) return all;
  for (const std::string& question : participants.questions()) {
    if (!answer_set.worded_questions.contains(question)) continue;
    std::vector<std::pair<std::string, std::vector<std::size_t>>> answers;
    for (auto& [answer, people] : people_by_answer(participants, question, answer_set))
      if (people.size() >= 2) answers.emplace_back(answer, people);
    std::ranges::stable_sort(answers, std::ranges::greater{},
                             [](const auto& one) { return one.second.size(); });
    if (answers.size() < 2) continue;
    all.push_back(
        {question, answers[0].first, answers[1].first, answers[0].second, answers[1].second});
  }
  return all;
}

std::vector<GroupComparison> compare_groups(const ParticipantTable& participants,
                                            const AnswerSet& answer_set) {
  std::vector<GroupComparison> all;
  for (const ParticipantGroups& groups : participant_groups(participants, answer_set)) {
    const std::size_t first = all.size();
    std::vector<double> p_values;
    for (std::size_t scale = 0; scale < answer_set.scales.size(); ++scale) {
      const auto ratings = ratings_by_stimulus(answer_set, scale);
      for (std::size_t stimulus = 0; stimulus < ratings.size(); ++stimulus) {
        std::map<std::size_t, ExactSum> sums;
        for (const AnalysedRating& rating : ratings[stimulus])
          sums[rating.person].add(ExactNumber::of(rating.value));
        const std::vector<double> one = participant_means(sums, groups.people_one);
        const std::vector<double> other = participant_means(sums, groups.people_other);
        if (one.size() < 2 || other.size() < 2) continue;
        all.push_back(group_comparison(groups, one, other));
        all.back().stimulus = stimulus;
        all.back().scale = scale;
        p_values.push_back(all.back().welch.p);
      }
    }
    const std::vector<double> adjusted = corrected(p_values, answer_set.correction);
    for (std::size_t i = 0; i < adjusted.size(); ++i) all[first + i].adjusted = adjusted[i];
    std::stable_sort(
        all.begin() + static_cast<std::ptrdiff_t>(first), all.end(),
        [](const GroupComparison& a, const GroupComparison& b) { return a.stimulus < b.stimulus; });
  }
  return all;
}

}  // namespace mien::pipeline
