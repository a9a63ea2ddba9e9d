#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "end_to_end/questionnaire_page.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The first of these programs that there is; empty without.
std::string program_among(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const std::string path = run_program({"sh", "-c", "command -v " + name + " || true"}).output;
    if (!path.empty()) return path.substr(0, path.find('\n'));
  }
  return "";
}

/// WebKitGTK's browser for tests, which lies beside its libraries; empty without.
std::string mini_browser() {
  std::vector<std::string> found;
  std::error_code none;
  for (const fs::directory_entry& platform : fs::directory_iterator("/usr/lib", none))
    for (const char* version : {"webkit2gtk-4.1", "webkit2gtk-4.0"})
      if (const fs::path file = platform.path() / version / "MiniBrowser"; fs::exists(file))
        found.push_back(file.string());
  return found.empty() ? "" : found.front();
}

/// What somebody answered in a browser other than Chromium, who reloaded the page in trial 2 while
/// its film was playing.
void expect_taken(const json& taken, const std::string& agent) {
  EXPECT_NE(taken.at("agent").get<std::string>().find(agent), std::string::npos);
  EXPECT_EQ(taken.at("reloads"), 1);
  EXPECT_EQ(rows_in(taken.at("participant").get<std::string>()).at(0).at("finished"), "1");
  const auto rows = rows_in(taken.at("answers").get<std::string>());
  EXPECT_GT(rows.size(), 20u);
  for (const auto& row : rows) {
    if (row.at("kind") == "attention") {
      EXPECT_EQ(row.at("passed"), "1");
      continue;
    }
    EXPECT_EQ(row.at("value_raw"), "2");
    EXPECT_EQ(row.at("attempt"), row.at("trial") == "2" ? "2" : "1");
    EXPECT_EQ(row.at("replays"), row.at("trial") == "2" ? "1" : "0");
    EXPECT_EQ(row.at("play_fault"), "");
    const double played_ms = std::stod(row.at("ended_ms")) - std::stod(row.at("play_start_ms"));
    EXPECT_GT(played_ms, 800.0) << "a film of 1.1 s, in trial " << row.at("trial");
  }
}

TEST_F(QuestionnairePage, IsTakenInFirefox) {
  const fs::path packages = page_tests() / "../../../browsers";
  const std::string firefox = program_among({"firefox-esr", "firefox"});
  if (firefox.empty() || !fs::exists(packages / "node_modules/puppeteer-core"))
    GTEST_SKIP() << "no Firefox here, or nothing that drives it: ./mien test --all brings both";
  expect_taken(output_of({(page_tests() / "other_browsers.mjs").string(), "firefox",
                          folder().string(), packages.string(), firefox}),
               "Firefox/");
}

TEST_F(QuestionnairePage, IsTakenInWebKit) {
  const fs::path packages = page_tests() / "../../../browsers";
  if (program_among({"WebKitWebDriver"}).empty() || program_among({"xvfb-run"}).empty() ||
      mini_browser().empty() || !fs::exists(packages / "node_modules/selenium-webdriver"))
    GTEST_SKIP() << "no WebKitGTK here, or nothing that drives it: ./mien test --all brings both";
  expect_taken(output_of({(page_tests() / "other_browsers.mjs").string(), "webkit",
                          folder().string(), packages.string(), mini_browser()}),
               "AppleWebKit/");
}

}  // namespace
}  // namespace mien::test
