#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "motion/formats/motion_file.h"
#include "motion/measures/features/expressive_features.h"
#include "motion/rig/body_mapping.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/commands/line/recording_options.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/manifest/example_files.h"
#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/study/analysis/estimate_tables.h"
#include "pipeline/study/analysis/feature_regression.h"
#include "pipeline/tasks/progress.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct EstimateOptions {
  StudySubject subject;
  std::vector<std::string> motions;
  RecordingArguments recording;  ///< of `motions`
  int permutations = 199;
  std::string out;
};

Eigen::RowVectorXd features_of(const motion::Clip& clip) {
  const std::vector<double> values = motion::measure_expression(clip);
  return Eigen::Map<const Eigen::RowVectorXd>(values.data(),
                                              static_cast<Eigen::Index>(values.size()));
}

/// The whole recordings of the examples, which is what raters saw; built-in examples are loops.
Eigen::RowVectorXd features_of_example(const Repertoire& repertoire, std::size_t i,
                                       const motion::ReadOptions& how) {
  if (repertoire.origins.empty()) return features_of(repertoire.examples.examples[i].clip);
  const fs::path& file = repertoire.origins[i].file;
  try {
    return features_of(motion::to_body(motion::read_motion(file, how)));
  } catch (const Error& error) {
    throw Error(file.string() + ": " + error.what(), "");
  }
}

RatedMotions rated_motions(const Repertoire& repertoire, const Manifest& manifest) {
  const auto features = motion::expressive_features();
  RatedMotions motions;
  motions.features.resize(static_cast<Eigen::Index>(repertoire.names.size()),
                          static_cast<Eigen::Index>(features.size()));
  motions.families.resize(motion::feature_family_count);
  for (std::size_t k = 0; k < features.size(); ++k)
    motions.families[static_cast<std::size_t>(features[k].family)].push_back(static_cast<int>(k));
  const motion::ReadOptions how =
      repertoire.origins.empty() ? motion::ReadOptions{} : example_folder(manifest.examples).how;
  std::map<std::string, int> numbers;
  for (std::size_t i = 0; i < repertoire.names.size(); ++i) {
    motions.features.row(static_cast<Eigen::Index>(i)) = features_of_example(repertoire, i, how);
    const auto next = static_cast<int>(numbers.size());
    motions.style.push_back(
        numbers.emplace(style_of(repertoire.names[i].name), next).first->second);
  }
  return motions;
}

RatingEstimators fitted(const Repertoire& repertoire, const Manifest& manifest, int permutations,
                        const Console& console) {
  if (!repertoire.impressions)
    throw Error("the examples have no ratings to estimate others from", "give ratings");
  const Impressions& impressions = *repertoire.impressions;
  const RatedMotions motions = rated_motions(repertoire, manifest);
  RatingEstimators result{impressions.examples, {}, {}, impressions.simulated};
  ProgressBar bar(console.err, console.err_is_terminal);
  const std::size_t scales = impressions.scales.size();
  for (std::size_t s = 0; s < scales; ++s) {
    const auto progress = [&](double share) {
      if (console.stop.stop_requested()) throw Interrupted();
      bar.show((static_cast<double>(s) + share) / static_cast<double>(scales),
               impressions.scales[s]);
    };
    progress(0.0);
    const auto row = static_cast<Eigen::Index>(s);
    result.ratings.push_back({impressions.scales[s], impressions.mean.row(row),
                              impressions.deviation.row(row), impressions.count.row(row)});
    result.estimators.push_back(
        fit_estimator(motions, result.ratings.back(),
                      {.permutations = permutations, .seed = manifest.seed, .progress = progress}));
  }
  return result;
}

/// A motion without ratings.
struct UnratedMotion {
  std::string name;
  Eigen::RowVectorXd features;
};

std::vector<UnratedMotion> unrated_motions(const EstimateOptions& options, const Console& console) {
  std::vector<UnratedMotion> all;
  for (const NamedRecording& named : named_recordings(options.motions, options.recording)) {
    all.push_back({fs::path(named.file).stem().string(),
                   features_of(motion::to_body(read_with_warnings(named, console)))});
  }
  return all;
}

std::vector<EstimatedMotion> estimated_motions(const std::vector<UnratedMotion>& motions,
                                               const RatingEstimators& estimators) {
  std::vector<EstimatedMotion> all;
  for (const UnratedMotion& motion : motions) {
    EstimatedMotion one{motion.name, {}};
    for (const ScaleEstimator& estimator : estimators.estimators)
      one.estimates.push_back(estimate(estimator, motion.features));
    all.push_back(std::move(one));
  }
  return all;
}

