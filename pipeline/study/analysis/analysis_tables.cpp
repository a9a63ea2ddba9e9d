#include <cstddef>
#include <numeric>
#include <optional>

#include "pipeline/study/analysis/analysis_report.h"

namespace mien::pipeline {

namespace {

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

struct ScaleQuantity {
  const Analysis& all;
  const Scale& scale;
  std::size_t row;

  const Quantity& of() const { return all.quantities[row]; }
};

struct ThresholdRow {
  const Analysis& all;
  const ThresholdPoint& of;
};

struct MergeRow {
  const Analysis& all;
  std::size_t step;  ///< from 0

  const Merge& of() const { return all.linkage.merges[step]; }
  std::string members() const {
    std::string names;
    for (const int member : of().members)
      names += (names.empty() ? "" : " ") + name_of(all, member);
    return names;
  }
};

struct ClusteredScale {
  const Analysis& all;
  std::size_t cluster;
  std::size_t member;

  const ScaleCluster& of() const { return all.clusters[cluster]; }
};

struct PrimaryImpression {
  const Analysis& all;
  const ScaleCluster& of;
  Eigen::Index example;
};

struct ScaleAgreement {
  const Analysis& all;
  std::size_t row;

  const Agreement& of() const { return all.agreements[row]; }
};

constexpr SharedColumn ratings_column{"ratings", "", "given (by people) or simulated", [](auto& r) {
                                        return origin_text(r.all.impressions.simulated);
                                      }};

constexpr auto quantification_columns = table_of<ScaleQuantity>(
    "quantification.csv", "scale",
    {{"scale", "", "id of the scale", [](auto& r) { return r.scale.id; }},
     {"low", "", "name of its low end", [](auto& r) { return r.scale.low; }},
     {"high", "", "name of its high end", [](auto& r) { return r.scale.high; }},
     ratings_column,
     {"answers", "", "number of answers",
      [](auto& r) { return r.all.impressions.count.row(static_cast<Eigen::Index>(r.row)).sum(); }},
     {"max_abs_mean", "scale", "largest distance of an example's mean from the middle",
      [](auto& r) { return r.of().largest_mean; }},
     {"at_example", "", "example with that mean",
      [](auto& r) {
        return r.all.impressions.examples[static_cast<size_t>(r.of().extreme_example)];
      }},
     {"mean_sd", "scale", "mean over the examples of the answers' SD; empty for given means",
      [](auto& r) { return r.of().mean_deviation; }},
     {"least_max_abs_mean", "scale", "threshold of max_abs_mean on this scale",
      [](auto& r) { return r.of().thresholds.largest_mean; }},
     {"most_mean_sd", "scale", "threshold of mean_sd on this scale",
      [](auto& r) { return r.of().thresholds.mean_deviation; }},
     {"kept", "0/1", "1: the scale is kept", [](auto& r) { return r.of().retained(); }},
     {"removed_by", "", "neutral, disagreement, neutral+disagreement or empty",
      [](auto& r) { return removed_by(r.of()); }}});

constexpr auto thresholds_columns = table_of<ThresholdRow>(
    "thresholds.csv", "condition and threshold",
    {{"condition", "", "max_abs_mean or mean_sd",
      [](auto& r) {
        return r.of.condition == ThresholdPoint::Condition::largest_mean ? "max_abs_mean"
                                                                         : "mean_sd";
      }},
     ratings_column,
     {"threshold", "", "for answers from −2 to 2", [](auto& r) { return r.of.threshold; }},
     {"kept_by_condition", "", "scales that this condition keeps",
      [](auto& r) { return r.of.by_condition; }},
     {"kept_by_both", "", "scales that both conditions keep",
      [](auto& r) { return r.of.by_both; }}});

constexpr auto linkage_columns = table_of<MergeRow>(
    "linkage.csv", "merge of two clusters",
    {{"step", "", "number of the merge, from 1", [](auto& r) { return r.step + 1; }},
     {"first", "", "a scale, or a cluster: #3 is that made in step 3",
      [](auto& r) { return name_of(r.all, r.of().first); }},
     {"second", "", "the scale or cluster merged with it",
      [](auto& r) { return name_of(r.all, r.of().second); }},
     {"size", "", "number of scales in the new cluster",
      [](auto& r) { return r.of().members.size(); }},
     {"members", "", "ids of these scales, separated by spaces",
      [](auto& r) { return r.members(); }},
     ratings_column,
     {"delta_e", "", "ΔE: growth of the error sum of squares (Ward)",
      [](auto& r) { return r.of().increase; }},
     {"height", "", "√(2ΔE): height in the dendrogram", [](auto& r) { return r.of().height; }}});

constexpr auto clusters_columns = table_of<ClusteredScale>(
    "clusters.csv", "clustered scale",
    {{"cluster", "", "from 1, along the dendrogram", [](auto& r) { return r.cluster + 1; }},
     {"name", "", "name of the cluster", [](auto& r) { return r.of().name; }},
     {"scale", "", "id of the scale",
      [](auto& r) { return scale_at(r.all, r.of().members[r.member]); }},
     ratings_column,
     {"rank", "", "rank by distance from the centroid, 1 the nearest",
      [](auto& r) { return r.member + 1; }},
     {"to_centroid", "", "distance from the centroid",
      [](auto& r) { return r.of().to_centroid[r.member]; }},
     {"basis", "", "kept: clusters of the kept scales; all: none was kept",
      [](auto& r) { return r.all.none_retained ? "all" : "kept"; }}});

constexpr auto primary_columns = table_of<PrimaryImpression>(
    "primary.csv", "cluster and example: the matrix A′",
    {{"primary", "", "name of the cluster", [](auto& r) { return r.of.name; }},
     {"example", "", "example label",
      [](auto& r) { return r.all.impressions.examples[static_cast<size_t>(r.example)]; }},
     ratings_column,
     {"impression", "0–1", "mean over the cluster's scales: 0 the low end, 1 the high end",
      [](auto& r) { return r.of.mean[r.example]; }}});

constexpr auto agreement_columns = table_of<ScaleAgreement>(
    "agreement.csv", "scale",
    {{"scale", "", "id of the scale", [](auto& r) { return r.all.impressions.scales[r.row]; }},
     ratings_column,
     {"raters", "", "number of people who rated any example",
      [](auto& r) { return r.of().all.raters; }},
     {"complete_raters", "", "number of people who rated every example",
      [](auto& r) { return r.of().complete_raters; }},
     {"alpha", "", "Cronbach's alpha over the people who rated every example",
      [](auto& r) { return r.of().alpha; }},
     {"icc_2_k", "", "ICC(2,k) over the people who rated every example",
      [](auto& r) { return r.of().icc_2_k; }},
     {"answers_per_example", "", "k of icc_1_k",
      [](auto& r) { return r.of().all.answers_per_stimulus; }},
     {"icc_1_k", "", "ICC(1,k) of all answers; empty where undefined",
      [](auto& r) { return r.of().all.one_k; }}});

/// Lines and columns count from 1.
std::optional<int> counted(int n) { return n > 0 ? std::optional(n) : std::nullopt; }

constexpr auto warnings_columns = table_of<StudyWarning>(
    "warnings.csv", "warning",
    {{"kind", "", "kind of warning", [](auto& r) { return r.kind; }},
     {"file", "", "the file that it is about", [](auto& r) { return r.place.file; }},
     {"line", "", "its line, from 1; empty: the whole file",
      [](auto& r) { return counted(r.place.line); }},
     {"column", "", "the character in that line, from 1",
      [](auto& r) { return counted(r.place.column); }},
     {"message", "", "a sentence", [](auto& r) { return r.text; }}});

std::vector<std::size_t> rows_below(std::size_t count) {
  std::vector<std::size_t> rows(count);
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

}  // namespace

WrittenTable quantification_table(const Analysis& analysis, const ScaleSet& scales) {
  std::vector<ScaleQuantity> rows;
  for (const std::size_t row : rows_below(analysis.quantities.size()))
    rows.push_back({analysis, *find_scale(scales, analysis.quantities[row].scale), row});
  return quantification_columns.of(rows);
}

WrittenTable thresholds_table(const Analysis& analysis, const ScaleSet& scales,
                              const Thresholds& thresholds) {
  return thresholds_columns.of_parts(analysis,
                                     threshold_curve(analysis.quantities, thresholds, scales));
}

WrittenTable linkage_table(const Analysis& analysis) {
  return linkage_columns.of_parts(analysis, rows_below(analysis.linkage.merges.size()));
}

WrittenTable clusters_table(const Analysis& analysis) {
  std::vector<ClusteredScale> rows;
  for (const std::size_t cluster : rows_below(analysis.clusters.size()))
    for (const std::size_t member : rows_below(analysis.clusters[cluster].members.size()))
      rows.push_back({analysis, cluster, member});
  return clusters_columns.of(rows);
}

WrittenTable primary_table(const Analysis& analysis) {
  std::vector<PrimaryImpression> rows;
  for (const ScaleCluster& cluster : analysis.clusters)
    for (Eigen::Index i = 0; i < cluster.mean.size(); ++i) rows.push_back({analysis, cluster, i});
  return primary_columns.of(rows);
}

WrittenTable agreement_table(const Analysis& analysis) {
  return agreement_columns.of_parts(analysis, rows_below(analysis.agreements.size()));
}

WrittenTable warnings_table(const std::vector<StudyWarning>& warnings) {
  return warnings_columns.of(warnings);
}

}  // namespace mien::pipeline
