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
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/commands/line/take_option.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/commands/study/study_subject.h"
#include "pipeline/production/synthesis/parameter_label.h"
#include "pipeline/study/analysis/feature_regression.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct PredictOptions {
  StudySubject subject;
  std::vector<std::string> motions;
  std::string take;
  std::string out;
};

/// A motion that nobody rated.
struct Unrated {
  std::string name;
  motion::FeatureValues features;
  std::vector<Prediction> predictions;
};

/// On the examples' body, as the examples were measured.
motion::FeatureValues features_of(const std::string& file, const std::string& take,
                                  const Repertoire& repertoire, const Console& console) {
  motion::Example example = motion::make_example(motion::to_body(read_told(file, take, console)));
  const motion::Skeleton& body = repertoire.examples.examples.front().clip.body;
  example.clip = motion::retarget(example.clip, body);
  return motion::measure_features(example);
}

std::vector<Unrated> predicted_motions(const PredictOptions& options, const Repertoire& repertoire,
                                       const FeatureRegression& regression,
                                       const Console& console) {
  std::vector<Unrated> all;
  for (const std::string& file : options.motions) {
    Unrated one{
        fs::path(file).stem().string(),
        features_of(file, motion::may_hold_takes(file) ? options.take : "", repertoire, console),
        {}};
    try {
      one.predictions = predict(regression, one.features);
    } catch (const Error& error) {
      throw Error(file + ": " + error.what(), "");
    }
    all.push_back(std::move(one));
  }
  return all;
}

const char* ratings_word(const FeatureRegression& regression) {
  return regression.simulated ? "simulated" : "given";
}

std::string predictions_csv(const std::vector<Unrated>& motions,
                            const FeatureRegression& regression, const ScaleSet& scales) {
  CsvWriter table({"motion", "parameter", "ratings", "predicted", "low_90", "high_90", "leverage",
                   "extrapolated", "name", "name_ja"});
  for (const Unrated& motion : motions) {
    for (const Prediction& p : motion.predictions) {
      const ParameterLabel label = rating_label(p.parameter, scales);
      table.row({motion.name, p.parameter, ratings_word(regression), shortest(p.value),
                 shortest(p.low), shortest(p.high), shortest(p.leverage),
                 p.extrapolated ? "1" : "0", english_text(label), japanese_text(label)});
    }
  }
  return table.text();
}

/// As means of answers that a manifest can take for ratings; within the scales' ranges.
std::string ratings_csv(const std::vector<Unrated>& motions, const ScaleSet& scales) {
  CsvWriter table({"stimulus", "scale", "value", "simulated"});
  for (const Unrated& motion : motions) {
    for (const Prediction& p : motion.predictions) {
      const Scale* scale = find_scale(scales, p.parameter);
      if (scale == nullptr) continue;
      const double share = std::clamp(p.value, 0.0, 1.0);
      table.row({motion.name, scale->id,
                 shortest(scale->least + share * (scale->most - scale->least)), "1"});
    }
  }
  return table.text();
}

void show_checks(const FeatureRegression& regression, const Console& console) {
  console.out << fmt::format("{} examples, {} features{}\n\n", regression.examples.size(),
                             regression.features.size(),
                             regression.simulated ? ", simulated ratings" : "");
  console.out << fmt::format("{:22} {:>9} {:>8} {:>8} {:>8}\n", "parameter", "left out", "error",
                             "of mean", "R²");
  for (const ParameterRegression& parameter : regression.parameters) {
    for (const PredictionCheck& check : parameter.checks) {
      console.out << fmt::format("{:22} {:>9} {:8.3f} {:8.3f} {:8.2f}\n", check.parameter,
                                 check.left_out, check.rmse, check.mean_rmse, check.r_squared);
    }
  }
  console.out
      << "\nErrors (RMS) are proportions of the scale; \"of mean\" is the error of predicting the "
         "mean of the\nothers. R² at or below 0: the features do not predict the ratings.\n";
}

void show_predictions(const std::vector<Unrated>& motions, const Console& console) {
  for (const Unrated& motion : motions) {
    console.out << '\n' << motion.name << '\n';
    for (const Prediction& p : motion.predictions) {
      console.out << fmt::format("  {:22} {:5.2f}  90 %: {:5.2f} to {:5.2f}{}\n", p.parameter,
                                 p.value, p.low, p.high,
                                 p.extrapolated ? "  beyond the examples" : "");
    }
  }
}

void write_tables(const fs::path& folder, const std::vector<Unrated>& motions,
                  const FeatureRegression& regression, const ScaleSet& scales,
                  const Console& console) {
  make_folder(folder);
  const auto write = [&](const char* name, const std::string& text) {
    write_file(folder / name, text);
    console.out << (folder / name).string() << '\n';
  };
  console.out << '\n';
  write("prediction_checks.csv", checks_csv(regression, scales));
  write("left_out_predictions.csv", left_out_csv(regression));
  if (motions.empty()) return;
  write("predictions.csv", predictions_csv(motions, regression, scales));
  write("predicted_ratings.csv", ratings_csv(motions, scales));
}

int show_prediction(const PredictOptions& options, const Console& console) {
  const Repertoire repertoire = load_repertoire(manifest_of(options.subject, console));
  const FeatureRegression regression = fit_feature_regression(repertoire);
  const std::vector<Unrated> motions = predicted_motions(options, repertoire, regression, console);
  show_checks(regression, console);
  show_predictions(motions, console);
  if (!options.out.empty()) {
    write_tables(options.out, motions, regression, repertoire.scales, console);
  }
  return exit_done;
}

}  // namespace

Command study_predict_command() {
  const auto options = std::make_shared<PredictOptions>();
  return {.name = "predict",
          .summary = "Predict ratings from motion features, with cross-validation",
          .options = all_of(subject_options(options->subject),
                            option("--motions", &options->motions, "Motion files without ratings"),
                            take_option(options->take),
                            option("-o,--output", &options->out, "Folder for the tables (CSV)")),
          .notes =
              "Ridge regression from motion features to each rated parameter, cross-validated by "
              "leaving out each example and, where a style has several takes (sad_001, sad_002), "
              "all takes of a style, because takes of one style are nearly identical. The tables "
              "are prediction_checks.csv, left_out_predictions.csv and, with --motions, "
              "predictions.csv and predicted_ratings.csv, which a manifest can take as ratings.\n\n"
              "Examples:\n"
              "  mien study predict --examples manifests/real-walks.yaml -o out/prediction\n"
              "  mien study predict --examples builtin:walks-27 --motions walk.bvh run.bvh",
          .run = [options](const Console& console) { return show_prediction(*options, console); }};
}

}  // namespace mien::pipeline
