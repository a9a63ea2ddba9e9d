#include "pipeline/manifest/ratings/scales/feature_parameters.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "motion/measures/distance/distance.h"
#include "motion/procedural/builtin_sets.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/production/report/tables.h"
#include "pipeline/production/sheets/sheet_content.h"
#include "pipeline/production/synthesis/synthesis.h"

namespace mien::pipeline {
namespace {

Manifest unrated_manifest() {
  Manifest manifest;
  manifest.study = "unrated";
  manifest.examples.builtin = "walks-10";
  return manifest;
}

Stimulus with_features(const std::string& id, NamedValues features) {
  Stimulus stimulus;
  stimulus.id = id;
  stimulus.features = std::move(features);
  return stimulus;
}

TEST(FeatureParameters, AreTheGroupsAndTheFeaturesUnderNamesOfTheirOwn) {
  const std::vector<std::string> names = feature_parameter_names();
  EXPECT_EQ(names.size(), 55u);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), 55u);
  EXPECT_EQ(names[0], "lateral-swing");
}

TEST(FeatureParameters, TableHoldsTheScaledFeaturesAndTheirMeans) {
  const FeatureParameters features = feature_parameters(motion::builtin_examples("walks-10"));
  const ParameterTable& table = features.table;
  ASSERT_EQ(table.names.size(), 55u);
  EXPECT_FALSE(table.simulated);
  const auto scaled = motion::scaled(features.scale, features.values[4]);
  for (const motion::MotionFeature& f : motion::motion_features()) {
    const int row = table.find(std::string(f.id));
    const auto index = static_cast<std::size_t>(motion::find_motion_feature(f.id));
    EXPECT_DOUBLE_EQ(table.values(row, 4), scaled[index]) << f.id;
    EXPECT_GE(table.values.row(row).minCoeff(), 0.0);
    EXPECT_LE(table.values.row(row).maxCoeff(), 1.0);
  }
  double sum = 0.0;
  for (const char* id : {"sigma-torso-lr", "sigma-head-lr", "sigma-com-pos-lr", "sigma-com-vel-lr",
                         "sigma-torso-fb", "sigma-head-fb"}) {
    sum += table.values(table.find(id), 7);
  }
  EXPECT_NEAR(table.values(table.find("lateral-swing"), 7), sum / 6, 1e-12);
}

TEST(FeatureParameters, WhatPerformancesDoNotHaveIsNoParameter) {
  motion::ExampleSet set = motion::builtin_examples("walks-10");
  set.examples[2].clip.loops = false;
  const ParameterTable table = feature_parameters(set).table;
  EXPECT_EQ(table.find("step-length-fb"), -1);
  EXPECT_EQ(table.find("step-length-lr"), -1);
  EXPECT_NE(table.find("step-length"), -1);
  EXPECT_EQ(table.names.size(), 53u);
}

TEST(FeatureParameters, AtAnExamplesOwnFeaturesIsThatExampleWithoutAnyRatings) {
  const Repertoire repertoire = load_repertoire(unrated_manifest());
  EXPECT_TRUE(repertoire.parameters.names.empty());
  for (int i = 0; i < 10; ++i) {
    Stimulus stimulus = with_features("like", {});
    for (const char* name :
         {"lateral-swing", "front-back-swing", "upper-body-bend", "step-length"}) {
      const ParameterTable& table = repertoire.features.table;
      stimulus.features.emplace_back(name, table.values(table.find(name), i));
    }
    const Synthesis made = synthesize(stimulus, repertoire);
    const motion::Example& example = repertoire.settled.examples[static_cast<std::size_t>(i)];
    EXPECT_LT(motion::distance(example, made.motion).mean, 1e-4) << example.name;
    for (std::size_t p = 0; p < 4; ++p) {
      EXPECT_NEAR(made.reached[p].second, stimulus.features[p].second, 1e-3);
    }
  }
}

TEST(FeatureParameters, MoreOfAFeatureMakesMoreOfItAsMeasured) {
  const Repertoire repertoire = load_repertoire(unrated_manifest());
  for (const char* name : {"step-length", "mu-torso-fb", "sigma-left-upper-arm-fb"}) {
    double before = -1.0;
    for (const double wish : {0.1, 0.5, 0.9}) {
      const Synthesis made = synthesize(with_features("wish", {{name, wish}}), repertoire);
      ASSERT_EQ(made.reached.size(), 1u);
      EXPECT_GT(made.reached[0].second, before) << name << " " << wish;
      before = made.reached[0].second;
    }
  }
}

TEST(FeatureParameters, AFeatureThatTheExamplesLackIsRefused) {
  Repertoire repertoire = load_repertoire(unrated_manifest());
  repertoire.features.table.names[4] = "gone";
  const std::string lacking = feature_parameter_names()[4];
  try {
    synthesize(with_features("a", {{lacking, 0.5}}), repertoire);
    FAIL() << "was not refused";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "the examples have no parameter \"" + lacking +
                  "\"; use a rated scale, or a feature that all examples have");
  }
}

TEST(FeatureParameters, AreNamedInTablesAndOnSheetsAndRestOnNoRatings) {
  Manifest manifest = unrated_manifest();
  manifest.ratings.source = Ratings::Source::builtin;  // simulated
  manifest.stimuli = {with_features("swaying", {{"lateral-swing", 0.8}, {"sigma-head-lr", 0.6}}),
                      with_features("long", {{"lateral-swing", 0.3}, {"step-length-fb", 0.9}})};
  Sheet sheet;
  sheet.id = "s";
  sheet.target = "swaying";
  sheet.created = "long";
  manifest.sheets = {sheet};
  Motions motions(manifest);

  const SheetContent content = sheet_content(sheet, manifest, motions);
  EXPECT_TRUE(content.simulated_ratings);
  EXPECT_EQ(content.target.origin, "from features");
  // What was requested, and what people would say of both blends.
  ASSERT_EQ(content.parameters.size(), 3u + 45u);
  EXPECT_FALSE(content.parameters[3].is_requested());
  EXPECT_EQ(content.parameters[0].name, "lateral swing of the upper body");
  EXPECT_EQ(content.parameters[0].japanese, "上半身の左右の揺れ");
  EXPECT_EQ(content.parameters[0].target.requested, 0.8);
  EXPECT_EQ(content.parameters[0].created.requested, 0.3);
  EXPECT_EQ(content.parameters[0].target.reached, motions.of("swaying").reached[0].second);
  EXPECT_FALSE(content.parameters[1].created.requested);
  EXPECT_FALSE(content.parameters[2].target.requested);

  const CsvTable table = parse_csv(parameters_table.csv(manifest, motions), "parameters.csv");
  ASSERT_EQ(table.rows.size(), 2u * (2u + 45u));
  const auto text = [&](std::size_t row, const char* column) {
    return table.rows[row][static_cast<std::size_t>(require_column(table, column))].text;
  };
  EXPECT_EQ(text(1, "ratings"), "none");
  EXPECT_EQ(text(1, "parameter"), "sigma-head-lr");
  EXPECT_EQ(text(1, "name"), "side-to-side sway of the head");
  EXPECT_EQ(text(1, "name_ja"), "頭の左右の揺れ");
  const CsvTable clips = parse_csv(clips_table.csv(manifest, motions), "clips.csv");
  EXPECT_EQ(clips.rows[0][static_cast<std::size_t>(require_column(clips, "source"))].text,
            "features");
}

}  // namespace
}  // namespace mien::pipeline
