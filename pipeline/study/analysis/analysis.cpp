#include "pipeline/study/analysis/analysis.h"

#include <algorithm>
#include <limits>
#include <map>

#include <fmt/format.h>

namespace mien::pipeline {

namespace {

using AnswersByScale = std::map<std::string, std::vector<const StudyAnswer*>>;

/// Of participants; means of several people tell nothing about their agreement.
AnswersByScale answers_by_scale(const StudyAnswers& study) {
  AnswersByScale by_scale;
  for (const StudyAnswer& answer : study.answers)
    if (!answer.participant.empty()) by_scale[answer.scale].push_back(&answer);
  return by_scale;
}

/// Examples × participants, NaN where there is no answer.
Eigen::MatrixXd answer_table(const std::vector<const StudyAnswer*>& answers,
                             const std::vector<std::string>& examples) {
  std::map<std::string, Eigen::Index> rows;
  std::map<std::string, Eigen::Index> columns;
  for (const std::string& example : examples)
    rows.emplace(example, static_cast<Eigen::Index>(rows.size()));
  for (const StudyAnswer* answer : answers)
    columns.emplace(answer->participant, static_cast<Eigen::Index>(columns.size()));
  Eigen::MatrixXd table = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(rows.size()),
                                                    static_cast<Eigen::Index>(columns.size()),
                                                    std::numeric_limits<double>::quiet_NaN());
  for (const StudyAnswer* answer : answers)
    table(rows.at(answer->stimulus), columns.at(answer->participant)) = answer->value;
  return table;
}

void choose_scales(Analysis& analysis, const ScaleSet& scales, const AnalysisOptions& options) {
  for (size_t j = 0; j < analysis.quantities.size(); ++j)
    if (analysis.quantities[j].kept()) analysis.clustered.push_back(static_cast<int>(j));
  if (!analysis.clustered.empty()) return;
  analysis.none_kept = true;
  for (size_t j = 0; j < analysis.quantities.size(); ++j)
    analysis.clustered.push_back(static_cast<int>(j));
  const Thresholds loose = loosened(analysis.quantities, options.thresholds, scales);
  analysis.suggested = loose;
  analysis.warnings.push_back(
      {"thresholds",
       {},
       fmt::format(
           "the thresholds (largest mean at least {}, mean SD at most {}) remove all scales; "
           "--max-mean {} --max-sd {} would keep at least half of them. All scales were clustered",
           options.thresholds.largest_mean, options.thresholds.mean_deviation, loose.largest_mean,
           loose.mean_deviation)});
}

Eigen::MatrixXd clustered_rows(const Analysis& analysis) {
  return analysis.impressions.mean(analysis.clustered, Eigen::all);
}

void choose_cut(Analysis& analysis, const AnalysisOptions& options) {
  analysis.linkage = ward(clustered_rows(analysis));
  analysis.suggested_clusters = clusters_by_largest_gap(analysis.linkage);
  int clusters = options.clusters.value_or(analysis.suggested_clusters);
  if (clusters > analysis.linkage.leaves) {
    analysis.warnings.push_back(
        {"clusters",
         {},
         fmt::format(
             "{} clusters requested, but there are only {} scales; each scale forms a cluster",
             clusters, analysis.linkage.leaves)});
    clusters = analysis.linkage.leaves;
  }
  analysis.partition = cut(analysis.linkage, clusters);
}

ScaleCluster cluster_of(const Analysis& analysis, int group) {
  const Eigen::MatrixXd& a = analysis.impressions.mean;
  std::vector<int> rows;
  for (size_t leaf = 0; leaf < analysis.clustered.size(); ++leaf)
    if (analysis.partition.group[leaf] == group) rows.push_back(analysis.clustered[leaf]);
  ScaleCluster cluster;
  cluster.mean = a(rows, Eigen::all).colwise().mean();
  const auto distance = [&](int row) { return (a.row(row) - cluster.mean).norm(); };
  std::ranges::stable_sort(rows, {}, distance);
  for (const int row : rows) cluster.to_centroid.push_back(distance(row));
  cluster.members = std::move(rows);
  return cluster;
}

}  // namespace

Analysis analyse(const StudyAnswers& answers, const ScaleSet& scales,
                 const std::vector<RatedExample>& examples, const AnalysisOptions& options) {
  Analysis analysis;
  analysis.warnings = answers.warnings;
  analysis.impressions = impressions_of(answers.plain(), scales, examples);
  analysis.quantities =
      quantify(analysis.impressions, scales, options.thresholds, options.deviation);
  AnswersByScale by_scale = answers_by_scale(answers);
  for (const std::string& scale : analysis.impressions.scales)
    analysis.agreements.push_back(
        agreement_of(answer_table(by_scale[scale], analysis.impressions.examples)));
  choose_scales(analysis, scales, options);
  choose_cut(analysis, options);
  for (int group = 0; group < analysis.partition.groups; ++group)
    analysis.clusters.push_back(cluster_of(analysis, group));
  name_clusters(analysis, scales, options.names);
  return analysis;
}

}  // namespace mien::pipeline
