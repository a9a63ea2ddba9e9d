#include <algorithm>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "motion/error.h"
#include "pipeline/study/analysis/analysis.h"

namespace mien::pipeline {

namespace {

constexpr const char* how_to_name = "give one name for each cluster, for example --names pace,size";

void take_given(Analysis& analysis, const ScaleSet& scales, const std::vector<std::string>& given) {
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

/// How much a group and a cluster have in common.
struct Likeness {
  double share;  ///< of both together that both have (Jaccard 1901)
  size_t group;
  size_t cluster;
};

std::vector<Likeness> likenesses(const Analysis& analysis, const ScaleSet& scales) {
  std::vector<Likeness> result;
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
  std::ranges::sort(result, [](const Likeness& a, const Likeness& b) {
    return std::tuple(-a.share, a.group, a.cluster) < std::tuple(-b.share, b.group, b.cluster);
  });
  return result;
}

}  // namespace

void name_clusters(Analysis& analysis, const ScaleSet& scales,
                   const std::vector<std::string>& given) {
  if (!given.empty()) return take_given(analysis, scales, given);
  std::set<size_t> used;
  for (const Likeness& like : likenesses(analysis, scales)) {
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

}  // namespace mien::pipeline
