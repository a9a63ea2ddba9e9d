#include "pipeline/study/results/grid_results.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/base/statistics/t_test.h"

namespace mien::pipeline {

namespace {

std::string level_in(const ReportedStimulus& stimulus, const std::string& factor) {
  const auto found =
      std::ranges::find(stimulus.factors, factor, &std::pair<std::string, std::string>::first);
  return found == stimulus.factors.end() ? "" : found->second;
}

/// Factors that follow from how a single motion is made (levels_of in factors.h).
bool is_of_single_motion(const std::string& factor) {
  return factor == "example" || factor == "clip";
}

/// Sum and number of ratings.
struct RatingSum {
  double sum = 0.0;
  int count = 0;

  double mean() const { return sum / count; }
};

class GridAnalysis {
 public:
  explicit GridAnalysis(const AnswerSet& answers) : answers_(answers) {
    for (std::size_t i = 0; i < answers.stimuli.size(); ++i)
      stimuli_.emplace(answers.stimuli[i].id, i);
    for (std::size_t s = 0; s < answers.grid.size(); ++s)
      for (const std::string& id : answers.grid[s].stimuli)
        if (const auto known = stimuli_.find(id); known != stimuli_.end())
          set_of_[known->second] = s;
    name_conditions();
    for (const AnalysedRating& rating : answers.ratings) add(rating);
  }

  GridResults run() {
    for (std::size_t i = 0; i < results_.conditions.size(); ++i) add_mean(i);
    for (std::size_t i = 0; i < results_.conditions.size(); ++i)
      for (std::size_t k = i + 1; k < results_.conditions.size(); ++k) add_difference(i, k);
    correct();
    return std::move(results_);
  }

 private:
  /// The factors whose levels differ within a set, in the order of the manifest.
  std::vector<std::string> varied_factors() const {
    std::vector<std::string> factors;
    for (const ReportedStimulus& stimulus : answers_.stimuli)
      for (const auto& [factor, level] : stimulus.factors)
        if (!is_of_single_motion(factor) && std::ranges::find(factors, factor) == factors.end() &&
            is_varied(factor))
          factors.push_back(factor);
    return factors;
  }

  bool is_varied(const std::string& factor) const {
    std::map<std::size_t, std::set<std::string>> levels;  // by set
    for (const auto& [stimulus, set] : set_of_)
      levels[set].insert(level_in(answers_.stimuli[stimulus], factor));
    return std::ranges::any_of(levels, [](const auto& own) { return own.second.size() > 1; });
  }

  void name_conditions() {
    const std::vector<std::string> factors = varied_factors();
    std::map<std::string, std::size_t> known;
    for (const auto& [stimulus, set] : set_of_) {
      std::vector<std::string> levels;
      for (const std::string& factor : factors) {
        std::string level = level_in(answers_.stimuli[stimulus], factor);
        if (!level.empty()) levels.push_back(std::move(level));
      }
      const std::string name = levels.empty() ? answers_.stimuli[stimulus].id
                                              : fmt::format("{}", fmt::join(levels, ", "));
      const std::string role = role_of(answers_.stimuli[stimulus].id, answers_.grid[set]);
      const auto [place, is_new] = known.emplace(name, results_.conditions.size());
      if (is_new) results_.conditions.push_back({name, role});
      GridCondition& condition = results_.conditions[place->second];
      if (condition.role != role) condition.role.clear();
      condition_of_[stimulus] = place->second;
    }
  }

  static std::string role_of(const std::string& id, const GridSet& set) {
    if (id == set.reference) return "reference";
    return id == set.anchor ? "anchor" : "";
  }

  void add(const AnalysedRating& rating) {
    const auto condition = condition_of_.find(rating.stimulus);
    if (condition == condition_of_.end()) return;  // only in practice
    for (RatingSum* sum :
         {&by_person_[condition->second][rating.person],
          &by_set_[condition->second][{rating.person, set_of_.at(rating.stimulus)}]}) {
      sum->sum += rating.value;
      ++sum->count;
    }
  }

  void add_mean(std::size_t condition) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> means;
    GridMean result{.condition = condition, .deviation = none, .ends = {none, none}};
    for (const auto& [person, own] : by_person_[condition]) {
      means.push_back(own.mean());
      result.answers += own.count;
    }
    if (means.empty()) return;
    const TTest test = paired_t_test(means);
    result.people = static_cast<int>(means.size());
    result.mean = test.mean;
    if (result.people > 1) {
      result.deviation = sample_deviation(means);
      result.ends = {test.low(0.95), test.high(0.95)};
    }
    results_.means.push_back(result);
  }

  void add_difference(std::size_t one, std::size_t other) {
    std::map<std::size_t, RatingSum> differences;  // by participant
    for (const auto& [key, own] : by_set_[one]) {
      const auto matched = by_set_[other].find(key);
      if (matched == by_set_[other].end()) continue;
      RatingSum& sum = differences[key.first];
      sum.sum += own.mean() - matched->second.mean();
      ++sum.count;
    }
    if (differences.empty()) return;
    std::vector<double> means;
    for (const auto& [person, own] : differences) means.push_back(own.mean());
    results_.differences.push_back(
        {.one = one, .other = other, .within = within_participants(means)});
  }

  void correct() {
    std::vector<double> paired, wilcoxon;
    for (const GridDifference& one : results_.differences) {
      paired.push_back(one.within.t.p);
      wilcoxon.push_back(one.within.wilcoxon.p);
    }
    paired = corrected(paired, answers_.correction);
    wilcoxon = corrected(wilcoxon, answers_.correction);
    for (std::size_t i = 0; i < results_.differences.size(); ++i) {
      results_.differences[i].paired_adjusted = paired[i];
      results_.differences[i].wilcoxon_adjusted = wilcoxon[i];
    }
  }

  const AnswerSet& answers_;
  GridResults results_;
  std::map<std::string, std::size_t> stimuli_;
  std::map<std::size_t, std::size_t> set_of_;        ///< by stimulus
  std::map<std::size_t, std::size_t> condition_of_;  ///< by stimulus
  /// By condition: by participant, and by participant and set.
  std::map<std::size_t, std::map<std::size_t, RatingSum>> by_person_;
  std::map<std::size_t, std::map<std::pair<std::size_t, std::size_t>, RatingSum>> by_set_;
};

}  // namespace

GridResults grid_results(const AnswerSet& answer_set) {
  if (answer_set.grid.empty()) return {};
  return GridAnalysis(answer_set).run();
}

}  // namespace mien::pipeline
