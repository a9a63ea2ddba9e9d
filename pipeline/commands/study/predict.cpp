#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "motion/examples/make_example.h"
#include "motion/formats/motion_file.h"
#include "motion/rig/body_mapping.h"
#include "motion/rig/retarget.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/commands/line/recording_options.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/production/synthesis/parameter_label.h"
#include "pipeline/study/analysis/feature_regression.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct PredictOptions {
  StudySubject subject;
  std::vector<std::string> motions;
  RecordingArguments recording;  ///< of `motions`
  std::string out;
};

/// A motion without ratings.
struct Unrated {
  std::string name;
  motion::FeatureValues features;
  std::vector<Prediction> predictions;
};

/// Features of a file's motion on the examples' body, as measured for the examples.
motion::FeatureValues features_of(const NamedRecording& named, const Repertoire& repertoire,
                                  const Console& console) {
  motion::Example example =
      motion::make_example(motion::to_body(read_with_warnings(named, console)));
  const motion::Skeleton& body = repertoire.examples.examples.front().clip.body;
  example.clip = motion::retarget(example.clip, body);
  return motion::measure_features(example);
}

std::vector<Unrated> predicted_motions(const PredictOptions& options, const Repertoire& repertoire,
                                       const FeatureRegression& regression,
                                       const Console& console) {
  std::vector<Unrated> all;
  for (const NamedRecording& named : named_recordings(options.motions, options.recording)) {
    Unrated one{fs::path(named.file).stem().string(), features_of(named, repertoire, console), {}};
    try {
      one.predictions = predict(regression, one.features);
    } catch (const Error& error) {
      throw Error(named.file + ": " + error.what(), "");
    }
    all.push_back(std::move(one));
  }
  return all;
}

struct PredictedRating {
  std::string motion;
  bool simulated;  ///< what it is predicted from
  const Prediction& predicted;
  ParameterLabel label;
};

constexpr auto predictions_columns = table_of<PredictedRating>(
    "predictions.csv", "motion and parameter",
    {{"motion", "", "name of the file", [](auto& r) { return r.motion; }},
     {"parameter", "", "scale or group of scales", [](auto& r) { return r.predicted.parameter; }},
     whose_ratings_column,
     {"predicted", "0–1", "predicted rating, as a proportion of the scale; may lie outside 0–1",
      [](auto& r) { return r.predicted.value; }},
     {"low_90", "0–1", "lower end of its 90 % interval", [](auto& r) { return r.predicted.low; }},
     {"high_90", "0–1", "its upper end", [](auto& r) { return r.predicted.high; }},
     {"leverage", "", "leverage: distance of its features from those of the examples",
      [](auto& r) { return r.predicted.leverage; }},
     {"extrapolated", "0/1", "1: the leverage is larger than that of every example",
      [](auto& r) { return r.predicted.extrapolated; }},
     {"name", "", "English name", [](auto& r) { return english_text(r.label); }},
     {"name_ja", "", "Japanese name", [](auto& r) { return japanese_text(r.label); }}});

WrittenTable predictions_table(const std::vector<Unrated>& motions,
                               const FeatureRegression& regression, const ScaleSet& scales) {
  std::vector<PredictedRating> rows;
  for (const Unrated& motion : motions)
    for (const Prediction& p : motion.predictions)
      rows.push_back({motion.name, regression.simulated, p, rating_label(p.parameter, scales)});
  return predictions_columns.of(rows);
}

struct PredictedMean {
  std::string stimulus;
  std::string scale;
  double value;
};

constexpr auto rated_columns = table_of<PredictedMean>(
    "predicted_ratings.csv", "motion and scale",
    {{"stimulus", "", "name of the file", [](auto& r) { return r.stimulus; }},
     {"scale", "", "id of the scale", [](auto& r) { return r.scale; }},
     {"value", "scale", "predicted mean answer", [](auto& r) { return r.value; }},
     {"simulated", "", "always 1: predicted, not rated by participants",
      [](auto&) { return true; }}});

