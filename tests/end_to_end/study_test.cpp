#include <csignal>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST(StudyCommands, LeadFromSimulatedAnswersToParametersOfAManifest) {
  const Scratch scratch;
  const fs::path answers = scratch.path() / "answers.csv";
  const fs::path results = scratch.path() / "results";
  ASSERT_EQ(
      run_mien({"study", "simulate", "--examples", "builtin:walks-27", "-o", answers.string()})
          .code,
      0);
  const Ended analysis =
      run_mien({"study", "analyze", answers.string(), "--examples", "builtin:walks-27", "--names",
                "one,two,three,four", "-o", results.string(), "--json"});
  ASSERT_EQ(analysis.code, 0) << analysis.errors;
  const json summary = json::parse(analysis.output);
  EXPECT_EQ(summary["ratings"], "simulated");
  EXPECT_EQ(summary["clusters"].size(), 4u);
  EXPECT_EQ(summary["clusters"][1]["name"], "two");
  EXPECT_GT(summary["published"][1]["adjusted_rand"], 0.9);
  for (const char* file :
       {"quantification.csv", "thresholds.csv", "impressions.csv", "linkage.csv", "clusters.csv",
        "primary.csv", "agreement.csv", "warnings.csv", "published.csv", "clusters.scales.yaml",
        "dendrogram.pdf", "dendrogram.svg", "dendrogram.png"}) {
    EXPECT_TRUE(fs::exists(results / file)) << file;
  }

  const fs::path manifest = scratch.write(
      "study.yaml",
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-27, ratings: answers.csv, scales: "
      "results/clusters.scales.yaml}\nstimuli:\n  - {id: a, adjectives: {two: 0.7}}\n");
  const Ended check = run_mien({"check", manifest.string()});
  EXPECT_EQ(check.code, 0) << check.errors;
  // A manifest is an example source too.
  const Ended again =
      run_mien({"study", "analyze", answers.string(), "--examples", manifest.string(), "--clusters",
                "gap", "-o", (scratch.path() / "again").string()});
  EXPECT_EQ(again.code, 0) << again.errors;
}

TEST(StudyCommands, EstimateRatingsOfAMotionThatNobodyRated) {
  const Scratch scratch;
  const std::string walk = (scratch.path() / "walk.bvh").string();
  ASSERT_EQ(run_mien({"motion", "blend", "--examples", "builtin:walks-10", "--weights", "sad=1",
                      "-o", walk})
                .code,
            0);
  const fs::path tables = scratch.path() / "estimates";
  const Ended ended = run_mien({"study", "estimate", "--examples", "builtin:walks-10",
                                "--permutations", "19", "--motions", walk, "-o", tables.string()});
  ASSERT_EQ(ended.code, 0) << ended.errors;
  EXPECT_NE(ended.output.find("walk (estimated, not rated)"), std::string::npos);
  EXPECT_NE(ended.output.find("simulated ratings"), std::string::npos);
  for (const char* file : {"estimate_checks.csv", "left_out_estimates.csv", "estimates.csv"})
    EXPECT_TRUE(fs::exists(tables / file)) << file;
  // Rated by nobody: what a study that takes them as ratings says, too.
  const fs::path ratings = tables / "estimated_ratings.csv";
  EXPECT_EQ(text_of(ratings).rfind("stimulus,scale,value,low_90,high_90,estimated,simulated\n", 0),
            0u);
}

TEST(StudyCommands, EstimateReadsMotionsBeforeItBeginsAndStopsWhenAsked) {
  const Scratch scratch;
  const std::string none = (scratch.path() / "none.bvh").string();
  const std::vector<std::string> long_one = {
      "study", "estimate", "--examples", "builtin:walks-27", "--permutations", "9999"};
  std::vector<std::string> arguments = long_one;
  arguments.insert(arguments.end(), {"--motions", none});
  const Ended missing = run_mien(arguments);
  EXPECT_EQ(missing.code, 2);
  EXPECT_NE(missing.errors.find("none.bvh: there is no such file"), std::string::npos);
  EXPECT_EQ(
      run_mien({"study", "estimate", "--examples", "builtin:walks-10", "--permutations", "-1"})
          .code,
      2);
  EXPECT_EQ(run_mien(long_one, 2.0, SIGINT).code, 130);
}

TEST(StudyCommands, AnalyzeRefusesBadOptionsAndAnswers) {
  const Scratch scratch;
  const std::string answers =
      scratch.write("a.csv", "participant,stimulus,scale,value\np,normall,sad-happy,1\n").string();
  const auto analyze = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"study", "analyze", answers, "--examples",
                                          "builtin:walks-10"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_mien(arguments);
  };
  const Ended unknown = analyze({});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_EQ(unknown.errors.substr(0, unknown.errors.find(';')),
            answers + ":2:3: unknown stimulus \"normall\" (1 row)");
  for (const std::vector<std::string>& bad :
       std::vector<std::vector<std::string>>{{"--clusters", "0"},
                                             {"--clusters", "many"},
                                             {"--repeated", "twice"},
                                             {"--max-mean", "3"},
                                             {"--unknown", "ignore"}}) {
    const Ended ended = analyze(bad);
    EXPECT_EQ(ended.code, 2) << bad[0];
    EXPECT_NE(ended.errors, "");
  }
}

