#include "pipeline/study/analysis/analysis_tables.h"

#include <cmath>

#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {

namespace {

std::string ratings_of(const Analysis& analysis) {
  return analysis.impressions.simulated ? "simulated" : "given";
}

std::string number(double value) { return std::isnan(value) ? "" : shortest(value); }

std::string flag(bool value) { return value ? "1" : "0"; }

const std::string& scale_at(const Analysis& analysis, int row) {
  return analysis.impressions.scales[static_cast<size_t>(row)];
}

/// Name of a cluster of the tree: a scale, or the step that made it, counted from 1.
std::string name_of(const Analysis& analysis, int cluster) {
  const int leaves = analysis.linkage.leaves;
  if (cluster >= leaves) return "#" + std::to_string(cluster - leaves + 1);
  return scale_at(analysis, analysis.clustered[static_cast<size_t>(cluster)]);
}

std::string removed_by(const Quantity& q) {
  if (q.neutral && q.disputed) return "neutral+disagreement";
  if (q.neutral) return "neutral";
  return q.disputed ? "disagreement" : "";
}

}  // namespace

std::string quantification_csv(const Analysis& analysis, const ScaleSet& scales) {
  CsvWriter table({"scale", "low", "high", "ratings", "answers", "max_abs_mean", "at_example",
                   "mean_sd", "least_max_abs_mean", "most_mean_sd", "kept", "removed_by"});
  for (size_t j = 0; j < analysis.quantities.size(); ++j) {
    const Quantity& q = analysis.quantities[j];
    const Scale& scale = *find_scale(scales, q.scale);
    table.row({q.scale, scale.low, scale.high, ratings_of(analysis),
               std::to_string(analysis.impressions.count.row(static_cast<Eigen::Index>(j)).sum()),
               number(q.largest_mean),
               analysis.impressions.examples[static_cast<size_t>(q.at_example)],
               number(q.mean_deviation), number(q.thresholds.largest_mean),
               number(q.thresholds.mean_deviation), flag(q.kept()), removed_by(q)});
  }
  return table.text();
}

std::string thresholds_csv(const Analysis& analysis, const ScaleSet& scales,
                           const Thresholds& thresholds) {
  CsvWriter table({"condition", "ratings", "threshold", "kept_by_condition", "kept_by_both"});
  for (const KeptAt& kept : threshold_curve(analysis.quantities, thresholds, scales)) {
    table.row({kept.condition == KeptAt::Condition::largest_mean ? "max_abs_mean" : "mean_sd",
               ratings_of(analysis), number(kept.threshold), std::to_string(kept.by_condition),
               std::to_string(kept.by_both)});
  }
  return table.text();
}

std::string linkage_csv(const Analysis& analysis) {
  CsvWriter table({"step", "first", "second", "size", "members", "ratings", "delta_e", "height"});
  int step = 0;
  for (const Merge& merge : analysis.linkage.merges) {
    std::string members;
    for (const int member : merge.members) {
      if (!members.empty()) members += ' ';
      members += name_of(analysis, member);
    }
    table.row({std::to_string(++step), name_of(analysis, merge.first),
               name_of(analysis, merge.second), std::to_string(merge.members.size()), members,
               ratings_of(analysis), number(merge.increase), number(merge.height)});
  }
  return table.text();
}

std::string clusters_csv(const Analysis& analysis) {
  CsvWriter table({"cluster", "name", "scale", "ratings", "rank", "to_centroid", "basis"});
  int number_of_cluster = 0;
  for (const ScaleCluster& cluster : analysis.clusters) {
    ++number_of_cluster;
    for (size_t m = 0; m < cluster.members.size(); ++m) {
      table.row({std::to_string(number_of_cluster), cluster.name,
                 scale_at(analysis, cluster.members[m]), ratings_of(analysis),
                 std::to_string(m + 1), number(cluster.to_centroid[m]),
                 analysis.none_kept ? "all" : "kept"});
    }
  }
  return table.text();
}

std::string primary_csv(const Analysis& analysis) {
  CsvWriter table({"primary", "example", "ratings", "impression"});
  for (const ScaleCluster& cluster : analysis.clusters) {
    for (Eigen::Index i = 0; i < cluster.mean.size(); ++i) {
      table.row({cluster.name, analysis.impressions.examples[static_cast<size_t>(i)],
                 ratings_of(analysis), number(cluster.mean[i])});
    }
  }
  return table.text();
}

std::string agreement_csv(const Analysis& analysis) {
  CsvWriter table({"scale", "ratings", "raters", "complete_raters", "alpha", "icc_2_k",
                   "answers_per_example", "icc_1_k"});
  for (size_t j = 0; j < analysis.agreements.size(); ++j) {
    const Agreement& a = analysis.agreements[j];
    table.row({analysis.impressions.scales[j], ratings_of(analysis), std::to_string(a.all.raters),
               std::to_string(a.complete_raters), number(a.alpha), number(a.icc_2_k),
               number(a.all.answers_per_stimulus), number(a.all.one_k)});
  }
  return table.text();
}

std::string warnings_csv(const std::vector<StudyWarning>& warnings) {
  CsvWriter table({"kind", "file", "line", "column", "message"});
  const auto count = [](int n) { return n > 0 ? std::to_string(n) : std::string(); };
  for (const StudyWarning& warning : warnings) {
    table.row({warning.kind, warning.place.file, count(warning.place.line),
               count(warning.place.column), warning.text});
  }
  return table.text();
}

}  // namespace mien::pipeline
