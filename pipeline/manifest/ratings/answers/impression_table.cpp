#include "pipeline/manifest/ratings/answers/impression_table.h"

#include <cmath>

namespace mien::pipeline {

namespace {

std::string unless_unknown(double value) { return std::isnan(value) ? "" : shortest(value); }

/// Without the last digits, in which a range leaves its traces.
double rounded(double value) { return std::round(1e9 * value) / 1e9; }

}  // namespace

std::string impressions_csv(const Impressions& impressions, const ScaleSet& scales) {
  CsvWriter table = table_of(impressions_form);
  const std::string ratings = impressions.simulated ? "simulated" : "given";
  for (Eigen::Index j = 0; j < impressions.mean.rows(); ++j) {
    const Scale& scale = *find_scale(scales, impressions.scales[static_cast<std::size_t>(j)]);
    const double range = scale.most - scale.least;
    for (Eigen::Index i = 0; i < impressions.mean.cols(); ++i) {
      const double mean = impressions.mean(j, i), sd = impressions.deviation(j, i);
      table.row({scale.id, scale.low, scale.high, impressions.examples[static_cast<std::size_t>(i)],
                 ratings, std::to_string(impressions.count(j, i)), shortest(mean),
                 unless_unknown(sd), shortest(rounded(scale.least + range * mean)),
                 unless_unknown(rounded(range * sd))});
    }
  }
  return table.text();
}

std::string no_impressions_csv() { return table_of(impressions_form).text(); }

}  // namespace mien::pipeline
