#include "pipeline/study/analysis/analysis.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "motion/error.h"

namespace mien::pipeline {

namespace {

constexpr const char* how_to_name = "give one name for each cluster, for example --names pace,size";

void assign_names(Analysis& analysis, const ScaleSet& scales,
                  const std::vector<std::string>& given) {
  if (given.size() != analysis.clusters.size())
    throw Error(
        fmt::format("--names: {} names for {} clusters", given.size(), analysis.clusters.size()),
        how_to_name);
  std::set<std::string> taken;
  for (size_t c = 0; c < given.size(); ++c) {
    const std::string& name = given[c];
    if (name.empty()) throw Error("--names: an empty name", how_to_name);
    if (!taken.insert(name).second)
      throw Error(fmt::format("--names: \"{}\" appears twice", name), how_to_name);
    if (find_scale(scales, name) != nullptr)
      throw Error(fmt::format("--names: \"{}\" is a scale", name),
                  "use another name for the cluster");
    analysis.clusters[c].name = name;
    for (const ScaleGroup& group : scales.groups)
      if (group.id == name) analysis.clusters[c].japanese = group.japanese;
  }
}

/// Similarity of a group and a cluster.
struct GroupSimilarity {
  double share;  ///< Jaccard index (Jaccard 1901)
  size_t group;
  size_t cluster;
};

std::vector<GroupSimilarity> similarities(const Analysis& analysis, const ScaleSet& scales) {
  std::vector<GroupSimilarity> result;
  for (size_t g = 0; g < scales.groups.size(); ++g) {
    const std::set<std::string> group(scales.groups[g].scales.begin(),
                                      scales.groups[g].scales.end());
    for (size_t c = 0; c < analysis.clusters.size(); ++c) {
      const std::vector<int>& members = analysis.clusters[c].members;
      const auto common = std::ranges::count_if(members, [&](int row) {
        return group.contains(analysis.impressions.scales[static_cast<size_t>(row)]);
      });
      if (common == 0) continue;
      const auto both = static_cast<double>(common);
      const double either = static_cast<double>(group.size() + members.size()) - both;
      result.push_back({both / either, g, c});
    }
  }
  std::ranges::sort(result, [](const GroupSimilarity& a, const GroupSimilarity& b) {
    return std::tuple(-a.share, a.group, a.cluster) < std::tuple(-b.share, b.group, b.cluster);
  });
  return result;
}

using AnswersByScale = std::map<std::string, std::vector<const StudyAnswer*>>;

/// Answers of single participants; means of several say nothing about agreement.
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
    if (analysis.quantities[j].retained()) analysis.clustered.push_back(static_cast<int>(j));
  if (!analysis.clustered.empty()) return;
  analysis.none_retained = true;
  for (size_t j = 0; j < analysis.quantities.size(); ++j)
    analysis.clustered.push_back(static_cast<int>(j));
  const Thresholds loose = loosened_thresholds(analysis.quantities, options.thresholds, scales);
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

void name_clusters(Analysis& analysis, const ScaleSet& scales,
                   const std::vector<std::string>& given) {
  if (!given.empty()) return assign_names(analysis, scales, given);
  std::set<size_t> used;
  for (const GroupSimilarity& like : similarities(analysis, scales)) {
    ScaleCluster& cluster = analysis.clusters[like.cluster];
    if (!cluster.name.empty() || !used.insert(like.group).second) continue;
    cluster.name = scales.groups[like.group].id;
    cluster.japanese = scales.groups[like.group].japanese;
  }
  for (size_t c = 0; c < analysis.clusters.size(); ++c)
    if (analysis.clusters[c].name.empty())
      analysis.clusters[c].name = fmt::format("cluster-{}", c + 1);
}

std::string central_words(const Analysis& analysis, const ScaleCluster& cluster,
                          const ScaleSet& scales, int words) {
  std::string text;
  for (size_t m = 0; m < std::min(cluster.members.size(), static_cast<size_t>(words)); ++m) {
    const auto row = static_cast<size_t>(cluster.members[m]);
    if (m > 0) text += ", ";
    text += find_scale(scales, analysis.impressions.scales[row])->high;
  }
  return text;
}

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
