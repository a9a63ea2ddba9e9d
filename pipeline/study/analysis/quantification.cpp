#include "pipeline/study/analysis/quantification.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mien::pipeline {

namespace {

/// Units of the scale that are one unit of a scale from −2 to 2.
double unit_of(const Scale& scale) { return (scale.most - scale.least) / 4.0; }

/// A quantity as if its scale went from −2 to 2.
struct Normal {
  double largest_mean;
  double mean_deviation;

  // Rounding must not remove what is exactly at a threshold; an unknown deviation passes.
  bool passes_mean(double threshold) const { return !(largest_mean < threshold - 1e-12); }
  bool passes_deviation(double threshold) const { return !(mean_deviation > threshold + 1e-12); }
};

Normal normalised(const Quantity& q, const Scale& scale) {
  return {q.largest_mean / unit_of(scale), q.mean_deviation / unit_of(scale)};
}

std::vector<Normal> normalised(const std::vector<Quantity>& quantities, const ScaleSet& scales) {
  std::vector<Normal> result;
  for (const Quantity& q : quantities)
    result.push_back(normalised(q, *find_scale(scales, q.scale)));
  return result;
}

/// Factor by which the thresholds must be relaxed to retain this scale.
double factor_for(const Normal& q, const Thresholds& thresholds) {
  double factor = 1.0;
  if (!q.passes_mean(thresholds.largest_mean))
    factor = q.largest_mean > 0.0 ? thresholds.largest_mean / q.largest_mean
                                  : std::numeric_limits<double>::infinity();
  if (!q.passes_deviation(thresholds.mean_deviation))
    factor = std::max(factor, thresholds.mean_deviation > 0.0
                                  ? q.mean_deviation / thresholds.mean_deviation
                                  : std::numeric_limits<double>::infinity());
  return factor;
}

}  // namespace

std::vector<Quantity> quantify(const Impressions& impressions, const ScaleSet& scales,
                               const Thresholds& thresholds, Deviation deviation) {
  std::vector<Quantity> quantities;
  for (Eigen::Index j = 0; j < impressions.mean.rows(); ++j) {
    Quantity q;
    q.scale = impressions.scales[static_cast<size_t>(j)];
    const Scale& scale = *find_scale(scales, q.scale);
    const double width = scale.most - scale.least;
    Eigen::Index example = 0;
    q.largest_mean = width * (impressions.mean.row(j).array() - 0.5).abs().maxCoeff(&example);
    q.extreme_example = static_cast<int>(example);
    Eigen::ArrayXd deviations = width * impressions.deviation.row(j).transpose().array();
    if (deviation == Deviation::sample) {
      const Eigen::ArrayXd n = impressions.count.row(j).transpose().cast<double>();
      deviations *= (n / (n - 1.0)).sqrt();
      // A single answer has no deviation; examples with one are left out.
      const Eigen::ArrayXd known = (n > 1.0).cast<double>();
      q.mean_deviation = (n > 1.0).select(deviations, 0.0).sum() / known.sum();
    } else {
      q.mean_deviation = deviations.mean();
    }
    q.thresholds = {thresholds.largest_mean * unit_of(scale),
                    thresholds.mean_deviation * unit_of(scale)};
    q.neutral = !normalised(q, scale).passes_mean(thresholds.largest_mean);
    q.disputed = !normalised(q, scale).passes_deviation(thresholds.mean_deviation);
    quantities.push_back(q);
  }
  return quantities;
}

std::vector<ThresholdPoint> threshold_curve(const std::vector<Quantity>& quantities,
                                            const Thresholds& thresholds, const ScaleSet& scales) {
  constexpr int steps = 40;
  const std::vector<Normal> normals = normalised(quantities, scales);
  std::vector<ThresholdPoint> curve;
  for (const auto condition :
       {ThresholdPoint::Condition::largest_mean, ThresholdPoint::Condition::mean_deviation}) {
    const bool mean = condition == ThresholdPoint::Condition::largest_mean;
    for (int step = 0; step <= steps; ++step) {
      ThresholdPoint retained{condition, step / 20.0};
      for (const Normal& q : normals) {
        const bool by_mean = q.passes_mean(mean ? retained.threshold : thresholds.largest_mean);
        const bool by_deviation =
            q.passes_deviation(mean ? thresholds.mean_deviation : retained.threshold);
        retained.by_condition += mean ? by_mean : by_deviation;
        retained.by_both += by_mean && by_deviation;
      }
      curve.push_back(retained);
    }
  }
  return curve;
}

Thresholds loosened_thresholds(const std::vector<Quantity>& quantities,
                               const Thresholds& thresholds, const ScaleSet& scales) {
  std::vector<double> factors;
  for (const Normal& q : normalised(quantities, scales)) {
    const double factor = factor_for(q, thresholds);
    if (std::isfinite(factor)) factors.push_back(factor);
  }
  if (factors.empty()) return thresholds;
  std::sort(factors.begin(), factors.end());
  const double factor = factors[std::min((quantities.size() + 1) / 2, factors.size()) - 1];
  if (factor == 1.0) return thresholds;
  Thresholds loose;
  loose.largest_mean = std::floor(100.0 * thresholds.largest_mean / factor) / 100.0;
  loose.mean_deviation = std::ceil(100.0 * thresholds.mean_deviation * factor) / 100.0;
  const std::vector<Normal> normals = normalised(quantities, scales);
  if (std::ranges::all_of(normals,
                          [&](const Normal& q) { return q.passes_mean(thresholds.largest_mean); }))
    loose.largest_mean = thresholds.largest_mean;
  if (std::ranges::all_of(normals, [&](const Normal& q) {
        return q.passes_deviation(thresholds.mean_deviation);
      })) {
    loose.mean_deviation = thresholds.mean_deviation;
  }
  return loose;
}

}  // namespace mien::pipeline
