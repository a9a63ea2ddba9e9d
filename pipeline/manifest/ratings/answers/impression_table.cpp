#include "pipeline/manifest/ratings/answers/impression_table.h"

#include <cmath>
#include <vector>

namespace mien::pipeline {

namespace {

/// What people think of one example on one scale.
struct Impression {
  const Impressions& all;
  const Scale& scale;
  Eigen::Index row;
  Eigen::Index example;

  double mean() const { return all.mean(row, example); }
  double deviation() const { return all.deviation(row, example); }
  double range() const { return scale.most - scale.least; }
};

/// Without the last digits, in which a range leaves its traces.
double rounded(double value) { return std::round(1e9 * value) / 1e9; }

constexpr auto impressions_columns = table_of<Impression>(
    "metrics/impressions.csv", "scale and example",
    {{"scale", "", "id of the scale", [](auto& r) { return r.scale.id; }},
     {"low", "", "name of its low end", [](auto& r) { return r.scale.low; }},
     {"high", "", "name of its high end", [](auto& r) { return r.scale.high; }},
     {"example", "", "example label",
      [](auto& r) { return r.all.examples[static_cast<std::size_t>(r.example)]; }},
     {"ratings", "", "source of the ratings: given (by people) or simulated",
      [](auto& r) { return given_or_simulated(r.all.simulated); }},
     {"answers", "", "number of answers; 1 if only a mean was given",
      [](auto& r) { return r.all.count(r.row, r.example); }},
     {"mean", "0–1", "mean answer rescaled to 0 (low end) to 1 (high end)",
      [](auto& r) { return r.mean(); }},
     {"sd", "0–1",
      "standard deviation of the answers on the same scale (divisor n, unless mien study analyze "
      "was called with another); empty for given means",
      [](auto& r) { return r.deviation(); }},
     {"mean_answer", "scale",
      "mean answer in the units of the scale; on a scale from −2 to 2, negative towards the low "
      "end",
      [](auto& r) { return rounded(r.scale.least + r.range() * r.mean()); }},
     {"sd_answer", "scale", "its standard deviation in the same unit; empty for given means",
      [](auto& r) { return rounded(r.range() * r.deviation()); }}});

}  // namespace

const TableForm impressions_form = impressions_columns.form();

std::string impressions_csv(const Impressions& impressions, const ScaleSet& scales) {
  std::vector<Impression> rows;
  for (Eigen::Index row = 0; row < impressions.mean.rows(); ++row) {
    const std::string& scale = impressions.scales[static_cast<std::size_t>(row)];
    for (Eigen::Index example = 0; example < impressions.mean.cols(); ++example)
      rows.push_back({impressions, *find_scale(scales, scale), row, example});
  }
  return impressions_columns.of(rows).csv;
}

}  // namespace mien::pipeline
