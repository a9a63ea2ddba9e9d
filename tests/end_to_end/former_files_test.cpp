// Files as they were when the program called itself 0.2.0, with the names of that time: each is
// still read, and what was renamed is said (pipeline/VERSIONS.md).

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/page_folder.h"
#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;

const fs::path former = fs::path(MIEN_SOURCE_DIR) / "tests/end_to_end/former";

TEST(FormerFiles, OfManifestsAreAcceptedAndTheirFormerKeysNamed) {
  for (const char* name : {"quickstart", "closed-loop-1", "thesis-questionnaire"}) {
    const Ended ended = run_mien({"check", former / (std::string(name) + ".yaml")});
    EXPECT_EQ(ended.code, 0) << ended.errors;
    EXPECT_EQ(ended.errors.find("questionnaire.apart: now called no_repeats") != std::string::npos,
              std::string(name) == "thesis-questionnaire")
        << ended.errors;
  }
}

TEST(FormerFiles, OfAnswersAreReportedWithoutTheColumnsThatCameLater) {
  const Scratch scratch;
  const fs::path results = scratch.path() / "results";
  const Ended ended = run_mien({"study", "report", former / "closed-loop-1.answers.csv",
                                former / "closed-loop-1.yaml", "-o", results});
  EXPECT_EQ(ended.code, 0) << ended.errors;
  EXPECT_NE(ended.errors.find("is_catch: now called is_check"), std::string::npos) << ended.errors;
  EXPECT_NE(ended.output.find("8 of 8 participants analysed"), std::string::npos) << ended.output;
  const std::string means = text_of(results / "results/means.csv");
  EXPECT_NE(means.find("\nnormal,,,,slow-fast,8,0.875,"), std::string::npos)
      << means.substr(0, 300);
}

TEST(FormerFiles, OfAnswersMayHaveColumnsThatAreNotKnown) {
  const Scratch scratch;
  std::string line, answers;
  std::ifstream file(former / "closed-loop-1.answers.csv");
  for (bool first = true; std::getline(file, line); first = false)
    answers += line + (first ? ",of_the_future\n" : ",1\n");
  const fs::path newer = scratch.write("answers.csv", answers);
  const Ended ended = run_mien(
      {"study", "report", newer, former / "closed-loop-1.yaml", "-o", scratch.path() / "results"});
  EXPECT_EQ(ended.code, 0) << ended.errors;
}

/// A baseline as it was before there were checksums, and one of a version to come.
TEST(FormerFiles, OfBaselinesAreReadWithANoteAndThoseToComeAreRefused) {
  const Scratch scratch;
  scratch.write("study.yaml",
                "mien: 1\nstudy: small\nexamples: {set: builtin:walks-10}\n"
                "output: {size: [64, 48], fps: 10, cycles: 1, quality: draft, frames: none}\n"
                "stimuli: [{id: walk, weights: {normal: 1}}]\n");
  const auto regress = [&](const std::string& words) {
    return run_in(scratch.path(), std::string("'") + MIEN_PROGRAM + "' regress " + words);
  };
  ASSERT_EQ(regress("approve study.yaml --approver Kim --reason first").code, 0);
  const fs::path file = scratch.path() / "baselines/small/baseline.json";
  auto baseline = nlohmann::json::parse(text_of(file));
  ASSERT_EQ(baseline.erase("sums") + baseline.erase("checksum"), 2u);
  std::ofstream(file) << baseline.dump(2);
  const Ended unsummed = regress("study.yaml --without-videos");
  EXPECT_EQ(unsummed.code, 0) << unsummed.errors;
  EXPECT_NE(unsummed.errors.find("this baseline has no checksums"), std::string::npos)
      << unsummed.errors;
  baseline["baseline"] = 2;
  std::ofstream(file) << baseline.dump(2);
  const Ended to_come = regress("study.yaml --without-videos");
  EXPECT_EQ(to_come.code, 2);
  EXPECT_NE(to_come.errors.find("baseline.json"), std::string::npos) << to_come.errors;
}

}  // namespace
}  // namespace mien::test
