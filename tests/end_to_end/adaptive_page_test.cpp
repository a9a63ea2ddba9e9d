// Adaptive trials in Chromium (page/tests/questionnaire/adaptive.mjs): in a folder, on JATOS and
// from a server.

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "end_to_end/questionnaire_page.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A neutral walk and four levels of sadness; `adaptive` is the rule.
std::string sadness_text(const std::string& adaptive) {
  return R"(mien: 1
study: sadness
seed: 7
examples: {set: builtin:walks-10}
output: {size: [96, 72], fps: 15, cycles: 1, quality: draft, video: [mp4], frames: none}
stimuli:
  - {id: none, weights: {normal: 1}, factors: {sadness: 0}}
  - {id: little, weights: {normal: 0.8, sad: 0.2}, factors: {sadness: 0.2}}
  - {id: some, weights: {normal: 0.6, sad: 0.4}, factors: {sadness: 0.4}}
  - {id: much, weights: {normal: 0.4, sad: 0.6}, factors: {sadness: 0.6}}
  - {id: all, weights: {normal: 0.2, sad: 0.8}, factors: {sadness: 0.8}}
questionnaire:
  participants: 2
  trials: two_interval
  question: Which walk was sadder?
  adaptive: )" +
         adaptive + "\n";
}

constexpr char staircase_rule[] =
    "{method: staircase, factor: sadness, trials: 12, tracks: 2, reversals: 4}";

class AdaptivePage : public QuestionnairePage {
 protected:
  using Row = std::map<std::string, std::string>;

  static void SetUpTestSuite() {
    QuestionnairePage::SetUpTestSuite();
    if (!scratch) return;
    manifest = scratch->write("sadness.yaml", sadness_text(staircase_rule));
    there = shared_set_up("adaptive page",
                          [](const fs::path& folder) {
                            must_run(mien_with({"study", "export", manifest.string(), "--out",
                                                (folder / "out").string(), "-o",
                                                (folder / "page").string()}));
                          }) /
            "page";
  }

  /// A staircase by hand: two right answers in a row make it harder, a wrong one easier; it ends
  /// with the fourth reversal.
  struct Staircase {
    int place = 3, right = 0, direction = 0, reversals = 0;

    void take(bool is_right) {
      right = is_right ? right + 1 : 0;
      const int step = right == 2 ? -1 : is_right ? 0 : 1;
      if (step == 0) return;
      right = 0;
      reversals += direction == -step ? 1 : 0;
      direction = step;
      place = std::clamp(place + step, 0, 3);
    }
  };

  /// Checks that each level follows from the answers before it, and counts the rows of each track.
  static std::map<std::string, int> expect_staircases(const std::vector<Row>& rows) {
    const std::vector<std::string> levels = {"0.2", "0.4", "0.6", "0.8"};
    const std::map<std::string, std::string> level_of = {
        {"none", "0"}, {"little", "0.2"}, {"some", "0.4"}, {"much", "0.6"}, {"all", "0.8"}};
    std::map<std::string, Staircase> tracks;
    std::map<std::string, int> counts;
    for (const Row& row : rows) {
      EXPECT_EQ(row.at("kind"), "two_interval");
      Staircase& track = tracks[row.at("track")];
      ++counts[row.at("track")];
      EXPECT_LT(track.reversals, 4) << "trial " << row.at("trial");
      EXPECT_EQ(row.at("level"), levels.at(static_cast<std::size_t>(track.place)))
          << "trial " << row.at("trial");
      const bool is_first = row.at("against") == "none";
      EXPECT_TRUE(is_first || row.at("stimulus") == "none");
      EXPECT_EQ(level_of.at(row.at(is_first ? "stimulus" : "against")), row.at("level"));
      EXPECT_EQ(row.at("value"),
                row.at("value_raw") == "first" ? row.at("stimulus") : row.at("against"));
      track.take(row.at("value") != "none");
    }
    for (const auto& [name, track] : tracks)
      EXPECT_TRUE(track.reversals == 4 || counts[name] == 12) << name;
    return counts;
  }

  static json taken(const std::string& mode, const std::string& given) {
    return output_of({(page_tests() / "adaptive.mjs").string(), mode, given});
  }

  inline static fs::path manifest, there;
};

TEST_F(AdaptivePage, ChoosesLevelsAsTheProgramDoes) {
  const fs::path cases = MIEN_SOURCE_DIR "/tests/pipeline/study/thresholds/track_cases.json";
  const json told = output_of({(page_tests() / "tracks.mjs").string(), cases.string()});
  EXPECT_GT(told.at("compared").get<int>(), 2000);
}

