#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "pipeline/base/documents/table.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/manifest/reading/example_source.h"
#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/study/analysis/feature_clusters.h"

namespace mien::pipeline {

namespace {

struct FeaturesOptions {
  StudySubject subject;
  int clusters = motion::feature_group_count;
  motion::FeatureScaling scaling = motion::FeatureScaling::min_max;
  std::string out;
};

void write_all(const FeatureClusters& clusters, const Repertoire& repertoire,
               const std::filesystem::path& folder) {
  std::vector<std::string> examples;
  for (const RatedExample& example : repertoire.names) examples.push_back(example.name);
  write_tables(folder, {scaled_features_table(clusters, examples), feature_linkage_table(clusters),
                        feature_clusters_table(clusters)});
  write_plot(dendrogram_plot(dendrogram_of(clusters)), folder, "dendrogram");
}

int cluster(const FeaturesOptions& options, const Console& console) {
  Manifest manifest = manifest_of(options.subject, console);
  manifest.ratings.source = Ratings::Source::none;
  const Repertoire repertoire = load_repertoire(manifest);
  const FeatureClusters clusters =
      cluster_features(repertoire.features, options.clusters, options.scaling);
  write_all(clusters, repertoire, options.out);
  fmt::memory_buffer text;
  const auto out = fmt::appender(text);
  fmt::format_to(out, "{} clusters of {} features; the largest gap suggests {}\n",
                 clusters.partition.groups, clusters.features.size(), clusters.suggested_clusters);
  for (int c = 0; c < clusters.partition.groups; ++c) {
    const auto members =
        std::count(clusters.partition.group.begin(), clusters.partition.group.end(), c);
    fmt::format_to(out, "  {:18} {:2} features\n", clusters.names[static_cast<std::size_t>(c)],
                   members);
  }
  fmt::format_to(out, "published groups: Rand {:.3f}, adjusted {:.3f}\n{}\n", clusters.rand,
                 clusters.adjusted_rand, options.out);
  console.out << fmt::to_string(text);
  return exit_done;
}

}  // namespace

Command study_features_command() {
  const auto options = std::make_shared<FeaturesOptions>();
  return {
      .name = "features",
      .summary = "Cluster the motion features of a set of examples",
      .options = all_of(option("--examples", &options->subject.examples,
                               std::string("Examples: a manifest, ") + examples_help)
                            .required(),
                        recording_options(options->subject.recording),
                        option("--clusters", &options->clusters, "Number of clusters")
                            .between(1, motion::motion_feature_count)
                            .with_default(),
                        choice("--scaling", options->scaling,
                               {{"min-max", motion::FeatureScaling::min_max},
                                {"z-score", motion::FeatureScaling::z_score}},
                               "Normalize features over the examples to 0 … 1, or to z-scores"),
                        option("-o,--output", &options->out, "Folder for the results").required()),
      .notes =
          "Writes features.csv, linkage.csv, clusters.csv and dendrogram.pdf, .svg, .png, and "
          "prints the agreement\n"
          "of the clusters with the four published groups, used by `features:` in a manifest.\n\n"
          "Example:\n"
          "  mien study features --examples builtin:walks-27 -o out/features",
      .run = [options](const Console& console) { return cluster(*options, console); }};
}

}  // namespace mien::pipeline
