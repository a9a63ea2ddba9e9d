#include "pipeline/study/results/best_worst_scores.h"

#include <limits>
#include <map>
#include <utility>

#include "pipeline/base/statistics/t_test.h"

namespace mien::pipeline {

namespace {

/// Sum of the scores of a participant about a stimulus, and number of sets.
struct OwnScore {
  int sum = 0;
  int shown = 0;
};

}  // namespace

std::vector<AnalysedPreference> implied_preferences(const AnalysedSet& set) {
  std::vector<AnalysedPreference> preferences;
  const auto add = [&](std::size_t chosen, std::size_t other) {
    preferences.push_back({set.person, set.stimuli[chosen], set.stimuli[other], set.scale,
                           chosen < other, /*is_tie=*/false});
  };
  for (std::size_t i = 0; i < set.stimuli.size(); ++i)
    if (i != set.best) add(set.best, i);
  for (std::size_t i = 0; i < set.stimuli.size(); ++i)
    if (i != set.best && i != set.worst) add(i, set.worst);
  return preferences;
}

std::vector<BestWorstScore> best_worst_scores(const AnswerSet& answer_set) {
  using Key = std::pair<std::string, std::size_t>;
  std::map<Key, BestWorstScore> scores;
  std::map<Key, std::map<std::size_t, OwnScore>> people;
  for (const AnalysedSet& set : answer_set.sets) {
    for (std::size_t i = 0; i < set.stimuli.size(); ++i) {
      const Key key = {set.scale, set.stimuli[i]};
      BestWorstScore& score = scores[key];
      score.scale = set.scale;
      score.stimulus = set.stimuli[i];
      ++score.shown;
      score.best += i == set.best ? 1 : 0;
      score.worst += i == set.worst ? 1 : 0;
      OwnScore& own = people[key][set.person];
      ++own.shown;
      own.sum += (i == set.best ? 1 : 0) - (i == set.worst ? 1 : 0);
    }
  }
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<BestWorstScore> all;
  for (auto& [key, score] : scores) {
    std::vector<double> means;
    for (const auto& [person, own] : people[key]) means.push_back(1.0 * own.sum / own.shown);
    score.people = static_cast<int>(means.size());
    score.ends = {none, none};
    if (score.people > 1) {
      const TTest test = paired_t_test(means);
      score.ends = {test.low(0.95), test.high(0.95)};
    }
    all.push_back(score);
  }
  return all;
}

}  // namespace mien::pipeline
