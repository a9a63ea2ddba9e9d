#include "pipeline/study/thresholds/threshold_posterior.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace mien::pipeline {

namespace {

/// The least value up to which the probability is at least `share`; `values` ascend.
double quantile(const std::vector<std::pair<double, double>>& values, double share) {
  double sum = 0.0;
  for (const auto& [value, probability] : values)
    if ((sum += probability) >= share - 1e-12) return value;
  return values.back().first;
}

}  // namespace

ThresholdPosterior threshold_posterior(const QuestPlus& quest, const Eigen::VectorXd& posterior,
                                       double proportion, double credibility) {
  std::vector<std::pair<double, double>> thresholds;  // with their probabilities
  Eigen::Index point = 0;
  double sum = 0.0;
  for (const double location : quest.axes[0].values)
    for (const double width : quest.axes[1].values)
      for (const double guess : quest.axes[2].values)
        for (const double lapse : quest.axes[3].values) {
          const double probability = posterior[point++];
          const double level =
              level_at({Sigmoid::logistic, location, width, guess, lapse}, proportion);
          if (std::isnan(level)) continue;
          thresholds.emplace_back(level, probability);
          sum += probability;
        }
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (!(sum > 0.0)) return {none, none, none, none, 1.0};
  double mean = 0.0, squares = 0.0;
  for (auto& [level, probability] : thresholds) mean += level * (probability /= sum);
  for (const auto& [level, probability] : thresholds)
    squares += probability * std::pow(level - mean, 2.0);
  std::ranges::sort(thresholds);
  return {mean, std::sqrt(squares), quantile(thresholds, 0.5 * (1.0 - credibility)),
          quantile(thresholds, 0.5 * (1.0 + credibility)), 1.0 - sum};
}

}  // namespace mien::pipeline
