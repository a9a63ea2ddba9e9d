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
    "metrics/impressions.csv", "a scale and example",
    {{"scale", "", "id of the scale", [](auto& r) { return r.scale.id; }},
     {"low", "", "name of its low end", [](auto& r) { return r.scale.low; }},
     {"high", "", "name of its high end", [](auto& r) { return r.scale.high; }},
     {"example", "", "label of the example",
      [](auto& r) { return r.all.examples[static_cast<std::size_t>(r.example)]; }},
     {"ratings", "", "whose ratings: given (by people) or simulated",
      [](auto& r) { return given_or_simulated(r.all.simulated); }},
     {"answers", "", "how many answers there are; 1 where only a mean was given",
      [](auto& r) { return r.all.count(r.row, r.example); }},
     {"mean", "0–1", "mean answer as a share of the scale: 0 the low end, 1 the high end",
      [](auto& r) { return r.mean(); }},
     {"sd", "0–1",
      "standard deviation of the answers (by n, unless study analyze was told otherwise), same "
      "unit; empty for given means",
      [](auto& r) { return r.deviation(); }},
     {"mean_answer", "scale",
      "mean answer as it was given: on a scale from −2 to 2 negative towards the low end",
      [](auto& r) { return rounded(r.scale.least + r.range() * r.mean()); }},
     {"sd_answer", "scale", "its standard deviation, same unit; empty for given means",
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
