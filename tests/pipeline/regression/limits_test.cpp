#include <optional>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

/// A manifest whose sixth line, and that of its stimulus, are given.
class Limits : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& limits, const std::string& own) const {
    const auto file = folder_.path() / "m.yaml";
    write_file(file, "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\n" + limits +
                         "\nstimuli:\n  - id: a\n    weights: {sad: 1}\n    " + own + "\n");
    return file;
  }
  static std::optional<std::string> no_variable(const std::string&) { return std::nullopt; }

  std::string refusal(const std::string& limits, const std::string& own) const {
    try {
      load_manifest(write(limits, own), no_variable);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }

  test::TemporaryFolder folder_;
};

TEST_F(Limits, OfAStimulusAreLaidOverThoseOfTheStudy) {
  const Manifest manifest =
      load_manifest(write("regression: {position_mm: 3, parts_mm: {left hand: 5}}",
                          "regression: {perceptual: 0.02}"),
                    no_variable);
  const RegressionLimits& limits = manifest.stimuli.at(0).regression;
  EXPECT_EQ(limits.position_mm, 3.0);
  EXPECT_EQ(limits.perceptual, 0.02);
  ASSERT_EQ(limits.parts_mm.size(), 1u);
  EXPECT_EQ(limits.parts_mm[0].first, "left hand");
  EXPECT_EQ(limits.parts_mm[0].second, 5.0);
  EXPECT_EQ(limits.psnr_db, RegressionLimits{}.psnr_db);
}

TEST_F(Limits, ThatAreWrongAreToldWithTheirPlace) {
  struct Wrong {
    const char* limits;
    const char* own;
    const char* place;
    const char* words;
  };
  const Wrong wrong_ones[] = {
      {"regression: {position_mm: -1}", "", "m.yaml:4:27: regression.position_mm",
       "use a number of 0 or more"},
      {"", "regression: {perceptual: 2}", "m.yaml:8:30: stimuli[0].regression.perceptual", "1"},
      {"regression: {positon_mm: 1}", "", "m.yaml:4:14: regression", "position_mm"},
      {"regression: {findings: 3}", "", "m.yaml:4:24: regression.findings", "true"},
      {"regression: 3", "", "m.yaml:4:13: regression", "map"},
      {"regression: {parts_mm: {left hnad: 1}}", "", "m.yaml:4:25: regression.parts_mm",
       "left hand"},
      {"", "regression: {parts_mm: {left hnad: 1}}", "m.yaml:8:29: stimuli[0].regression.parts_mm",
       "left hand"},
      {"regression: {parts_mm: {left hand: -1}}", "", "m.yaml:4:36: regression.parts_mm",
       "use a number of 0 or more"},
  };
  for (const Wrong& wrong : wrong_ones) {
    const std::string said = refusal(wrong.limits, wrong.own);
    EXPECT_NE(said.find(wrong.place), std::string::npos) << wrong.place << " is not in\n" << said;
    EXPECT_NE(said.find(wrong.words), std::string::npos) << wrong.words << " is not in\n" << said;
    EXPECT_EQ(std::ranges::count(said, '\n'), 0) << said;
  }
}

}  // namespace
}  // namespace mien::pipeline
