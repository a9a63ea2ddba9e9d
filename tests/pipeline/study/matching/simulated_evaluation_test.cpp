#include "pipeline/study/matching/simulated_evaluation.h"

#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {
namespace {

Repertoire rated_repertoire() {
  Manifest manifest;
  manifest.examples.builtin = "walks-10";
  manifest.ratings.source = Ratings::Source::builtin;
  return load_repertoire(manifest);
}

TEST(SimulatedEvaluation, EveryMethodMeetsItsOwnTargetsOnFineSliders) {
  using enum motion::InterpolationMethod;
  const Repertoire repertoire = rated_repertoire();
  const auto interfaces = interfaces_of(repertoire);
  const auto targets = sample_targets(repertoire.parameters, interfaces[0].sliders,
                                      {.targets = 2, .practice = 0, .seed = 1});
  const auto results =
      evaluate_interfaces(repertoire, targets, {},
                          {.methods = {cardinal, nearest, inverse_distance, grid, kriging, pca},
                           .steps = {0.001},
                           .users = 0});
  ASSERT_EQ(results.size(), 6u * 2u * 3u);
  for (const InterfaceResult& r : results) {
    if (r.kind != InterfaceKind::adjectives) continue;
    EXPECT_LT(r.distance, 0.001) << r.target << " " << motion::name_of(r.method);
  }
}

TEST(SimulatedEvaluation, FinerSlidersComeNearerAndTheTablesSaySimulated) {
  const Repertoire repertoire = rated_repertoire();
  const auto interfaces = interfaces_of(repertoire);
  const auto targets = sample_targets(repertoire.parameters, interfaces[0].sliders,
                                      {.targets = 3, .practice = 0, .seed = 1});
  const auto results =
      evaluate_interfaces(repertoire, targets, {}, {.steps = {0.01, 0.25}, .users = 0, .seed = 1});
  ASSERT_EQ(results.size(), 3u * 3u * 2u);
  const auto summaries = summarise(results);
  ASSERT_EQ(summaries.size(), 6u);
  EXPECT_EQ(summaries[0].count, 3);
  for (std::size_t i : {0u, 4u}) {  // features do not determine the weights
    EXPECT_LT(summaries[i].mean_first, summaries[i + 1].mean_first) << name_of(summaries[i].kind);
    EXPECT_LT(summaries[i].mean_first, 0.02);
  }
  const CsvTable table = parse_csv(results_table(results).csv, "t.csv");
  const int simulated = require_column(table, "simulated");
  for (const auto& r : table.rows) EXPECT_EQ(r[static_cast<std::size_t>(simulated)].text, "1");
}

TEST(SimulatedEvaluation, TriesEveryMethodOfInterpolationByItself) {
  const Repertoire repertoire = rated_repertoire();
  const auto interfaces = interfaces_of(repertoire);
  const auto targets = sample_targets(repertoire.parameters, interfaces[0].sliders,
                                      {.targets = 2, .practice = 0, .seed = 1});
  using enum motion::InterpolationMethod;
  const EvaluationOptions both = {.methods = {cardinal, inverse_distance}, .users = 1, .seed = 1};
  EvaluationOptions one = both;
  one.methods = {inverse_distance};
  const auto summaries = summarise(evaluate_interfaces(repertoire, targets, {}, both));
  const auto alone = summarise(evaluate_interfaces(repertoire, targets, {}, one));
  ASSERT_EQ(summaries.size(), 2 * alone.size());
  bool differs = false;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    const InterfaceSummary& other = summaries[alone.size() + i];
    EXPECT_EQ(other.method, inverse_distance);
    EXPECT_EQ(other.mean_first, alone[i].mean_first);
    differs = differs || summaries[i].mean_first != other.mean_first;
  }
  EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace mien::pipeline
