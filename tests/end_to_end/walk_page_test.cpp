#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/browser.h"
#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

fs::path built_pages() { return fs::path(MIEN_PROGRAM).parent_path() / "pages"; }

/// Somebody steers the walker in Chromium by keys, a button and sliders; what the page showed is
/// measured once for all tests (page/tests/walk/scenarios.mjs).
class WalkPage : public testing::Test {
 protected:
  static std::string skip_reason() {
    if (chromium().empty()) return "no Chromium here: install it to test pages";
    if (!fs::exists(built_pages() / "live_core/live_core.wasm") ||
        !fs::exists(built_pages() / "walk/walk.js") ||
        !fs::exists(built_pages() / "work/node_modules/playwright-core"))
      return "no build/release/pages/live_core, or no pages: ./mien test makes them where em++ is "
             "installed";
    return "";
  }

  static void SetUpTestSuite() {
    if (!skip_reason().empty()) return;
    const std::string found = run_program({"sh", "-c", "command -v " + chromium()}).output;
    const Ended ended = run_program(
        {"env", "MIEN_CHROMIUM=" + found.substr(0, found.find('\n')), "node",
         (built_pages() / "work/tests/walk/scenarios.mjs").string(),
         (built_pages() / "walk").string(), (built_pages() / "live_core/live_core.wasm").string()},
        400.0);
    EXPECT_EQ(ended.code, 0) << ended.errors;
    measured = json::parse(ended.output, nullptr, false);
  }

  void SetUp() override {
    if (const std::string why = skip_reason(); !why.empty()) GTEST_SKIP() << why;
    ASSERT_TRUE(measured.is_object());
  }

  static inline json measured;
};

TEST_F(WalkPage, KeysSteerIt) {
  const json& steered = measured.at("steered");
  EXPECT_GT(steered.at("fastest"), 1.2);
  EXPECT_LT(steered.at("speed_at_end"), 0.01);
  EXPECT_GT(steered.at("most_heading"), 45.0);
  EXPECT_LT(steered.at("heading_at_end").get<double>(),
            steered.at("most_heading").get<double>() - 45.0);
  EXPECT_EQ(measured.at("troubles"), json::array());
}

TEST_F(WalkPage, StandingFeetStand) {
  EXPECT_LT(measured.at("steered").at("slide_mm"), 5.0);
  EXPECT_LT(measured.at("by_itself").at("slide_mm"), 5.0);
}

/// As in tests/motion/steered_walk/steered_walk_test.cpp.
TEST_F(WalkPage, NothingJumps) { EXPECT_LT(measured.at("by_itself").at("acceleration"), 250.0); }

TEST_F(WalkPage, AMoodIsSeenWithinATenthOfASecond) {
  const json& mood = measured.at("mood");
  EXPECT_EQ(mood.at("before_mm"), 0.0);
  EXPECT_GT(mood.at("three_cm_ms"), 0.0);
  EXPECT_LE(mood.at("three_cm_ms"), 100.0);
}

TEST_F(WalkPage, WalksOnAPhoneByAButton) {
  const json& phone = measured.at("phone");
  EXPECT_GT(phone.at("fastest"), 0.8);
  EXPECT_EQ(phone.at("is_wide"), false);
}

TEST_F(WalkPage, IsSteeredByAGamepad) {
  const json& gamepad = measured.at("gamepad");
  EXPECT_LT(gamepad.at("rested"), 0.02);  // m/s: a stick that is not quite in its middle
  EXPECT_GT(gamepad.at("speed"), 0.8);
  EXPECT_LT(gamepad.at("heading"), -20.0);  // degrees, to the right
  EXPECT_GT(gamepad.at("back"), 20.0);
}

TEST_F(WalkPage, IsOpenedByTheStudio) {
  const Scratch folder;
  const fs::path link = folder.path() / "link.json";
  const fs::path manifest =
      folder.write("my.yaml", text_of(fs::path(MIEN_SOURCE_DIR) / "manifests/quickstart.yaml"));
  const Running studio({"sh", "-c", "exec \"$0\" studio \"$1\" --walk --out \"$2\" --json > \"$3\"",
                        MIEN_PROGRAM, manifest.string(), folder.path().string(), link.string()});
  json told;
  for (int tries = 0; tries < 300 && !told.is_object(); ++tries) {
    pause_for(0.1);
    if (fs::exists(link)) told = json::parse(text_of(link), nullptr, false);
  }
  ASSERT_TRUE(told.is_object());
  const std::string found = run_program({"sh", "-c", "command -v " + chromium()}).output;
  const Ended ended =
      run_program({"env", "MIEN_CHROMIUM=" + found.substr(0, found.find('\n')), "node",
                   (built_pages() / "work/tests/walk/opened.mjs").string(), told.at("link")},
                  100.0);
  EXPECT_EQ(ended.code, 0) << ended.errors;
  const json seen = json::parse(ended.output, nullptr, false);
  EXPECT_EQ(seen.at("troubles"), json::array());
  EXPECT_GT(seen.at("way").get<double>(), 0.5);
}

}  // namespace
}  // namespace mien::test
