#include "pipeline/study/matching/matching_evaluation.h"

#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "pipeline/base/statistics/exact_number.h"
#include "pipeline/base/statistics/p_correction.h"

namespace mien::pipeline {

namespace {

std::optional<double> value_of(const MatchingTrial& trial, MatchingMeasure measure) {
  return measure == MatchingMeasure::time_s ? trial.time_s : trial.first_guess_d;
}

double deviation_of(const std::vector<double>& values) {
  if (values.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  const double mean = exact_mean(values);
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
    by_participant.push_back(exact_mean(own));
  }
  const auto add = [&](const std::string& target, const std::vector<double>& values) {
    if (values.empty()) return;
    means.push_back({measure, interface, target, static_cast<int>(values.size()),
                     exact_mean(values), deviation_of(values)});
  };
  add("", by_participant);
  for (const std::string& target : results.targets) add(target, by_target[target]);
}

/// Of one target, or of all where `target` is empty.
MatchingShare share_of(const MatchingResults& results, const std::string& interface,
                       const std::string& target) {
  MatchingShare share;
  share.interface = interface;
  share.target = target;
  for (const MatchingTrial& trial : results.trials) {
    if (trial.interface != interface || (!target.empty() && trial.target != target)) continue;
    ++share.trials;
    share.failures += !trial.success;
    share.guesses += trial.first_guess_d.has_value();
    share.near_guesses += trial.first_guess_d && *trial.first_guess_d < results.threshold_m;
  }
  return share;
}

/// A value a participant, of one target or of all where `target` is empty.
std::vector<double> paired_differences(const ValueTable& first, const ValueTable& second,
                                       const std::string& target) {
  std::vector<double> differences;
  for (const auto& [participant, values] : first) {
    const auto other = second.find(participant);
    if (other == second.end()) continue;
    ExactSum own;
    for (const auto& [of, value] : values) {
      const auto same = other->second.find(of);
      if (same == other->second.end() || (!target.empty() && of != target)) continue;
      own.add(ExactNumber::of(value) - ExactNumber::of(same->second));
    }
    if (own.count > 0) differences.push_back(own.mean().value());
  }
  return differences;
}

MatchingComparison comparison_of(const std::vector<double>& differences) {
  MatchingComparison comparison;
  comparison.difference = paired_t_test(differences);
  comparison.paper = wilcoxon(differences, WilcoxonMode::published);
  comparison.exact = wilcoxon(differences);
  comparison.d_z = cohens_dz(differences);
  // Without variance, t and p are undefined.
  if (all_equal(differences))
    comparison.difference.standard_error = comparison.difference.t = comparison.difference.p =
        comparison.d_z = std::numeric_limits<double>::quiet_NaN();
  return comparison;
}

/// Every pair of interfaces on each of the targets, corrected together.
std::vector<MatchingComparison> compare(const MatchingResults& results, MatchingMeasure measure,
                                        const std::vector<std::string>& targets) {
  std::vector<MatchingComparison> comparisons;
  std::vector<double> paper;
  std::vector<double> exact;
  for (const std::string& target : targets) {
    for (size_t a = 0; a < results.interfaces.size(); ++a) {
      for (size_t b = a + 1; b < results.interfaces.size(); ++b) {
        const std::vector<double> differences =
            paired_differences(values_of(results, measure, results.interfaces[a]),
                               values_of(results, measure, results.interfaces[b]), target);
        if (differences.empty()) continue;
        MatchingComparison comparison = comparison_of(differences);
        comparison.measure = measure;
        comparison.target = target;
        comparison.first = results.interfaces[a];
        comparison.second = results.interfaces[b];
        paper.push_back(comparison.paper.p);
        exact.push_back(comparison.exact.p);
        comparisons.push_back(std::move(comparison));
      }
    }
  }
  paper = holm(paper);
  exact = holm(exact);
  for (size_t i = 0; i < comparisons.size(); ++i) {
    comparisons[i].normal_holm = paper[i];
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
  if (results.targets.size() > 1) evaluation.targets = results.targets;
  for (const auto measure : {MatchingMeasure::first_guess_d, MatchingMeasure::time_s}) {
    for (const std::string& interface : results.interfaces)
      add_means(results, measure, interface, evaluation.means);
    for (const auto& targets : {std::vector<std::string>{""}, evaluation.targets})
      for (MatchingComparison& comparison : compare(results, measure, targets))
        evaluation.comparisons.push_back(std::move(comparison));
  }
  for (const std::string& interface : results.interfaces)
    evaluation.shares.push_back(share_of(results, interface, ""));
  for (const std::string& target : evaluation.targets)
    for (const std::string& interface : results.interfaces)
      evaluation.shares.push_back(share_of(results, interface, target));
  return evaluation;
}

}  // namespace mien::pipeline
