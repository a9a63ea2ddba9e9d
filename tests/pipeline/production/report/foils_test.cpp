#include "pipeline/production/report/foils.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/production/report/report_tables.h"
#include "pipeline/production/report/tables.h"

namespace mien::pipeline {
namespace {

const std::string head =
    "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10, ratings: builtin}\nstimuli:\n"
    "  - id: low\n    weights: {normal: 1}\n    modify: {posture: {head-flexion: 25}, paths: 0.6, "
    "tempo: 0.8, acceleration: 0.6}\n"
    "  - {id: plain, weights: {normal: 1}}\n";

ManifestReading parsed(const std::string& foils) {
  return parse_manifest(head + foils, "m.yaml", [](const std::string&) { return std::nullopt; });
}

/// Differences by aspect, of the foil of `low` in one of them.
std::map<std::string, double> differences(const std::string& differ, std::string* held) {
  const Manifest manifest =
      parsed("  - {id: foil, foil: {of: low, differ: " + differ + "}}\n").manifest;
  Motions motions(manifest);
  const CsvTable table = parse_csv(foils_table.csv(manifest, motions), "foils.csv");
  std::map<std::string, double> by_aspect;
  for (const auto& row : table.rows) {
    const auto text = [&](const char* column) {
      return row[static_cast<std::size_t>(require_column(table, column))].text;
    };
    by_aspect[text("aspect")] = std::stod(text("difference"));
    *held += text("is_held").empty() ? "-" : text("is_held");
  }
  return by_aspect;
}

TEST(Foils, AreInTheReportWithWhatTheyDifferIn) {
  const Manifest manifest = parsed("  - {id: foil, foil: {of: low, differ: posture}}\n").manifest;
  Motions motions(manifest);
  const std::string table = foil_table(manifest.stimuli, motions);
  const auto count = [&](const std::string& words) {
    int found = 0;
    for (std::size_t at = 0; (at = table.find(words, at)) != std::string::npos; ++at) ++found;
    return found;
  };
  EXPECT_EQ(count("<td>intended to differ</td>"), 1);
  EXPECT_EQ(count("<td>within tolerance</td>"), 3);
  EXPECT_EQ(count("also differs"), 0);
  const Manifest without = parsed("").manifest;
  Motions others(without);
  EXPECT_EQ(foil_table(without.stimuli, others), "");
}

TEST(Foils, DifferInPostureAlone) {
  std::string held;
  const auto by_aspect = differences("posture", &held);
  EXPECT_GT(by_aspect.at("posture"), 8.0);
  EXPECT_EQ(held, "-111");
}

TEST(Foils, DifferInPathLengthAlone) {
  std::string held;
  const auto by_aspect = differences("path-length", &held);
  EXPECT_GT(by_aspect.at("path-length"), 0.15);
  EXPECT_EQ(by_aspect.at("speed"), 0.0);
}

TEST(Foils, DifferInSpeedAlone) {
  std::string held;
  const auto by_aspect = differences("speed", &held);
  EXPECT_NEAR(by_aspect.at("speed"), 0.8 - 1.0, 0.03);
  EXPECT_LT(by_aspect.at("posture"), 2.0);
  EXPECT_EQ(held.substr(0, 3), "11-");
}

TEST(Foils, DifferInAccelerationAlone) {
  std::string held;
  const auto by_aspect = differences("acceleration", &held);
  EXPECT_GT(std::abs(by_aspect.at("acceleration")), 0.05);
  EXPECT_EQ(held, "111-");
}

// A certificate that could not fail would certify nothing.
TEST(Foils, AreNotHeldWhereTheyAreNot) {
  const Manifest manifest = parsed("").manifest;
  Motions motions(manifest);
  const motion::Clip& low = motions.of("low").motion.clip;
  const motion::Clip& plain = motions.of("plain").motion.clip;
  EXPECT_GT(posture_difference(low, plain), 8.0);
  EXPECT_LT(measure_emotion(low).path_m, 0.9 * measure_emotion(plain).path_m);
  EXPECT_GT(measure_emotion(low).duration_s, 1.1 * measure_emotion(plain).duration_s);
}

std::string first_fault(const std::string& foils) {
  const ManifestReading reading = parsed(foils);
  return reading.faults.empty() ? "" : to_string(reading.faults.front());
}

TEST(Foils, ThatCannotBeMadeAreRefused) {
  EXPECT_EQ(first_fault("  - {id: f, foil: {of: low, differ: posture}}\n"), "");
  EXPECT_NE(first_fault("  - {id: f, foil: {of: lwo, differ: posture}}\n").find("did you mean"),
            std::string::npos);
  EXPECT_NE(first_fault("  - {id: f, foil: {of: low, differ: posture}}\n"
                        "  - {id: g, foil: {of: f, differ: speed}}\n")
                .find("\"f\" is itself a foil; name the stimulus of which it is a foil, \"low\""),
            std::string::npos);
  EXPECT_NE(first_fault("  - {id: f, foil: {of: low, differ: posture}, hold: others}\n")
                .find("a foil inherits this from its stimulus"),
            std::string::npos);
  EXPECT_NE(first_fault("  - {id: f, foil: {of: low, differ: posture}, factors: {my lab: k}}\n")
                .find("is not a valid column name"),
            std::string::npos);
  EXPECT_NE(first_fault("  - {id: f, foil: {of: plain, differ: posture}}\n")
                .find("do not change its posture"),
            std::string::npos);
  EXPECT_NE(first_fault("  - {id: f, foil: {of: low, differ: posture}, modify: {emotion: sad}}\n")
                .find("a foil inherits this"),
            std::string::npos);
  EXPECT_NE(first_fault("  - {id: f, foil: {of: low, differ: posture}, weights: {sad: 1}}\n"), "");
}

// Otherwise one of the two might be made at less than its strength, and the pair differ in more.
TEST(Foils, DealWithFaultsAsTheirOriginalsDo) {
  const std::string original =
      "  - {id: bold, weights: {normal: 1}, modify: {emotion: sad}, on_fault: reduce}\n";
  const auto on_fault_of = [&](const std::string& own) {
    return parsed(original + "  - {id: f, foil: {of: bold, differ: posture}" + own + "}\n")
        .manifest.stimuli.back()
        .on_fault;
  };
  EXPECT_EQ(on_fault_of(""), OnFault::reduce);
  EXPECT_EQ(on_fault_of(", on_fault: fail"), OnFault::fail);
}

}  // namespace
}  // namespace mien::pipeline
