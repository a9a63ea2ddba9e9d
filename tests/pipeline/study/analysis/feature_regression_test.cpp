#include "pipeline/study/analysis/feature_regression.h"

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/documents/csv.h"

#include "real_data.h"

namespace mien::pipeline {
namespace {

/// Ratings that follow from two features and nothing else.
Repertoire lawful_repertoire() {
  Manifest manifest;
  manifest.examples.builtin = "walks-27";
  Repertoire repertoire = load_repertoire(manifest);
  const ParameterTable& features = repertoire.features.table;
  repertoire.parameters.names = {"made"};
  repertoire.parameters.values = 0.6 * features.values.row(features.find("mu-com-vel-fb")) +
                                 0.4 * features.values.row(features.find("mu-torso-fb"));
  return repertoire;
}

TEST(FeatureRegression, StylesAreNamesWithoutTheNumberOfTheTake) {
  EXPECT_EQ(style_of("sad_001"), "sad");
  EXPECT_EQ(style_of("not-confident-2"), "not-confident");
  EXPECT_EQ(style_of("sad 12"), "sad");
  EXPECT_EQ(style_of("happy-fast"), "happy-fast");
  EXPECT_EQ(style_of("walk2"), "walk");
  EXPECT_EQ(style_of("007"), "007");
}

TEST(FeatureRegression, FindsRatingsThatFollowFromFeatures) {
  const Repertoire repertoire = lawful_repertoire();
  const FeatureRegression regression = fit_feature_regression(repertoire);
  ASSERT_EQ(regression.parameters.size(), 1u);
  const ParameterRegression& made = regression.parameters[0];
  ASSERT_EQ(made.checks.size(), 1u);  // no style has several takes
  EXPECT_GT(made.checks[0].r_squared, 0.9);
  for (std::size_t i = 0; i < repertoire.names.size(); ++i) {
    const Prediction p = predict(regression, repertoire.features.values[i])[0];
    EXPECT_NEAR(p.value, made.observed[static_cast<Eigen::Index>(i)], 0.1);
    EXPECT_FALSE(p.extrapolated);
    EXPECT_LT(p.low, p.value);
  }
}

TEST(FeatureRegression, SaysThatItIsUnsureBeyondTheExamples) {
  const Repertoire repertoire = lawful_repertoire();
  const FeatureRegression regression = fit_feature_regression(repertoire);
  motion::FeatureValues strange = repertoire.features.values[0];
  for (double& value : strange) value = 3.0 * value + 10.0;
  const Prediction known = predict(regression, repertoire.features.values[0])[0];
  const Prediction unknown = predict(regression, strange)[0];
  EXPECT_TRUE(unknown.extrapolated);
  EXPECT_GT(unknown.high - unknown.low, 1.5 * (known.high - known.low));
}

// The n-th of n errors covers n / (n + 1); the place is the first that covers 90 %.
TEST(FeatureRegression, TakesTheErrorThatCoversNinetyPercent) {
  const Repertoire repertoire = lawful_repertoire();
  const FeatureRegression regression = fit_feature_regression(repertoire);
  for (const ParameterRegression& one : regression.parameters) {
    const auto& predicted = one.checks.back().predictions.predicted;
    const auto n = static_cast<double>(one.observed.size());
    const auto within =
        static_cast<double>(((one.observed - predicted).array().abs() <= one.error_90).count());
    EXPECT_GE(within, 0.9 * (n + 1.0));
    EXPECT_LT(within - 1.0, 0.9 * (n + 1.0));
  }
}

TEST(FeatureRegression, TakesOfAStyleAreLeftOutTogetherToo) {
  Repertoire repertoire = lawful_repertoire();
  for (std::size_t i = 0; i < repertoire.names.size(); ++i) {
    repertoire.names[i].name =
        "style" + std::string(1, static_cast<char>('a' + i / 3)) + "_" + std::to_string(i % 3 + 1);
  }
  const FeatureRegression regression = fit_feature_regression(repertoire);
  ASSERT_EQ(regression.parameters[0].checks.size(), 2u);
  EXPECT_EQ(regression.parameters[0].checks[1].left_out, "style");
  const CsvTable checks = parse_csv(checks_table(regression, repertoire.scales).csv, "checks.csv");
  EXPECT_EQ(checks.rows.size(), 2u);
  EXPECT_EQ(parse_csv(left_out_table(regression).csv, "left_out.csv").rows.size(), 54u);
}

TEST(FeatureRegression, NeedsRatingsAndSeveralExamples) {
  Repertoire repertoire = lawful_repertoire();
  repertoire.parameters = {};
  EXPECT_THROW(fit_feature_regression(repertoire), Error);
  repertoire = lawful_repertoire();
  repertoire.names.resize(3);
  EXPECT_THROW(fit_feature_regression(repertoire), Error);
}

TEST(FeatureRegression, AMotionWithoutStepsIsNotPredictedFromWalks) {
  const Repertoire repertoire = lawful_repertoire();
  const FeatureRegression regression = fit_feature_regression(repertoire);
  motion::FeatureValues standing = repertoire.features.values[0];
  standing[static_cast<std::size_t>(motion::find_motion_feature("step-length-fb"))] = std::nan("");
  EXPECT_THROW(predict(regression, standing), Error);
}

TEST(FeatureRegression, PredictsSomeOfWhatPeopleSaidOfRealWalks) {
  const auto data = test::real_data();
  if (!data) GTEST_SKIP() << "no motion capture here: set MIEN_DATA to the folder that has it";
  Manifest manifest;
  manifest.examples.folder = *data / "mocap" / "bandai-namco-1";
  manifest.examples.include = "*walk*.bvh";
  manifest.ratings.source = Ratings::Source::file;
  manifest.ratings.file = *data / "mocap" / "bandai-namco-1" / "ratings.csv";
  manifest.scales =
      scales_in(std::filesystem::path(MIEN_SOURCE_DIR) / "manifests" / "five-factors.scales.yaml");
  const FeatureRegression regression = fit_feature_regression(load_repertoire(manifest));
  ASSERT_EQ(regression.parameters.size(), 5u);
  EXPECT_EQ(regression.features.size(), 51u);
  std::map<std::string, double> r_squared;
  for (const ParameterRegression& parameter : regression.parameters) {
    ASSERT_EQ(parameter.checks.size(), 2u) << parameter.parameter;
    for (const PredictionCheck& check : parameter.checks) {
      EXPECT_NEAR(check.r_squared, 1.0 - std::pow(check.rmse / check.mean_rmse, 2), 1e-9);
    }
    r_squared[parameter.parameter] = parameter.checks[1].r_squared;
  }
  // Who walks fast and swings wide looks extraverted; conscientiousness does not show in a walk.
  EXPECT_GT(r_squared["extraversion"], 0.35);
  EXPECT_LT(r_squared["conscientiousness"], 0.1);
}

}  // namespace
}  // namespace mien::pipeline
