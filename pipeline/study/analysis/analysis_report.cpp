#include "pipeline/study/analysis/analysis_report.h"

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/study/analysis/published_clusters.h"
#include "pipeline/study/analysis/quantification.h"
#include "pipeline/study/analysis/scales_yaml.h"

namespace mien::pipeline {

namespace {

BilingualName name_of(const Scale& scale) {
  BilingualName name{scale.low + " – " + scale.high, ""};
  if (!scale.japanese_low.empty()) name.japanese = scale.japanese_low + "–" + scale.japanese_high;
  return name;
}

std::string raters_of(const Analysis& analysis) {
  int most = 0;
  for (const Agreement& a : analysis.agreements) most = std::max(most, a.all.raters);
  if (most == 0) return "mean ratings";
  return fmt::format("{} {}", most, analysis.impressions.simulated ? "simulated raters" : "raters");
}

}  // namespace

Dendrogram dendrogram_of(const Analysis& analysis, const ScaleSet& scales) {
  Dendrogram d;
  d.title = "Clusters of " + (scales.name.empty() ? std::string("the scales") : scales.name);
  const std::string retained =
      analysis.none_retained
          ? fmt::format("all {} scales, none within the thresholds", analysis.clustered.size())
          : fmt::format("{} of {} scales kept", analysis.clustered.size(),
                        analysis.quantities.size());
  d.subtitle = fmt::format("{}; {} examples, {}; Ward's method", retained,
                           analysis.impressions.examples.size(), raters_of(analysis));
  d.linkage = analysis.linkage;
  d.partition = analysis.partition;
  for (const int row : analysis.clustered) {
    const std::string& id = analysis.impressions.scales[static_cast<size_t>(row)];
    d.leaves.push_back(name_of(*find_scale(scales, id)));
  }
  for (const ScaleCluster& cluster : analysis.clusters)
    d.clusters.push_back({cluster.name, cluster.japanese});
  d.simulated = analysis.impressions.simulated;
  return d;
}

void write_analysis(const Analysis& analysis, const ScaleSet& scales, const Thresholds& thresholds,
                    const std::filesystem::path& folder) {
  std::vector<WrittenTable> tables = {
      quantification_table(analysis, scales),
      thresholds_table(analysis, scales, thresholds),
      {impressions_form, impressions_csv(analysis.impressions, scales)},
      linkage_table(analysis),
      clusters_table(analysis),
      primary_table(analysis),
      agreement_table(analysis),
      warnings_table(analysis.warnings)};
  if (const auto published = compare_with_published(analysis); !published.empty())
    tables.push_back(published_table(published, analysis.impressions.simulated));
  write_tables(folder, tables);
  write_file(folder / "clusters.scales.yaml", clusters_yaml(analysis, scales));
  write_plot(dendrogram_plot(dendrogram_of(analysis, scales)), folder, "dendrogram");
  write_plot(
      threshold_chart(threshold_curve(analysis.quantities, thresholds, scales), thresholds,
                      static_cast<int>(analysis.quantities.size()), analysis.impressions.simulated),
      folder, "thresholds");
}

}  // namespace mien::pipeline
