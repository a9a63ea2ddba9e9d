#include "pipeline/study/results/pair_worth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "pipeline/study/results/comparisons.h"

namespace mien::pipeline {

namespace {

constexpr std::uint64_t worth_seed = 1;

/// The comparisons for one item, with conditions numbered among those compared.
struct ItemComparisons {
  std::vector<std::size_t> compared;  ///< their numbers in ComparedConditions
  std::vector<std::size_t> people;    ///< those who made comparisons
  std::vector<std::vector<PairCount>> by_person;
  std::vector<PairCount> all;
  int within_conditions = 0;
};

using PairCounts = std::map<std::pair<std::size_t, std::size_t>, PairCount>;

void add_comparison(PairCounts& counts, std::size_t left, std::size_t right,
                    const AnalysedPreference& answer) {
  PairCount& count = counts[{left, right}];
  count.first = left;
  count.second = right;
  double& outcome = answer.is_tie           ? count.ties
                    : answer.is_left_chosen ? count.first_wins
                                            : count.second_wins;
  outcome += 1.0;
}

std::vector<PairCount> listed(const PairCounts& counts) {
  std::vector<PairCount> list;
  for (const auto& [pair, count] : counts) list.push_back(count);
  return list;
}

ItemComparisons comparisons_of(const AnswerSet& answer_set, const ComparedConditions& conditions,
                               const std::string& item) {
  const auto condition_of = [&](std::size_t stimulus) { return conditions.of_stimulus[stimulus]; };
  ItemComparisons result;
  std::vector<const AnalysedPreference*> answers;
  std::set<std::size_t> compared;
  for (const AnalysedPreference& answer : answer_set.preferences) {
    if (answer.item != item) continue;
    if (condition_of(answer.chosen) == condition_of(answer.other)) {
      ++result.within_conditions;
      continue;
    }
    answers.push_back(&answer);
    compared.insert({condition_of(answer.chosen), condition_of(answer.other)});
  }
  result.compared.assign(compared.begin(), compared.end());
  const auto number_of = [&](std::size_t stimulus) {
    return static_cast<std::size_t>(
        std::ranges::lower_bound(result.compared, condition_of(stimulus)) -
        result.compared.begin());
  };
  PairCounts all;
  std::map<std::size_t, PairCounts> people;
  for (const AnalysedPreference* answer : answers) {
    const std::size_t left = number_of(answer->is_left_chosen ? answer->chosen : answer->other);
    const std::size_t right = number_of(answer->is_left_chosen ? answer->other : answer->chosen);
    add_comparison(all, left, right, *answer);
    add_comparison(people[answer->person], left, right, *answer);
  }
  for (const auto& [person, own] : people) {
    result.people.push_back(person);
    result.by_person.push_back(listed(own));
  }
  result.all = listed(all);
  return result;
}

void count_outcomes(const ItemComparisons& asked, PairWorth& worth) {
  for (const PairCount& count : asked.all) {
    StimulusWorth& left = worth.stimuli[count.first];
    StimulusWorth& right = worth.stimuli[count.second];
    const auto for_left = static_cast<int>(count.first_wins);
    const auto for_right = static_cast<int>(count.second_wins);
    const auto ties = static_cast<int>(count.ties);
    left.chosen += for_left;
    right.other_chosen += for_left;
    right.chosen += for_right;
    left.other_chosen += for_right;
    left.ties += ties;
    right.ties += ties;
    worth.ties += ties;
    worth.comparisons += for_left + for_right + ties;
  }
}

OrderEffect order_of(const PairWorth& worth) {
  return worth.has_order ? OrderEffect::estimated : OrderEffect::none;
}

void fit_model(const ItemComparisons& asked, const WorthDetail& detail, PairWorth& worth) {
  const std::size_t stimuli = asked.compared.size();
  const BradleyTerry without = bradley_terry(asked.all, stimuli, OrderEffect::none);
  const BradleyTerry with = bradley_terry(asked.all, stimuli, OrderEffect::estimated);
  worth.has_order = with.is_finite;
  worth.fit = with.is_finite ? with : without;
  for (std::size_t i = 0; i < stimuli; ++i) {
    StimulusWorth& one = worth.stimuli[i];
    one.record = worth.fit.groups.records[i];
    one.group = static_cast<int>(worth.fit.groups.group[i]) + 1;
    one.worth = worth.fit.worth[i];
    one.error = worth.fit.error[i];
  }
  if (detail.only_planned) return;
  worth.order = order_test(with, without);
  worth.equal = equal_worth_test(worth.fit, asked.all, order_of(worth));
  const auto intervals = profile_intervals(worth.fit, asked.all, order_of(worth));
  const auto elo = elo_ratings(asked.all, stimuli, worth_seed);
  for (std::size_t i = 0; i < stimuli; ++i) {
    worth.stimuli[i].by_answers = intervals[i];
    worth.stimuli[i].elo = elo[i];
  }
}

/// The comparisons between the stimuli of one group, numbered within it.
std::vector<std::vector<PairCount>> within_group(const ItemComparisons& asked,
                                                 const std::vector<std::size_t>& members) {
  const auto place_of = [&](std::size_t stimulus) {
    return static_cast<std::size_t>(std::ranges::find(members, stimulus) - members.begin());
  };
  std::vector<std::vector<PairCount>> people;
  for (const std::vector<PairCount>& own : asked.by_person) {
    std::vector<PairCount>& kept = people.emplace_back();
    for (PairCount count : own) {
      count.first = place_of(count.first);
      count.second = place_of(count.second);
      if (count.first < members.size() && count.second < members.size()) kept.push_back(count);
    }
  }
  return people;
}

/// The contrasts of stimuli that have worths in the same group, and so have a value.
std::vector<WorthContrast*> comparable_contrasts(PairWorth& worth) {
  std::vector<WorthContrast*> comparable;
  for (WorthContrast& contrast : worth.contrasts) {
    std::set<int> groups;
    bool have_worths = true;
    for (std::size_t i = 0; i < contrast.of.size(); ++i) {
      if (contrast.of[i] == 0.0) continue;
      have_worths = have_worths && !std::isnan(worth.stimuli[i].worth);
      groups.insert(worth.stimuli[i].group);
    }
    if (have_worths && groups.size() == 1) comparable.push_back(&contrast);
  }
  return comparable;
}

double difference_in(const PairWorth& worth, const WorthContrast& contrast) {
  double sum = 0.0;
  for (std::size_t i = 0; i < contrast.of.size(); ++i)
    if (contrast.of[i] != 0.0) sum += contrast.of[i] * worth.stimuli[i].worth;
  return sum;
}

void set_contrasts_by_answers(const ItemComparisons& asked, PairWorth& worth) {
  const std::vector<WorthContrast*> contrasts = comparable_contrasts(worth);
  std::vector<WorthWeights> weights;
  for (const WorthContrast* contrast : contrasts) weights.push_back(contrast->of);
  const std::vector<double> errors =
      contrast_errors(worth.fit, asked.all, order_of(worth), weights);
  for (std::size_t i = 0; i < contrasts.size(); ++i)
    set_by_answers(*contrasts[i], difference_in(worth, *contrasts[i]), errors[i]);
}

/// Intervals from resampled participants, if exactly one group has estimates.
void resample_people(const ItemComparisons& asked, int resamples, PairWorth& worth) {
  std::vector<std::size_t> members;
  std::set<int> groups;
  for (std::size_t i = 0; i < worth.stimuli.size(); ++i) {
    if (std::isnan(worth.stimuli[i].worth)) continue;
    members.push_back(i);
    groups.insert(worth.stimuli[i].group);
  }
  if (groups.size() != 1 || asked.people.size() < 2) return;
  const std::vector<WorthContrast*> contrasts = comparable_contrasts(worth);
  std::vector<WorthWeights> weights;
  for (const WorthContrast* contrast : contrasts) {
    WorthWeights& own = weights.emplace_back();
    for (const std::size_t member : members) own.push_back(contrast->of[member]);
  }
  const WorthBootstrap found = worth_bootstrap(within_group(asked, members), members.size(),
                                               order_of(worth), worth_seed, resamples, weights);
  worth.resamples = found.resamples;
  worth.without_estimate = found.without_estimate;
  worth.order_ends = found.order;
  worth.is_by_participants = worth.people >= fewest_resampled_people;
  for (std::size_t i = 0; i < members.size(); ++i) {
    worth.stimuli[members[i]].by_participants = found.worth[i];
    if (std::isnan(found.worth[i].low)) worth.is_by_participants = false;
  }
  if (!worth.is_by_participants) return;
  for (std::size_t i = 0; i < contrasts.size(); ++i)
    set_by_participants(*contrasts[i], difference_in(worth, *contrasts[i]), found.contrasts[i],
                        worth.people);
}

PairWorth worth_of(const AnswerSet& answer_set, const ComparedConditions& conditions,
                   const std::string& item, const WorthDetail& detail) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const ItemComparisons asked = comparisons_of(answer_set, conditions, item);
  PairWorth worth{
      .item = item, .order_ends = {none, none}, .order = {none, 0, none}, .equal = {none, 0, none}};
  worth.people = static_cast<int>(asked.people.size());
  worth.within_conditions = asked.within_conditions;
  for (const std::size_t condition : asked.compared)
    worth.stimuli.push_back({.name = conditions.names[condition], .by_participants = {none, none}});
  worth.contrasts = begun_worth_contrasts(answer_set, conditions, asked.compared, item);
  if (detail.only_planned)
    std::erase_if(worth.contrasts,
                  [](const WorthContrast& one) { return one.kind != ContrastKind::planned; });
  count_outcomes(asked, worth);
  fit_model(asked, detail, worth);
  set_contrasts_by_answers(asked, worth);
  resample_people(asked, detail.resamples, worth);
  if (!answer_set.sets.empty()) {
    worth.is_implied = true;
    worth.equal = worth.order = {none, 0, none};
    // Errors that treat implied comparisons as independent would say too much.
    if (!worth.is_by_participants) worth.contrasts.clear();
    return worth;
  }
  if (detail.only_planned) return worth;
  worth.transitivity = transitivity_violations(asked.all, asked.compared.size());
  for (std::size_t i = 0; i < asked.people.size(); ++i)
    if (const auto own = circular_triads(asked.by_person[i], asked.compared.size()))
      worth.triads.push_back({asked.people[i], *own});
  return worth;
}

void correct_contrasts(std::vector<PairWorth>& worths, ContrastKind kind,
                       TestCorrection correction) {
  std::vector<WorthContrast*> members;
  std::vector<double> p_values;
  for (PairWorth& worth : worths) {
    for (WorthContrast& contrast : worth.contrasts) {
      if (contrast.kind != kind) continue;
      members.push_back(&contrast);
      p_values.push_back(contrast.p);
    }
  }
  const std::vector<double> adjusted = corrected(p_values, correction);
  for (std::size_t i = 0; i < members.size(); ++i) members[i]->adjusted = adjusted[i];
}

}  // namespace