/// "–" for what is not known.
std::string rounded(double value) {
  return std::isfinite(value) ? fmt::format("{:.2f}", value) : "–";
}

void show(const RatingEstimators& estimators, const std::vector<EstimatedMotion>& motions,
          const Console& console) {
  console.out << fmt::format(
      "{} motions{}\n\n{:22} {:>8} {:>8} {:>8} {:>8}\n", estimators.motions.size(),
      estimators.simulated ? ", simulated ratings" : "", "scale", "ceiling", "R²", "share", "p");
  for (const ScaleEstimator& e : estimators.estimators)
    console.out << fmt::format("{:22} {:>8} {:>8} {:>8} {:8.3f}  {}\n", e.scale,
                               rounded(e.check.ceiling), rounded(e.check.r_squared),
                               rounded(e.share_of_ceiling()), e.check.p,
                               !e.is_usable()                     ? "not predicted: do not use"
                               : e.reaches_aim()                  ? "60 % of the ceiling reached"
                               : std::isnan(e.share_of_ceiling()) ? ""
                                                                  : "below 60 % of the ceiling");
  console.out
      << "\nR² with all motions of a style left out. Ceiling: R² of an estimator that knows "
         "what all people\nwould answer on average. p: of permutations of the styles' "
         "ratings.\n";
  for (const EstimatedMotion& motion : motions) {
    console.out << '\n' << motion.motion << " (estimated, not rated)\n";
    for (std::size_t s = 0; s < motion.estimates.size(); ++s)
      console.out << fmt::format("  {:22} {:5.2f}  90 %: {:5.2f} to {:5.2f}{}\n",
                                 estimators.estimators[s].scale, motion.estimates[s].value,
                                 motion.estimates[s].low_90, motion.estimates[s].high_90,
                                 estimators.estimators[s].is_usable() ? "" : "  do not use");
  }
}

int show_estimates(const EstimateOptions& options, const Console& console) {
  const std::vector<UnratedMotion> unrated = unrated_motions(options, console);
  const Manifest manifest = manifest_of(options.subject, console);
  const Repertoire repertoire = load_repertoire(manifest);
  const RatingEstimators estimators = fitted(repertoire, manifest, options.permutations, console);
  const std::vector<EstimatedMotion> motions = estimated_motions(unrated, estimators);
  show(estimators, motions, console);
  if (options.out.empty()) return exit_done;
  std::vector<WrittenTable> tables = {estimate_checks_table(estimators),
                                      left_out_estimates_table(estimators)};
  if (!motions.empty()) {
    tables.push_back(estimates_table(motions, estimators));
    tables.push_back(estimated_ratings_table(motions, estimators, repertoire.scales));
  }
  write_tables(options.out, tables);
  for (const WrittenTable& table : tables)
    console.out << (fs::path(options.out) / table.form.path).string() << '\n';
  return exit_done;
}

}  // namespace

Command study_estimate_command() {
  const auto options = std::make_shared<EstimateOptions>();
  return {
      .name = "estimate",
      .summary = "Estimate ratings of new motions, with intervals and the ceiling of agreement",
      .options = all_of(subject_options(options->subject),
                        option("--motions", &options->motions, "Motion files without ratings"),
                        that_need("--motions", options_of_recordings(options->recording)),
                        option("--permutations", &options->permutations,
                               "Number of permutations for the p values; scales can be used only "
                               "if p is at most 0.05, so 19 is the smallest useful number")
                            .between(0, 9999),
                        option("-o,--output", &options->out, "Folder for the tables (CSV)")),
      .notes =
          "Gaussian processes from features of shape, timing and dynamics of whole motions, of any "
          "action, to each rated scale. Every style (all takes: sad_001, sad_002) is left out in "
          "turn. The table states how much of the ceiling that the raters' agreement sets is "
          "reached. The tables are estimate_checks.csv, left_out_estimates.csv and, with "
          "--motions, estimates.csv and estimated_ratings.csv, which a manifest can take as "
          "ratings.\n\n"
          "Example:\n"
          "  mien study estimate --examples manifests/real-walks.yaml --motions new.bvh",
      .run = [options](const Console& console) { return show_estimates(*options, console); }};
}

}  // namespace mien::pipeline
