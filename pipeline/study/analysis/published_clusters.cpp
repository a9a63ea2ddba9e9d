#include "pipeline/study/analysis/published_clusters.h"

#include <algorithm>
#include <optional>

#include "pipeline/manifest/ratings/words/adjective_pairs.h"

namespace mien::pipeline {

namespace {

using PublishedCluster = std::optional<Primary> AdjectivePair::*;

PublishedComparison compare(const Analysis& analysis, PublishedCluster table,
                            const std::string& name) {
  PublishedComparison result;
  result.table = name;
  Partition here{{}, analysis.partition.groups};
  Partition there{{}, primary_count};
  int same = 0;
  for (size_t j = 0; j < analysis.quantities.size(); ++j) {
    const auto& published = find_adjective_pair(analysis.quantities[j].scale)->*table;
    const auto leaf = std::ranges::find(analysis.clustered, static_cast<int>(j));
    const bool retained = leaf != analysis.clustered.end();
    same += retained == published.has_value();
    if (retained && published) {
      here.group.push_back(
          analysis.partition.group[static_cast<size_t>(leaf - analysis.clustered.begin())]);
      there.group.push_back(static_cast<int>(*published));
    }
    result.retained_only_here += retained && !published;
    result.retained_only_published += !retained && published;
  }
  result.retained_in_both = static_cast<int>(here.group.size());
  result.retention_agreement = same / static_cast<double>(analysis.quantities.size());
  result.rand = rand_index(here, there);
  result.adjusted_rand = adjusted_rand_index(here, there);
  return result;
}

constexpr auto published_columns = table_of<WithOrigin<PublishedComparison>>(
    "published.csv", "table of the adjective paper",
    {{"table", "", "Table 2 or Table 3", [](auto& r) { return r.of.table; }},
     whose_ratings_column,
     {"kept_in_both", "", "number of pairs kept both here and in the paper",
      [](auto& r) { return r.of.retained_in_both; }},
     {"kept_only_here", "", "number of pairs kept only here",
      [](auto& r) { return r.of.retained_only_here; }},
     {"kept_only_there", "", "number of pairs kept only in the paper",
      [](auto& r) { return r.of.retained_only_published; }},
     {"kept_agreement", "0–1", "proportion of pairs that both keep or both remove",
      [](auto& r) { return r.of.retention_agreement; }},
     {"rand", "0–1", "Rand index over the pairs kept in both", [](auto& r) { return r.of.rand; }},
     {"adjusted_rand", "-1–1", "adjusted Rand index", [](auto& r) { return r.of.adjusted_rand; }}});

}  // namespace

std::vector<PublishedComparison> compare_with_published(const Analysis& analysis) {
  for (const Quantity& q : analysis.quantities)
    if (find_adjective_pair(q.scale) == nullptr) return {};
  return {compare(analysis, &AdjectivePair::table_2, "Table 2"),
          compare(analysis, &AdjectivePair::table_3, "Table 3")};
}

WrittenTable published_table(const std::vector<PublishedComparison>& comparisons, bool simulated) {
  return published_columns.of_parts(simulated, comparisons);
}

}  // namespace mien::pipeline