std::vector<PairWorth> worths_of(const AnswerSet& answer_set, const WorthDetail& detail) {
  const ComparedConditions conditions = compared_conditions(answer_set);
  std::set<std::string> items;
  for (const AnalysedPreference& answer : answer_set.preferences) items.insert(answer.item);
  std::vector<PairWorth> worths;
  std::vector<double> equal;
  std::vector<double> order;
  for (const std::string& item : items) {
    worths.push_back(worth_of(answer_set, conditions, item, detail));
    equal.push_back(worths.back().equal.p);
    order.push_back(worths.back().order.p);
  }
  equal = corrected(equal, answer_set.correction);
  order = corrected(order, answer_set.correction);
  for (std::size_t i = 0; i < worths.size(); ++i) {
    worths[i].equal_adjusted = equal[i];
    worths[i].order_adjusted = order[i];
  }
  correct_contrasts(worths, ContrastKind::planned, answer_set.correction);
  correct_contrasts(worths, ContrastKind::pairwise, answer_set.correction);
  return worths;
}

std::string record_text(const StimulusWorth& one) {
  switch (one.record) {
    case WinRecord::always_won:
      return "always chosen";
    case WinRecord::always_lost:
      return "never chosen";
    case WinRecord::separated:
      return "always chosen over some, never over others";
    case WinRecord::not_compared:
      return "not compared";
    case WinRecord::estimated:
      break;
  }
  return std::isnan(one.worth) ? "not determined by the answers" : "";
}

}  // namespace mien::pipeline
