#include <csignal>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/live_page.h"
#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr char walks_text[] = R"(mien: 1
study: alike
seed: 7
examples: {set: builtin:walks-10, ratings: builtin}
output: {fps: 30, size: [32, 24], quality: draft, video: [gif], frames: none, clips: [bvh]}
stimuli:
  - {id: aim, role: target, weights: {afraid: 1}}
)";

constexpr char matching_text[] = R"(matching:
  title: Make the same walk
  participants: 2
  consent: Taking part is voluntary.
  ending: Thank you.
)";

/// Participants of a matching experiment.
class MatchingPage : public LivePage {
 protected:
  MatchingPage() : LivePage("matching", std::string(walks_text) + matching_text) {}

  /// Every trial has been matched, and D is what the written clips have.
  void expect_matches(const json& records) {
    std::string stimuli = walks_text;
    std::vector<std::pair<std::string, double>> made;
    for (const auto& [name, record] : records.items()) {
      if (!name.starts_with("trial-")) continue;
      const json& match = record.at("matching");
      EXPECT_TRUE(match.at("success").get<bool>()) << name;
      EXPECT_LT(match.at("d").get<double>(), 0.06) << name;
      for (const char* when : {"first", "last"}) {
        const std::string id = name + "-" + when;
        stimuli += "  - {id: " + id + ", " + wishes(match.at(when)) + "}\n";
        made.emplace_back(id, match.at(when == std::string("first") ? "first_guess_d" : "d"));
      }
    }
    ASSERT_EQ(made.size(), 6u);
    const fs::path clips = scratch.write("clips.yaml", stimuli);
    const Ended run =
        run_mien({"run", clips.string(), "--out", (scratch.path() / "out").string()}, 300.0);
    ASSERT_EQ(run.code, 0) << run.errors;
    const fs::path bvh = scratch.path() / "out/alike/clips";
    for (const auto& [id, d] : made) {
      const Ended compared = run_mien({"motion", "compare", (bvh / "aim.bvh").string(),
                                       (bvh / (id + ".bvh")).string(), "--json"});
      ASSERT_EQ(compared.code, 0) << compared.errors;
      const json found = json::parse(compared.output);
      EXPECT_NEAR(found.at("D").get<double>(), d, 1e-9) << id;
    }
  }

  /// As a stimulus says it.
  static std::string wishes(const json& setting) {
    const std::string first = setting.at("sliders").at(0);
    const std::string kind = first == "normal"      ? "weights"
                             : first == "quickness" ? "adjectives"
                                                    : "features";
    std::string all;
    bool is_nothing = true;
    for (std::size_t i = 0; i < setting.at("sliders").size(); ++i) {
      const double value = setting.at("values").at(i);
      is_nothing = is_nothing && value == 0.0;
      all += (i == 0 ? "" : ", ") + setting.at("sliders").at(i).get<std::string>() + ": " +
             setting.at("values").at(i).dump();
    }
    // Shares that are all 0 make the mean of all.
    if (kind == "weights" && is_nothing) {
      all.clear();
      for (const json& name : setting.at("sliders"))
        all += (all.empty() ? "" : ", ") + name.get<std::string>() + ": 0.1";
    }
    return kind + ": {" + all + "}";
  }
};

TEST_F(MatchingPage, IsMatchedWithEveryInterfaceWithoutAServer) {
  if (!is_exported()) GTEST_SKIP() << no_browser_core;
  const json told = played("whole");
  EXPECT_EQ(told.at("requests"), 0);
  expect_matches(json::parse(told.at("records").get<std::string>()).at("records"));
  const fs::path trials = scratch.write("trials.csv", told.at("trials").get<std::string>());
  const Ended evaluated = run_mien({"study", "evaluate", trials.string(), "-o",
                                    (scratch.path() / "evaluation").string(), "--json"});
  EXPECT_EQ(evaluated.code, 0) << evaluated.errors;
  EXPECT_EQ(json::parse(evaluated.output).at("sessions"), "given");
}

