#include "pipeline/matching/matching_evaluation.h"

#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "pipeline/statistics/holm.h"

namespace mien::pipeline {

namespace {

std::optional<double> value_of(const MatchingTrial& trial, MatchingMeasure measure) {
  return measure == MatchingMeasure::time_s ? trial.time_s : trial.first_guess_d;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double deviation_of(const std::vector<double>& values) {
  if (values.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  const double mean = mean_of(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

/// Values by participant, then target.
using ValueTable = std::map<std::string, std::map<std::string, double>>;

ValueTable values_of(const MatchingResults& results, MatchingMeasure measure,
                     const std::string& interface) {
  ValueTable table;
  for (const MatchingTrial& trial : results.trials) {
    const auto value = value_of(trial, measure);
    if (trial.interface == interface && value) table[trial.participant][trial.target] = *value;
  }
  return table;
}

void add_means(const MatchingResults& results, MatchingMeasure measure,
               const std::string& interface, std::vector<MatchingMean>& means) {
  const ValueTable table = values_of(results, measure, interface);
  std::vector<double> by_participant;
  std::map<std::string, std::vector<double>> by_target;
  for (const auto& [participant, values] : table) {
    std::vector<double> own;
    for (const auto& [target, value] : values) {
      own.push_back(value);
      by_target[target].push_back(value);
    }
    by_participant.push_back(mean_of(own));
  }
  const auto add = [&](const std::string& target, const std::vector<double>& values) {
    if (values.empty()) return;
    means.push_back({measure, interface, target, static_cast<int>(values.size()), mean_of(values),
                     deviation_of(values)});
  };
  add("", by_participant);
  for (const std::string& target : results.targets) add(target, by_target[target]);
}

MatchingShare share_of(const MatchingResults& results, const std::string& interface) {
  MatchingShare share;
  share.interface = interface;
  for (const MatchingTrial& trial : results.trials) {
    if (trial.interface != interface) continue;
    ++share.trials;
    share.failures += !trial.success;
    share.guesses += trial.first_guess_d.has_value();
    share.near_guesses += trial.first_guess_d && *trial.first_guess_d < results.threshold_m;
  }
  return share;
}

std::vector<double> paired_differences(const ValueTable& first, const ValueTable& second) {
  std::vector<double> differences;
  for (const auto& [participant, values] : first) {
    const auto other = second.find(participant);
    if (other == second.end()) continue;
    std::vector<double> own;
    for (const auto& [target, value] : values) {
      const auto same = other->second.find(target);
      if (same != other->second.end()) own.push_back(value - same->second);
    }
    if (!own.empty()) differences.push_back(mean_of(own));
  }
  return differences;
}

std::vector<MatchingComparison> compare(const MatchingResults& results, MatchingMeasure measure) {
  std::vector<MatchingComparison> comparisons;
  std::vector<double> paper;
  std::vector<double> exact;
  for (size_t a = 0; a < results.interfaces.size(); ++a) {
    for (size_t b = a + 1; b < results.interfaces.size(); ++b) {
      const std::vector<double> differences =
          paired_differences(values_of(results, measure, results.interfaces[a]),
                             values_of(results, measure, results.interfaces[b]));
      if (differences.empty()) continue;
      comparisons.push_back({measure, results.interfaces[a], results.interfaces[b],
                             paired_t_test(differences),
                             wilcoxon(differences, WilcoxonMode::published), wilcoxon(differences),
                             1.0, 1.0, cohens_dz(differences)});
      paper.push_back(comparisons.back().paper.p);
      exact.push_back(comparisons.back().exact.p);
    }
  }
  paper = holm(paper);
  exact = holm(exact);
  for (size_t i = 0; i < comparisons.size(); ++i) {
    comparisons[i].paper_holm = paper[i];
    comparisons[i].exact_holm = exact[i];
  }
  return comparisons;
}

}  // namespace

const char* name_of(MatchingMeasure measure) {
  return measure == MatchingMeasure::time_s ? "time_s" : "first_guess_d";
}

MatchingEvaluation evaluate(const MatchingResults& results) {
  MatchingEvaluation evaluation;
  evaluation.threshold_m = results.threshold_m;
  for (const auto measure : {MatchingMeasure::first_guess_d, MatchingMeasure::time_s}) {
    for (const std::string& interface : results.interfaces) {
      add_means(results, measure, interface, evaluation.means);
    }
    for (MatchingComparison& comparison : compare(results, measure)) {
      evaluation.comparisons.push_back(std::move(comparison));
    }
  }
  for (const std::string& interface : results.interfaces) {
    evaluation.shares.push_back(share_of(results, interface));
  }
  return evaluation;
}

}  // namespace mien::pipeline