/// Predictions in the form of a table of mean ratings for a manifest, limited to the scales'
/// ranges.
WrittenTable ratings_table(const std::vector<Unrated>& motions, const ScaleSet& scales) {
  std::vector<PredictedMean> rows;
  for (const Unrated& motion : motions) {
    for (const Prediction& p : motion.predictions) {
      const Scale* scale = find_scale(scales, p.parameter);
      if (scale == nullptr) continue;
      const double share = std::clamp(p.value, 0.0, 1.0);
      rows.push_back({motion.name, scale->id, scale->least + share * (scale->most - scale->least)});
    }
  }
  return rated_columns.of(rows);
}

void show_checks(const FeatureRegression& regression, const Console& console) {
  console.out << fmt::format("{} examples, {} features{}\n\n", regression.examples.size(),
                             regression.features.size(),
                             regression.simulated ? ", simulated ratings" : "");
  console.out << fmt::format("{:22} {:>9} {:>8} {:>8} {:>8}\n", "parameter", "left out", "error",
                             "of mean", "R²");
  for (const ParameterRegression& parameter : regression.parameters)
    for (const PredictionCheck& check : parameter.checks)
      console.out << fmt::format("{:22} {:>9} {:8.3f} {:8.3f} {:8.2f}\n", check.parameter,
                                 check.left_out, check.rmse, check.mean_rmse, check.r_squared);
  console.out << "\nEach example is predicted by a fit without it (left out: example), or without "
                 "all takes of its\nstyle (left out: style). Errors (RMS) are proportions of the "
                 "scale; \"of mean\" is the error of\npredicting the mean of the others. R² at or "
                 "below 0: the features do not predict the ratings.\n";
}

void show_predictions(const std::vector<Unrated>& motions, const Console& console) {
  for (const Unrated& motion : motions) {
    console.out << '\n' << motion.name << '\n';
    for (const Prediction& p : motion.predictions)
      console.out << fmt::format("  {:22} {:5.2f}  90 %: {:5.2f} to {:5.2f}{}\n", p.parameter,
                                 p.value, p.low, p.high,
                                 p.extrapolated ? "  beyond the examples" : "");
  }
}

void write_predictions(const fs::path& folder, const std::vector<Unrated>& motions,
                       const FeatureRegression& regression, const ScaleSet& scales,
                       const Console& console) {
  std::vector<WrittenTable> tables = {checks_table(regression, scales), left_out_table(regression)};
  if (!motions.empty()) {
    tables.push_back(predictions_table(motions, regression, scales));
    tables.push_back(ratings_table(motions, scales));
  }
  write_tables(folder, tables);
  console.out << '\n';
  for (const WrittenTable& table : tables)
    console.out << (folder / table.form.path).string() << '\n';
}

int show_prediction(const PredictOptions& options, const Console& console) {
  const Repertoire repertoire = load_repertoire(manifest_of(options.subject, console));
  const FeatureRegression regression = fit_feature_regression(repertoire);
  const std::vector<Unrated> motions = predicted_motions(options, repertoire, regression, console);
  show_checks(regression, console);
  show_predictions(motions, console);
  if (!options.out.empty())
    write_predictions(options.out, motions, regression, repertoire.scales, console);
  return exit_done;
}

}  // namespace

Command study_predict_command() {
  const auto options = std::make_shared<PredictOptions>();
  return {
      .name = "predict",
      .summary = "Predict ratings from motion features, with cross-validation",
      .options = all_of(subject_options(options->subject),
                        option("--motions", &options->motions, "Motion files without ratings"),
                        that_need("--motions", options_of_recordings(options->recording)),
                        option("-o,--output", &options->out, "Folder for the tables (CSV)")),
      .notes =
          "Ridge regression from motion features to each rated parameter, with two "
          "cross-validations: leaving out each example in turn and, where a style has several "
          "takes (sad_001, sad_002), "
          "all takes of each style, because takes of one style are nearly identical. The tables "
          "are prediction_checks.csv, left_out_predictions.csv and, with --motions, "
          "predictions.csv and predicted_ratings.csv, which a manifest can take as ratings.\n\n"
          "Examples:\n"
          "  mien study predict --examples manifests/real-walks.yaml -o out/prediction\n"
          "  mien study predict --examples builtin:walks-27 --motions walk.bvh run.bvh",
      .run = [options](const Console& console) { return show_prediction(*options, console); }};
}

}  // namespace mien::pipeline