TEST(StudyCommands, AnalyzeTakesTheScalesThatTheStudyKeeps) {
  const Scratch scratch;
  const fs::path scales = scratch.write(
      "own.scales.yaml",
      "range: [1, 7]\nscales: {haste: {low: calm, high: hasty, loadings: {quickness: 1}}}\n");
  const fs::path manifest = scratch.write(
      "m.yaml",
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10, ratings: simulated, scales: "
      "own.scales.yaml}\noutput: {size: [32, 24], fps: 6, cycles: 1, quality: draft, video: []}\n"
      "stimuli:\n  - {id: a, adjectives: {haste: 0.4}}\n  - {id: b, adjectives: {haste: 0.6}}\n");
  const Ended run =
      run_mien({"run", manifest.string(), "--out", (scratch.path() / "out").string()});
  ASSERT_EQ(run.code, 0) << run.errors;
  fs::remove(scales);
  const std::string answers =
      scratch.write("answers.csv", "participant,stimulus,scale,value\np,a,haste,2\np,b,haste,6\n")
          .string();
  for (const char* study : {"out/s", "out/s/metrics/parameters.csv"}) {
    const Ended ended =
        run_mien({"study", "analyze", answers, "--stimuli", (scratch.path() / study).string(), "-o",
                  (scratch.path() / "results").string()});
    ASSERT_EQ(ended.code, 0) << ended.errors;
    EXPECT_EQ(ended.output.substr(0, ended.output.find('\n')),
              "scales of the study: " + (scratch.path() / "out/s/inputs/own.scales.yaml").string());
    EXPECT_NE(ended.output.find("haste: perceived = "), std::string::npos) << ended.output;
  }
}

TEST(StudyCommands, WriteOverNoManifestAndNoAnswersOfPeople) {
  const Scratch scratch;
  const std::string text =
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\n"
      "questionnaire: {participants: 2, scales: [sad-happy]}\n"
      "stimuli:\n  - {id: a, weights: {normal: 1}}\n  - {id: b, weights: {tired: 1}}\n";
  const std::string manifest = scratch.write("s.yaml", text).string();
  const std::string answers = (scratch.path() / "answers.csv").string();
  EXPECT_EQ(run_mien({"study", "design", manifest, "-o", manifest}).code, 2);
  EXPECT_EQ(run_mien({"study", "simulate", manifest, "-o", manifest}).code, 2);
  EXPECT_EQ(text_of(manifest), text);
  EXPECT_EQ(run_mien({"study", "design", manifest, "-o", answers, "--balance", answers}).code, 2);
  EXPECT_FALSE(std::filesystem::exists(answers));
  for (int time = 0; time < 2; ++time)
    EXPECT_EQ(run_mien({"study", "simulate", manifest, "-o", answers}).code, 0);
}

TEST(StudyCommands, EvaluateComparesInterfaces) {
  const Scratch scratch;
  std::string csv = "participant,target,interface,first_guess_d,time_s,success\n";
  for (int p = 0; p < 6; ++p) {
    csv += "p" + std::to_string(p) + ",t,weights,0.1," + std::to_string(200 + p) + ",1\n";
    csv += "p" + std::to_string(p) + ",t,adjectives,0.05," + std::to_string(90 + 2 * p) + ",1\n";
  }
  const std::string recorded = scratch.write("sessions.csv", csv).string();
  const fs::path out = scratch.path() / "out";
  const Ended ended = run_mien({"study", "evaluate", recorded, "-o", out.string(), "--json"});
  ASSERT_EQ(ended.code, 0) << ended.errors;
  const json summary = json::parse(ended.output);
  EXPECT_EQ(summary["sessions"], "given");
  EXPECT_NEAR(summary["comparisons"][1]["p_exact"].get<double>(), 0.03125, 1e-9);
  EXPECT_TRUE(fs::exists(out / "time_saved.svg"));
  EXPECT_EQ(run_mien({"study", "evaluate", recorded, "--limit", "0"}).code, 2);
  EXPECT_EQ(ended.errors, "");
  const Ended easy =
      run_mien({"study", "evaluate", recorded, "--threshold", "0.2", "-o", out.string()});
  EXPECT_EQ(easy.code, 0);
  EXPECT_NE(easy.errors.find("note: every first guess matched"), std::string::npos) << easy.errors;
}

TEST(StudyCommands, PrintTheBuiltInScales) {
  const Ended ended = run_mien({"study", "scales"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.output,
            text_of(std::string(MIEN_SOURCE_DIR) + "/manifests/adjective-pairs.scales.yaml"));
}

}  // namespace
}  // namespace mien::test
