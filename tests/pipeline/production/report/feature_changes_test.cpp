#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/production/report/report_tables.h"
#include "pipeline/production/report/tables.h"

namespace mien::pipeline {
namespace {

using motion::FeatureChange;

Manifest manifest() {
  const ManifestReading reading = parse_manifest(
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nstimuli:\n"
      "- {id: calm, weights: {normal: 1}}\n"
      "- {id: acted, weights: {sad: 1}}\n"
      "- {id: bowed, weights: {normal: 1}, modify: {posture: {head-flexion: 20}}}\n"
      "- {id: proud, weights: {normal: 1}, modify: {posture: {head-flexion: -20}}}\n"
      "sheets:\n"
      "- compare: {target: acted, created: bowed, reference: calm}\n"
      "- compare: {target: acted, created: proud, reference: calm}\n"
      "- {id: plain, compare: {target: acted, created: proud}}\n"
      "- {id: all, gallery: [calm, acted, bowed, proud]}\n",
      "/nowhere/m.yaml", [](const std::string&) { return std::nullopt; });
  EXPECT_TRUE(reading.faults.empty());
  return reading.manifest;
}

const FeatureChange& change_of(const std::vector<FeatureChange>& changes, std::string_view id) {
  for (const FeatureChange& change : changes) {
    if (motion::motion_features()[static_cast<std::size_t>(change.feature)].id == id) return change;
  }
  throw std::runtime_error("no such feature");
}

TEST(FeatureChanges, TellWhichWayAModifiedMotionGoes) {
  const Manifest study = manifest();
  Motions motions(study);
  const auto bowed = change_of(feature_changes(study.sheets[0], motions), "mu-head-fb");
  const auto proud = change_of(feature_changes(study.sheets[1], motions), "mu-head-fb");
  // From neck to vertex: half of the turn is the neck's, half the head's.
  EXPECT_NEAR(bowed.created_change(), 16.5, 2.0);
  EXPECT_GT(bowed.target_change(), 5.0);
  EXPECT_TRUE(bowed.moved());
  EXPECT_TRUE(bowed.agrees());
  EXPECT_NEAR(proud.created_change(), -16.5, 2.0);
  EXPECT_TRUE(proud.moved());
  EXPECT_FALSE(proud.agrees());
  const auto step = change_of(feature_changes(study.sheets[0], motions), "step-length-fb");
  EXPECT_TRUE(step.moved());
  EXPECT_FALSE(step.agrees());  // a bowed head shortens no step
}

TEST(FeatureChanges, AreOfComparisonsWithAReferenceOnly) {
  const Manifest study = manifest();
  Motions motions(study);
  EXPECT_TRUE(feature_changes(study.sheets[2], motions).empty());
  EXPECT_TRUE(feature_changes(study.sheets[3], motions).empty());
  const CsvTable table = parse_csv(feature_changes_table.csv(study, motions), "t.csv");
  EXPECT_EQ(table.rows.size(), feature_changes(study.sheets[0], motions).size() +
                                   feature_changes(study.sheets[1], motions).size());
}

TEST(Galleries, MeasureEveryMotionAgainstTheFirst) {
  const Manifest study = manifest();
  Motions motions(study);
  const CsvTable table = parse_csv(distances_table.csv(study, motions), "t.csv");
  ASSERT_EQ(table.rows.size(), 6u);
  EXPECT_EQ(table.rows[3][0].text, "all");
  EXPECT_EQ(table.rows[3][1].text, "calm");
  EXPECT_EQ(table.rows[5][2].text, "proud");
}

}  // namespace
}  // namespace mien::pipeline