TEST_F(AdaptivePage, FollowsTheAnswersInAFolderAlsoAfterReloads) {
  const json told = taken("folder", there.string());
  EXPECT_EQ(told.at("troubles"), json::array());
  EXPECT_EQ(told.at("reloads"), 2);
  const auto rows = rows_in(told.at("answers").get<std::string>());
  const auto counts = expect_staircases(rows);
  EXPECT_EQ(counts.size(), 2u);
  EXPECT_EQ(told.at("seen").size(), rows.size()) << "trials of ended tracks are skipped";
  EXPECT_LT(rows.size(), 24u) << "with answers at random, tracks end early";
  for (const Row& row : rows)
    EXPECT_EQ(row.at("attempt"), row.at("trial") == "3" || row.at("trial") == "6" ? "2" : "1");
  const auto people = rows_in(told.at("participant").get<std::string>());
  EXPECT_EQ(people.at(0).at("finished"), "1");
  // A report takes the answers.
  const fs::path answers = scratch->write("answers.csv", told.at("answers").get<std::string>());
  const fs::path report = scratch->path() / "report";
  must_run(
      mien_with({"study", "report", answers.string(), manifest.string(), "-o", report.string()}));
  const auto trials = rows_in(text_of(report / "results/track_trials.csv"));
  ASSERT_EQ(trials.size(), rows.size());
  EXPECT_EQ(rows_in(text_of(report / "results/thresholds.csv")).size(), 2u);
}

TEST_F(AdaptivePage, FollowsTheAnswersOnJatos) {
  const json run = played("jatos", there);
  const auto counts = expect_staircases(rows_in(run.at("answers").get<std::string>()));
  EXPECT_EQ(counts.size(), 2u);
}

TEST_F(AdaptivePage, IsServedWithLevelsThatTheServerPermits) {
  const fs::path served = scratch->write(
      "served.yaml", sadness_text("{method: quest, factor: sadness, trials: 5, tracks: 2}"));
  const fs::path said = scratch->path() / "served.txt";
  const Running server({"sh", "-c", "told=$1; shift; exec \"$@\" >\"$told\"", "sh", said.string(),
                        MIEN_PROGRAM, "study", "serve", served.string(), "--out",
                        (scratch->path() / "out-served").string(), "--port", "0", "--json",
                        "--store", (scratch->path() / "served.db").string()});
  json places;
  for (int tries = 0; tries < 3000 && !places.is_object(); ++tries) {
    pause_for(0.1);
    places = json::parse(text_of(said), nullptr, false);
  }
  ASSERT_TRUE(places.is_object());
  const json told = taken("served", places.at("join"));
  EXPECT_EQ(told.at("troubles"), json::array());
  EXPECT_EQ(told.at("seen").size(), 10u);
  const std::string answers =
      run_program({"node", "-e",
                   "fetch(process.argv[1]).then(r => r.text()).then(t => process.stdout.write(t))",
                   places.at("lab").get<std::string>() + "answers.csv"})
          .output;
  const auto rows = rows_in(answers);
  ASSERT_EQ(rows.size(), 10u);
  std::map<std::string, int> tracks;
  for (const Row& row : rows) {
    ++tracks[row.at("track")];
    EXPECT_FALSE(row.at("level").empty());
  }
  EXPECT_EQ(tracks, (std::map<std::string, int>{{"1", 5}, {"2", 5}}));
}

/// The shipped study, from simulated observers to the report, without films.
TEST(AdaptiveStudy, FindsTheThresholdOfSimulatedObservers) {
  const Scratch here;
  const std::string answers = (here.path() / "answers.csv").string();
  const fs::path report = here.path() / "report";
  must_run(mien_with({"study", "simulate", "sadness-threshold", "--threshold", "0.3",
                      "--threshold-sd", "0.05", "--width", "0.05", "-o", answers}));
  must_run(mien_with({"study", "report", answers, "sadness-threshold", "-o", report.string()}));
  const auto means = rows_in(text_of(report / "results/mean_threshold.csv"));
  ASSERT_EQ(means.size(), 2u);
  for (const auto& row : means) {
    EXPECT_EQ(row.at("all"), "20");
    // Standard errors are about 0.012; posterior means are 0.03 to 0.04 too low
    // (results/README.md).
    EXPECT_NEAR(std::stod(row.at("threshold")), 0.3, 0.08) << row.at("estimate");
    EXPECT_LT(std::stod(row.at("low")), std::stod(row.at("high")));
    EXPECT_EQ(row.at("simulated"), "1");
  }
  const std::string page = text_of(report / "report.html");
  EXPECT_NE(page.find("QUEST+, Watson 2017"), std::string::npos);
  EXPECT_TRUE(fs::exists(report / "figures/proportions-by-level.svg"));
  EXPECT_TRUE(fs::exists(report / "figures/tracks.svg"));
}

TEST(AdaptiveStudy, RefusesWhatItCannotDo) {
  const auto errors_of = [](const std::vector<std::string>& words) {
    const Ended ended = run_program(mien_with(words), 60.0);
    EXPECT_EQ(ended.code, 2) << ended.errors;
    return ended.errors;
  };
  const Scratch here;
  EXPECT_NE(errors_of({"study", "design", "sadness-threshold", "--power"})
                .find("the power of thresholds is not estimated"),
            std::string::npos);
  const fs::path truth = here.write("truth.csv", "stimulus,scale,value\n");
  EXPECT_NE(errors_of({"study", "simulate", "sadness-threshold", "--truth", truth.string()})
                .find("psychometric function"),
            std::string::npos);
  EXPECT_NE(errors_of({"study", "simulate", "grid-study", "--threshold", "0.3"})
                .find("apply to adaptive trials only"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::test