TEST_F(MatchingPage, GoesOnAfterAReloadAndTellsIt) {
  if (!is_exported()) GTEST_SKIP() << no_browser_core;
  const json told = played("reload");
  EXPECT_EQ(told.at("reloads"), 1);
  const json records = json::parse(told.at("records").get<std::string>()).at("records");
  EXPECT_EQ(records.at("trial-1").at("matching").at("attempt"), 2);
  EXPECT_EQ(records.at("trial-2").at("matching").at("attempt"), 1);
}

TEST_F(MatchingPage, IsWorkedByKeyboardAlone) {
  if (!is_exported()) GTEST_SKIP() << no_browser_core;
  const json told = played("keys");
  const json records = json::parse(told.at("records").get<std::string>()).at("records");
  for (const char* trial : {"trial-1", "trial-2", "trial-3"})
    EXPECT_TRUE(records.at(trial).at("matching").at("success").get<bool>()) << trial;
}

TEST_F(MatchingPage, HasNoFaultOfAccessibilityAndTellsPhones) {
  if (!is_exported()) GTEST_SKIP() << no_browser_core;
  const json checked = played("accessibility");
  EXPECT_GT(checked.at("checked").get<int>(), 20);
  EXPECT_EQ(checked.at("faults"), json::array());
  EXPECT_TRUE(played("on_phone").at("is_told").get<bool>());
}

TEST_F(MatchingPage, IsMatchedWithEveryInterfaceOnAServer) {
  Running server = serve();
  const json told = played("whole", link_of(0));
  EXPECT_GT(told.at("requests").get<int>(), 10);
  expect_matches(told.at("posted"));
  server.send(SIGINT);
  EXPECT_EQ(server.wait().code, 0);
}

// All guesses at a target come before anything is made of one, whatever is reloaded.
TEST_F(MatchingPage, ShowsNothingOfAGuessBeforeAllAreMade) {
  scratch.write("study.yaml", std::string(walks_text) + matching_text +
                                  "  order: guesses-first\n  show_examples: true\n");
  Running server = serve();
  const json told = played("guesses_first", link_of(0));
  expect_matches(told.at("posted"));
  EXPECT_FALSE(told.at("film").get<std::string>().empty());
  for (const json& shown : told.at("shows"))
    EXPECT_EQ(shown, json({{"figures", 1}, {"d", nullptr}, {"told", "hidden"}}));

  std::vector<std::string> pages;
  std::size_t seen_at_first = 0;
  for (const std::string one : told.at("story")) {
    if (one == "make" && seen_at_first == 0) seen_at_first = pages.size();
    if (one != "make") pages.push_back(one);
  }
  ASSERT_EQ(pages.size(), 10u) << told.at("story");
  const auto name_at = [&](std::size_t page) { return pages[page].substr(6); };
  const std::vector<std::string> expected = {
      "guess " + name_at(0), "guess " + name_at(1), "reload", "guess " + name_at(1),
      "guess " + name_at(4), "match " + name_at(0), "reload", "match " + name_at(0),
      "match " + name_at(1), "match " + name_at(4)};
  EXPECT_EQ(pages, expected);
  EXPECT_EQ((std::set{name_at(0), name_at(1), name_at(4)}),
            (std::set<std::string>{"adjectives", "features", "weights"}));
  EXPECT_GE(seen_at_first, 5u);  // three guesses, one begun twice, a reload

  const int attempts[] = {2, 2, 1};
  for (int trial = 0; trial < 3; ++trial) {
    const json& match = told.at("posted").at("trial-" + std::to_string(trial + 1)).at("matching");
    EXPECT_EQ(match.at("attempt"), attempts[trial]) << trial;
    EXPECT_EQ(match.at("changes").at(0).at("action"), "move");
    EXPECT_EQ(match.at("changes").at(0).at("value"), match.at("first").at("values").at(0));
    EXPECT_EQ(match.at("changes").at(1).at("action"), "guess");
    EXPECT_EQ(match.at("changes").at(1).at("d"), match.at("first_guess_d"));
  }
  server.send(SIGINT);
  EXPECT_EQ(server.wait().code, 0);
}

}  // namespace
}  // namespace mien::test
