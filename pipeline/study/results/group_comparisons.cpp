#include "pipeline/study/results/group_comparisons.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "pipeline/base/statistics/exact_number.h"
#include "pipeline/base/statistics/t_test.h"
#include "pipeline/study/results/comparisons.h"
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

}  // namespace

std::map<std::string, std::vector<std::size_t>> people_by_answer(
    const ParticipantTable& participants, const std::string& question,
    const AnswerSet& answer_set) {
  const CsvTable& table = participants.table;
  const int found = participants.empty() ? -1 : find_column(table, question);
  if (found < 0) return {};
  const auto column = static_cast<std::size_t>(found);
  const auto name = static_cast<std::size_t>(require_column(table, "participant"));
  std::map<std::string, std::set<std::size_t>> groups;
  std::set<std::size_t> met, doubtful;
  for (const auto& row : table.rows) {
    if (row[column].text.empty()) continue;
    for (std::size_t person = 0; person < answer_set.people.size(); ++person) {
      // Where people are identified by "participant/session", the participant is before the slash.
      const std::string& known = answer_set.people[person];
      if (known != row[name].text && !known.starts_with(row[name].text + "/")) continue;
      if (!met.insert(person).second) doubtful.insert(person);
      groups[row[column].text].insert(person);
    }
  }
  std::map<std::string, std::vector<std::size_t>> people;
  for (const auto& [answer, persons] : groups)
    for (const std::size_t person : persons)
      if (!doubtful.contains(person)) people[answer].push_back(person);
  return people;
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
