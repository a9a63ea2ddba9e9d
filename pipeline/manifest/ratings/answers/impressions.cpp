#include "pipeline/manifest/ratings/answers/impressions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "motion/error.h"

namespace mien::pipeline {

namespace {

/// Sums of the answers about one example on one scale.
struct Tally {
  int count = 0;
  double sum = 0.0;
  double mean = 0.0;     // running, for `squares` alone
  double squares = 0.0;  // of the departures from the mean

  /// Welford 1962: exactly 0 where all answers are equal.
  void add(double share) {
    ++count;
    sum += share;
    const double before = share - mean;
    mean += before / count;
    squares += before * (share - mean);
  }
};

std::map<std::string, Eigen::Index> columns_of(const std::vector<RatedExample>& examples) {
  std::map<std::string, Eigen::Index> columns;
  for (size_t i = 0; i < examples.size(); ++i) {
    columns.emplace(examples[i].name, static_cast<Eigen::Index>(i));
    if (!examples[i].file_stem.empty()) {
      columns.emplace(examples[i].file_stem, static_cast<Eigen::Index>(i));
    }
  }
  return columns;
}

std::string some_of(const std::vector<std::string>& names) {
  constexpr size_t most = 5;
  std::string text;
  for (size_t i = 0; i < std::min(most, names.size()); ++i) {
    text += fmt::format("{}\"{}\"", i ? ", " : "", names[i]);
  }
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return text;
}

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
      [](auto& r) { return origin_text(r.all.simulated); }},
     {"answers", "", "number of answers; 1 if only a mean was given",
      [](auto& r) { return r.all.count(r.row, r.example); }},
     {"mean", "0–1", "mean answer rescaled to 0 (low end) to 1 (high end)",
      [](auto& r) { return r.mean(); }},
     {"sd", "0–1",
      "standard deviation of the answers rescaled to 0–1 (divisor n; in the table of mien study "
      "analyze, that chosen by --sd); empty for given means",
      [](auto& r) { return r.deviation(); }},
     {"mean_answer", "scale",
      "mean answer in the units of the scale; on a scale from −2 to 2, negative towards the low "
      "end",
      [](auto& r) { return rounded(r.scale.least + r.range() * r.mean()); }},
     {"sd_answer", "scale",
      "standard deviation of the answers in the same units; empty for given means",
      [](auto& r) { return rounded(r.range() * r.deviation()); }}});

}  // namespace

Impressions impressions_of(const Answers& answers, const ScaleSet& scales,
                           const std::vector<RatedExample>& examples) {
  const auto columns = columns_of(examples);
  const auto known = scales_by_id(scales);
  std::map<std::string, std::vector<Tally>> tallies;
  bool means_only = true;
  for (const Answer& answer : answers.answers) {
    const auto column = columns.find(answer.stimulus);
    if (column == columns.end()) continue;
    auto& row = tallies[answer.scale];
    row.resize(examples.size());
    Tally& tally = row[static_cast<size_t>(column->second)];
    tally.add(share_of(*known.at(answer.scale), answer.value));
    if (!answer.participant.empty()) means_only = false;
  }

  Impressions result;
  result.simulated = answers.simulated;
  for (const RatedExample& example : examples) result.examples.push_back(example.name);
  for (const Scale& scale : scales.scales) {
    if (tallies.count(scale.id)) result.scales.push_back(scale.id);
  }
  const auto rows = static_cast<Eigen::Index>(result.scales.size());
  const auto cols = static_cast<Eigen::Index>(examples.size());
  result.mean.resize(rows, cols);
  result.deviation.resize(rows, cols);
  result.count.resize(rows, cols);
  std::vector<std::string> unrated;
  for (Eigen::Index j = 0; j < rows; ++j) {
    const auto& row = tallies.at(result.scales[static_cast<size_t>(j)]);
    for (Eigen::Index i = 0; i < cols; ++i) {
      const Tally& tally = row[static_cast<size_t>(i)];
      if (tally.count == 0) {
        unrated.push_back(fmt::format("{} on {}", examples[static_cast<size_t>(i)].name,
                                      result.scales[static_cast<size_t>(j)]));
        continue;
      }
      result.mean(j, i) = tally.sum / tally.count;
      result.count(j, i) = tally.count;
      result.deviation(j, i) = means_only ? std::numeric_limits<double>::quiet_NaN()
                                          : std::sqrt(tally.squares / tally.count);
    }
  }
  if (rows == 0) {
    throw Error("none of the ratings are about the examples",
                "name examples or their files (without extension) in the column \"stimulus\"");
  }
  if (!unrated.empty()) {
    throw Error(fmt::format("no answer about {}", some_of(unrated)),
                "rate them, or omit these examples (exclude: of a folder of examples)");
  }
  return result;
}

ParameterTable parameter_table(const Impressions& impressions, const ScaleSet& scales) {
  ParameterTable table;
  table.simulated = impressions.simulated;
  std::vector<Eigen::RowVectorXd> rows;
  const auto row_of = [&](const std::string& scale) -> Eigen::Index {
    const auto found = std::find(impressions.scales.begin(), impressions.scales.end(), scale);
    return found == impressions.scales.end() ? -1 : found - impressions.scales.begin();
  };
  for (const ScaleGroup& group : scales.groups) {
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(impressions.mean.cols());
    int members = 0;
    for (const std::string& scale : group.scales) {
      const Eigen::Index row = row_of(scale);
      if (row < 0) continue;
      sum += impressions.mean.row(row);
      ++members;
    }
    if (members == 0) continue;
    table.names.push_back(group.id);
    rows.emplace_back(sum / members);
  }
  for (size_t j = 0; j < impressions.scales.size(); ++j) {
    table.names.push_back(impressions.scales[j]);
    rows.emplace_back(impressions.mean.row(static_cast<Eigen::Index>(j)));
  }
  table.values.resize(static_cast<Eigen::Index>(rows.size()), impressions.mean.cols());
  for (size_t r = 0; r < rows.size(); ++r) {
    table.values.row(static_cast<Eigen::Index>(r)) = rows[r];
  }
  return table;
}

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
