#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
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

/// The same of films that were rated while they played: the marker stood at its start, and moved to
/// the right while an arrow key was held.
void expect_traced(const json& taken, const std::string& agent) {
  EXPECT_NE(taken.at("agent").get<std::string>().find(agent), std::string::npos);
  EXPECT_EQ(taken.at("reloads"), 1);
  const auto rows = rows_in(taken.at("answers").get<std::string>());
  ASSERT_EQ(rows.size(), 2u);
  for (const auto& row : rows) {
    EXPECT_EQ(row.at("kind"), "continuous");
    EXPECT_EQ(row.at("attempt"), row.at("trial") == "2" ? "2" : "1");
    EXPECT_EQ(row.at("plays_before"), row.at("trial") == "2" ? "1" : "0");
    EXPECT_EQ(row.at("play_fault"), "");
    std::istringstream samples(row.at("value_raw"));
    const std::vector<double> trace{std::istream_iterator<double>(samples), {}};
    ASSERT_GT(trace.size(), 20u) << "a film of more than 2 s, ten samples a second";
    EXPECT_EQ(trace.front(), 50.0);
    EXPECT_EQ(trace.at(2), 50.0);
    EXPECT_GT(trace.back(), 55.0);
    EXPECT_TRUE(std::ranges::is_sorted(trace)) << row.at("value_raw");
    EXPECT_GT(std::stod(row.at("rt_ms")), 200.0);
  }
}

fs::path packages() { return page_tests() / "../../../browsers"; }

/// Empty if it cannot be driven.
std::string firefox() {
  return fs::exists(packages() / "node_modules/puppeteer-core")
             ? program_among({"firefox-esr", "firefox"})
             : "";
}
std::string webkit() {
  const bool is_driven = !program_among({"WebKitWebDriver"}).empty() &&
                         !program_among({"xvfb-run"}).empty() &&
                         fs::exists(packages() / "node_modules/selenium-webdriver");
  return is_driven ? mini_browser() : "";
}

/// A script by which somebody takes the questionnaire in a folder.
std::vector<std::string> script(const char* browser, const std::string& program,
                                const fs::path& folder) {
  return {(page_tests() / "other_browsers.mjs").string(), browser, folder.string(),
          packages().string(), program};
}

/// Exports the questionnaire of films that are rated while they play.
fs::path exported_traces(const fs::path& scratch) {
  const fs::path there = scratch / "traces";
  if (fs::exists(there)) return there;
  std::ofstream(scratch / "traces.yaml") << continuous_study_text;
  must_run(mien_with({"study", "export", (scratch / "traces.yaml").string(), "--out",
                      (scratch / "out-traces").string(), "-o", there.string()}));
  return there;
}

constexpr char no_firefox[] =
    "no Firefox here, or nothing that drives it: ./mien test --all brings both";
constexpr char no_webkit[] =
    "no WebKitGTK here, or nothing that drives it: ./mien test --all brings both";

TEST_F(QuestionnairePage, IsTakenInFirefox) {
  if (firefox().empty()) GTEST_SKIP() << no_firefox;
  expect_taken(output_of(script("firefox", firefox(), folder())), "Firefox/");
}

TEST_F(QuestionnairePage, IsTakenInWebKit) {
  if (webkit().empty()) GTEST_SKIP() << no_webkit;
  expect_taken(output_of(script("webkit", webkit(), folder())), "AppleWebKit/");
}

TEST_F(QuestionnairePage, TakesTracesInFirefox) {
  if (firefox().empty()) GTEST_SKIP() << no_firefox;
  expect_traced(output_of(script("firefox", firefox(), exported_traces(scratch->path()))),
                "Firefox/");
}

TEST_F(QuestionnairePage, TakesTracesInWebKit) {
  if (webkit().empty()) GTEST_SKIP() << no_webkit;
  expect_traced(output_of(script("webkit", webkit(), exported_traces(scratch->path()))),
                "AppleWebKit/");
}

}  // namespace
}  // namespace mien::test
