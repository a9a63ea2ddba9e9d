#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;

/// What tests of pages/tests say that run in Node.js, without a browser.
class PageModules : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(work_ / "node_modules/typescript"))
      GTEST_SKIP() << "no typescript in build/release/pages/work: ./mien test brings it";
  }

  void expect_passed(std::vector<std::string> command) const {
    command.insert(command.begin(), {"env", "-C", work_.string(),
                                     "MIEN_MANIFESTS=" MIEN_SOURCE_DIR "/manifests", "node"});
    const Ended ended = run_program(command, 300.0);
    EXPECT_EQ(ended.code, 0) << ended.output << ended.errors;
  }

 private:
  fs::path work_ = fs::path(MIEN_PROGRAM).parent_path() / "pages/work";
};

TEST_F(PageModules, ImportOneAnotherInNoCircleAndExportWhatIsUsed) {
  expect_passed({"--test", "tests/modules.mjs"});
}

TEST_F(PageModules, AreOfTheTypesThatTheyTell) {
  expect_passed({"node_modules/typescript/bin/tsc", "--noEmit"});
}

TEST_F(PageModules, SayWhatTheyHaveToInEachLanguage) {
  expect_passed({"--test", "tests/texts.mjs"});
}

TEST_F(PageModules, FindTheStepsOfChainsFromTheAnswersBeforeThem) {
  expect_passed({"--test", "tests/chains/steps.mjs"});
}

TEST_F(PageModules, KeepSessionsWhateverFailsAroundThem) {
  expect_passed({"--test", "tests/stores.mjs"});
}

/// Manifests that the studio saves.
TEST_F(PageModules, EditManifestsAndKeepWhatTheyDoNotChangeToTheByte) {
  expect_passed({"--test", "tests/studio/manifest_edit.mjs"});
}

}  // namespace
}  // namespace mien::test
