#include "end_to_end/questionnaire_page.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST_F(QuestionnairePage, GoesOnAfterAReload) {
  const json reloaded = played("reload");
  EXPECT_EQ(reloaded.at("troubles"), json::array());
  EXPECT_EQ(reloaded.at("reloads"), 1);
  // No trial was seen twice but the one that was left.
  std::vector<int> numbers = reloaded.at("seen");
  for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], static_cast<int>(i) + 1);
  expect_complete(reloaded, "p002");
  // Films beside each other leave space in their elements, which is no part of them.
  int films = 0;
  for (const auto& row : rows_in(reloaded.at("answers").get<std::string>())) {
    if (row.at("shown_width").empty()) continue;
    ++films;
    EXPECT_NEAR(std::stod(row.at("shown_height")), 0.4 * 768.0, 1.0);
    EXPECT_NEAR(std::stod(row.at("shown_width")), 0.4 * 768.0 * 96.0 / 72.0, 1.0);
  }
  EXPECT_GT(films, 10);
}

TEST_F(QuestionnairePage, KnowsAfterAReloadWhatWasWatchedAndLeavesOutWhatCannotBePlayed) {
  const json told = output_of({(page_tests() / "attempts.mjs").string(), folder().string()});
  for (const char* replays : {"none", "once", "counted"}) {
    const json& taken = told.at(replays);
    EXPECT_EQ(taken.at("troubles"), json::array());
    EXPECT_EQ(taken.at("is_locked"), true) << "the first playing was broken off";
    EXPECT_EQ(taken.at("offered"), replays != std::string("none"))
        << replays << ": one playing was interrupted and one was not";
    EXPECT_EQ(taken.at("focus"), true) << "what was watched once may be answered";
    const auto rows = rows_of_trial(taken, 1);
    ASSERT_FALSE(rows.empty());
    for (const auto& row : rows) {
      EXPECT_EQ(row.at("attempt"), "3");
      EXPECT_EQ(row.at("plays_before"), "2");
      EXPECT_EQ(row.at("replays"), "1");
      EXPECT_GT(std::stod(row.at("watched_before_ms")), 500.0);
      EXPECT_LT(std::stod(row.at("watched_before_ms")), 30'000.0);
    }
    const auto others = rows_of_trial(taken, 2);
    ASSERT_FALSE(others.empty());
    for (const auto& row : others) {
      EXPECT_EQ(row.at("attempt"), "1");
      EXPECT_EQ(row.at("plays_before") + row.at("watched_before_ms"), "00");
      EXPECT_EQ(row.at("play_fault"), "");
    }
  }
  const json& taken = told.at("unplayable");
  std::map<std::string, std::string> faults;  // by trial
  for (const auto& row : rows_in(taken.at("answers").get<std::string>())) {
    faults[row.at("trial")] = row.at("play_fault");
    if (row.at("kind") == "attention") continue;
    EXPECT_EQ(row.at("value_raw") + row.at("value") + row.at("rt_ms"), "") << row.at("trial");
    EXPECT_EQ(row.at("attempt"), row.at("is_practice") == "1" ? "1" : "2") << "tried once more";
  }
  EXPECT_EQ(faults, (std::map<std::string, std::string>{{"1", "stalled"},
                                                        {"2", "not_loaded"},
                                                        {"3", "not_decoded"},
                                                        {"4", ""},
                                                        {"5", "not_loaded"}}));
  EXPECT_EQ(taken.at("faults").at(0).at("first"), 0) << "it is started once more first";
  const auto people = rows_in(taken.at("participant").get<std::string>());
  EXPECT_EQ(people.at(0).at("finished"), "1");
}

TEST_F(QuestionnairePage, IsTakenByKeysAlone) {
  const json taken = played("keys");
  EXPECT_EQ(taken.at("troubles"), json::array());
  expect_complete(taken, "p001");
  EXPECT_EQ(rows_in(taken.at("participant").get<std::string>()).at(0).at("hand"), "right")
      << "the second of a list, by the key 2";
}

TEST_F(QuestionnairePage, WaitsForItsVideosAndTellsWhenOneStalls) {
  const json stalled = played("stall");
  expect_complete(stalled, "p003");
  EXPECT_EQ(stalled.at("again"), 1);  // one came broken
  EXPECT_GT(stalled.at("first_trial_ms"), stalled.at("late_ms"));
  const auto rows = rows_in(stalled.at("answers").get<std::string>());
  for (const auto& row : rows) {
    if (row.at("trial") != "2") continue;
    EXPECT_GE(std::stoi(row.at("stalls")), 1);  // a busy machine adds its own
    EXPECT_GE(std::stod(row.at("stall_ms")), 400.0);
  }
}

TEST_F(QuestionnairePage, RunsOnJatos) {
  const json run = played("jatos");
  EXPECT_EQ(run.at("troubles"), json::array());
  EXPECT_EQ(run.at("reloads"), 1);
  // The others had been given out, and the first try to take this one was refused.
  EXPECT_EQ(run.at("taken"), (json{{"p001", 1}, {"p002", 1}, {"p003", 1}}));
  EXPECT_EQ(run.at("files"), (json{"p002-participants.csv", "p002-records.json"}));
  for (const auto& row : rows_in(run.at("answers").get<std::string>())) {
    EXPECT_EQ(row.at("jatos_worker"), "7");
    EXPECT_EQ(row.at("jatos_batch"), "3");
    EXPECT_EQ(row.at("jatos_result"), "12");
  }
  EXPECT_EQ(run.at("withdrawn").at("aborted"), true);
  EXPECT_FALSE(run.at("withdrawn").contains("result"));
  // JATOS leads to the study's own End Redirect URL, once the participant has read the last page.
  EXPECT_EQ(run.at("ended_before_it_was_read"), false);
  EXPECT_FALSE(rows_in(run.at("answers").get<std::string>()).empty());
}

TEST_F(QuestionnairePage, SendsEachRecordUntilTheServerHasIt) {
  const json run = played("served");
  EXPECT_EQ(run.at("troubles"), json::array());
  EXPECT_EQ(run.at("wrong"), json::array());
  EXPECT_EQ(run.at("saved"), json::array());
  EXPECT_EQ(run.at("reloads"), 1);
  const json experiment = json::parse(text_of(folder() / "experiment.json"));
  json records = {"consent", "demographics"};
  for (const json& trial : experiment.at("sessions")[0].at("trials"))
    records.push_back("trial-" + std::to_string(trial.at("number").get<int>()));
  records.push_back("ending");
  EXPECT_EQ(run.at("kept"), records);
}

/// A trial without a stimulus has no size.
TEST_F(QuestionnairePage, ShowsStimuliInTheSizeThatIsAskedFor) {
  // Two films beside each other, 400 px wide each: neither fits the first window of 600 px.
  constexpr double pi = 3.14159265358979, card_mm = 85.6, distance_cm = 50.0;
  const double cm = 400.0 * card_mm / 400.0 / 10.0;
  const double degrees = 2.0 * std::atan(cm / 2.0 / distance_cm) * 180.0 / pi;
  std::string text = study_text;
  text += "  display: {distance_cm: 50, size: {degrees: " + std::to_string(degrees) + "}}\n";
  const fs::path manifest = scratch->write("sized.yaml", text);
  const fs::path there = scratch->path() / "sized";
  must_run(mien_with({"study", "export", manifest.string(), "--out",
                      (scratch->path() / "out-sized").string(), "-o", there.string()}));
  const json taken = played("calibrated", there);
  EXPECT_EQ(taken.at("troubles"), json::array());
  EXPECT_NEAR(taken.at("card").get<double>(), 400.0, 0.01);
  EXPECT_TRUE(taken.at("before").at("is_disabled"));
  EXPECT_NE(taken.at("before").at("why").get<std::string>().find("before you confirm"),
            std::string::npos);
  EXPECT_EQ(taken.at("after"), (json{{"is_disabled", false}, {"why", ""}}));
  EXPECT_NE(taken.at("sit").get<std::string>().find("about 50 cm"), std::string::npos);
  EXPECT_NE(taken.at("asked").get<std::string>().find("at least 912"), std::string::npos)
      << taken.at("asked");
  EXPECT_EQ(taken.at("overflows"), false);
  for (const json& width : taken.at("seen")) EXPECT_NEAR(width.get<double>(), 400.0, 0.1);
  EXPECT_EQ(taken.at("seen").size(), 2u);
  int sized = 0;
  for (const auto& row : rows_in(taken.at("answers").get<std::string>())) {
    if (row.at("kind") == "attention") {
      EXPECT_EQ(row.at("shown_width"), "");
      continue;
    }
    ++sized;
    EXPECT_NEAR(std::stod(row.at("shown_width")), 400.0, 0.1);
    EXPECT_NEAR(std::stod(row.at("shown_height")), 300.0, 0.1);
    EXPECT_EQ(row.at("pixel_ratio"), "2");
    EXPECT_NEAR(std::stod(row.at("shown_cm")), cm, 0.01);
    EXPECT_NEAR(std::stod(row.at("shown_degrees")), degrees, 0.01);
  }
  EXPECT_GT(sized, 10);
}

TEST_F(QuestionnairePage, MeasuresTheViewingDistanceWithTheBlindSpot) {
  constexpr double pi = 3.14159265358979, card_mm = 85.6, card_px = 400.0, degrees = 8.0;
  const std::string text = std::string(study_text) +
                           "  display: {distance_cm: 60, size: {degrees: 8}, blind_spot: true}\n";
  const fs::path manifest = scratch->write("distant.yaml", text);
  const fs::path there = scratch->path() / "distant";
  must_run(mien_with({"study", "export", manifest.string(), "--out",
                      (scratch->path() / "out-distant").string(), "-o", there.string()}));
  const json told = output_of({(page_tests() / "blind_spot.mjs").string(), there.string()});
  const auto width_px = [&](double distance_cm) {
    return 20.0 * distance_cm * std::tan(degrees / 2.0 * pi / 180.0) * card_px / card_mm;
  };
  EXPECT_EQ(told.at("measured").at("faults"), json::array());
  for (const char* who : {"measured", "unmeasured"}) {
    EXPECT_EQ(told.at(who).at("troubles"), json::array());
    int shown = 0;
    for (const auto& row : rows_in(told.at(who).at("answers").get<std::string>())) {
      if (row.at("kind") == "attention") continue;
      ++shown;
      double distance_cm = 60.0;
      if (who == std::string("measured")) {
        distance_cm = std::stod(row.at("viewing_cm"));
        EXPECT_GT(distance_cm, 49.8) << "the median of 48 … 52 cm";
        EXPECT_LT(distance_cm, 53.0) << "and a few frames";
      } else {
        EXPECT_EQ(row.at("viewing_cm"), "");
      }
      EXPECT_NEAR(std::stod(row.at("shown_width")), width_px(distance_cm), 0.5);
      EXPECT_NEAR(std::stod(row.at("shown_degrees")), degrees, 0.01);
    }
    EXPECT_GT(shown, 10);
  }
  EXPECT_NE(told.at("unmeasured").at("said").get<std::string>().find("try once more"),
            std::string::npos);
}

TEST_F(QuestionnairePage, PlaysFilmsWithTheirSoundToWhoHearsIt) {
  std::string text = study_text;
  for (const char* id : {"sad", "proud"}) {
    const std::string begin = std::string("{id: ") + id + ", ";
    text.replace(text.find(begin), begin.size(), begin + "audio: {file: tone.wav, length: cut}, ");
  }
  text.replace(text.find("  reference: usual\n"), 19, "  screening: {sound: true}\n");
  scratch->write("tone.wav", wav_of_tone(3.0));
  const fs::path manifest = scratch->write("heard.yaml", text);
  const fs::path there = scratch->path() / "heard";
  must_run(mien_with({"study", "export", manifest.string(), "--out",
                      (scratch->path() / "out-heard").string(), "-o", there.string()}));
  const json taken = played("heard", there);
  EXPECT_EQ(taken.at("troubles"), json::array());
  EXPECT_EQ(taken.at("deaf"), json::array());
  EXPECT_EQ(taken.at("violations"), json::array());
  EXPECT_NE(taken.at("turned_away").get<std::string>().find("you cannot take part"),
            std::string::npos);
  for (const json& count : taken.at("counts")) {
    EXPECT_GE(count, 3);
    EXPECT_LE(count, 7);
  }
  EXPECT_EQ(taken.at("is_disabled"), true) << "before anything was heard";
  EXPECT_EQ(taken.at("refused"), "Please enter a number.");
  // The first is for practice, and has no sound.
  const std::vector<bool> muted = taken.at("muted");
  ASSERT_GT(muted.size(), 2u);
  EXPECT_TRUE(muted.front());
  EXPECT_EQ(std::ranges::count(muted, true), 1);
  const auto people = rows_in(taken.at("participant").get<std::string>());
  ASSERT_EQ(people.size(), 1u);
  EXPECT_EQ(people[0].at("tones_1"), std::to_string(taken.at("counts")[1].get<int>() + 1));
  EXPECT_EQ(people[0].at("tones_2"), std::to_string(taken.at("counts")[2].get<int>()));
  EXPECT_EQ(people[0].at("screening_fault"), "");
  std::set<std::string> events;
  for (const auto& row : rows_in(taken.at("answers").get<std::string>()))
    events.insert(row.at("volume_events"));
  EXPECT_EQ(events.size(), 2u) << "those of one trial, and none";
  const std::string told = *events.rbegin();
  EXPECT_NE(told.find(":0.5 "), std::string::npos) << told;
  EXPECT_TRUE(told.ends_with(":0")) << told;
}

TEST_F(QuestionnairePage, ShowsPairsInTurnAndTakesTies) {
  std::string text = study_text;
  text.replace(text.find("  stimuli: [sad, proud]"), 23, "  trials: pair");
  text.replace(text.find("  reference: usual\n"), 19, "");
  text.replace(text.find("  practice: [usual]\n  warm_up: 1\n"), 32,
               "  preference: {ties: true, strength: true, shown: in_turn}\n");
  text += R"(
  debriefing: We wanted to know which walk looks happier.
  display: {size: {cm: 6}}
  screening:
    refresh_hz: 1
    questions: [{id: vision, ask: "Do you see well?", answer: ["yes", "no"], accept: "yes"}]
)";
  const fs::path manifest = scratch->write("pairs.yaml", text);
  const fs::path there = scratch->path() / "pairs";
  must_run(mien_with({"study", "export", manifest.string(), "--out",
                      (scratch->path() / "out-pairs").string(), "-o", there.string()}));
  const json taken = played("pairs", there);
  EXPECT_EQ(taken.at("troubles"), json::array());
  // The one, nothing for half a second, the other, and answers afterwards.
  std::vector<std::string> shown;
  std::map<std::string, double> at;
  for (const json& frame : taken.at("frames")) {
    shown.push_back(frame.at("shown"));
    at.emplace(shown.back(), frame.at("at"));
  }
  if (!shown.empty() && shown.front() == "00") {  // before the first has begun
    shown.erase(shown.begin());
    at["00"] = taken.at("frames").at(2).at("at");
  }
  EXPECT_EQ(shown, (std::vector<std::string>{"10", "00", "01"}));
  EXPECT_GE(at.at("01") - at.at("00"), 450.0);
  EXPECT_GE(at.at("00") - at.at("10"), 700.0) << "films of about a second";
  std::set<std::string> raws;
  for (const auto& row : rows_in(taken.at("answers").get<std::string>())) {
    const std::string raw = row.at("value_raw");
    if (row.at("kind") == "attention") {
      EXPECT_TRUE(raw == "left_much" || raw == "right_much") << raw;
      EXPECT_EQ(row.at("passed"), "1");
      continue;
    }
    raws.insert(raw);
    EXPECT_EQ(row.at("value"), raw == "tie"              ? "tie"
                               : raw.starts_with("left") ? row.at("stimulus")
                                                         : row.at("against"));
  }
  EXPECT_EQ(raws, (std::set<std::string>{"left_much", "left_slightly", "right_much",
                                         "right_slightly", "tie"}));
  const json checked = played("accessibility", there);
  EXPECT_EQ(checked.at("faults"), json::array());
}

TEST_F(QuestionnairePage, ShowsPairsInTurnAsLargeAsTheWindowAllows) {
  std::string text = study_text;
  text.replace(text.find("  stimuli: [sad, proud]"), 23, "  trials: pair");
  text.replace(text.find("  reference: usual\n"), 19, "");
  text.replace(text.find("  practice: [usual]\n  warm_up: 1\n"), 32,
               "  preference: {shown: in_turn}\n");
  const fs::path manifest = scratch->write("large-pairs.yaml", text);
  const fs::path there = scratch->path() / "large-pairs";
  must_run(mien_with({"study", "export", manifest.string(), "--out",
                      (scratch->path() / "out-large-pairs").string(), "-o", there.string()}));
  const json sizes = played("stage_size", there);
  EXPECT_GT(sizes.at("screen").get<double>(), 0.9 * sizes.at("stage").get<double>());
  EXPECT_GT(sizes.at("screen").get<double>(), 500.0);
  EXPECT_EQ(sizes.at("troubles"), json::array());
}

/// The study with other trials: all three stimuli, without reference and practice.
std::string study_of_trials(const std::string& members) {
  std::string text = study_text;
  for (const char* line : {"  stimuli: [sad, proud]\n", "  scales: emotions\n",
                           "  reference: usual\n", "  practice: [usual]\n"})
    text.erase(text.find(line), std::string(line).size());
  return text + members;
}

/// A kind of trials, the lines of its questionnaire, and the answers that it can have.
struct AskedKind {
  const char* kind;
  const char* members;
  std::set<std::string> raws;
};

void PrintTo(const AskedKind& asked, std::ostream* out) { *out << asked.kind; }

/// An exported questionnaire of this kind, and its manifest. All kinds have the same films.
fs::path exported(const AskedKind& asked) {
  const std::string kind = asked.kind;
  return shared_set_up("kind of trials " + kind, [&](const fs::path& here) {
    const fs::path films = shared_set_up("films of kinds of trials", [](const fs::path& there) {
      std::ofstream(there / "films.yaml") << study_text;
      must_run(
          mien_with({"run", (there / "films.yaml").string(), "--out", (there / "out").string()}));
    });
    fs::copy(films / "out", here / "out", fs::copy_options::recursive);
    std::ofstream(here / "kind.yaml") << study_of_trials(asked.members);
    must_run(mien_with({"study", "export", (here / "kind.yaml").string(), "--out",
                        (here / "out").string(), "-o", (here / "page").string()}));
  });
}

class KindsOfTrials : public QuestionnairePage, public testing::WithParamInterface<AskedKind> {};

const std::vector<AskedKind> asked_kinds = {
    {"same_different",
     "  trials: same_different\n  preference: {shown: in_turn}\n",
     {"same", "different"}},
    {"yes_no",
     "  trials: yes_no\n  question: Is this person sad?\n  signal: [sad]\n",
     {"yes", "no"}},
    {"two_interval",
     "  trials: two_interval\n  question: Who is sad?\n  signal: [sad]\n  retest: {repeat: 1}\n",
     {"first", "second"}},
    {"best_worst",
     "  trials: best_worst\n  scales: [sad-happy, weak-strong]\n  best_worst: {size: 3, sets: 4}\n",
     {"1", "2", "3"}}};

TEST_P(KindsOfTrials, AreAnsweredByKeysAlone) {
  const AskedKind& asked = GetParam();
  const std::string kind = asked.kind;
  const fs::path folder = exported(asked);
  const json taken = played("keys", folder / "page");
  EXPECT_EQ(taken.at("troubles"), json::array()) << kind;
  std::set<std::string> raws;
  int checks = 0;
  std::map<std::string, std::map<std::string, std::string>> chosen;  // by trial and item
  for (const auto& row : rows_in(taken.at("answers").get<std::string>())) {
    const std::string raw = row.at("value_raw");
    if (row.at("kind") == "attention") {
      EXPECT_EQ(row.at("passed"), "1") << kind << " " << raw;
      ++checks;
      continue;
    }
    raws.insert(raw);
    EXPECT_NEAR(std::stod(row.at("shown_width")) / std::stod(row.at("shown_height")), 96.0 / 72.0,
                0.01);
    EXPECT_EQ(row.at("kind"), kind);
    const std::string against = row.at("against"), value = row.at("value");
    if (kind == "yes_no") {
      EXPECT_EQ(against, "");
    }
    if (kind == "two_interval") {
      EXPECT_EQ(value, raw == "first" ? row.at("stimulus") : against);
      EXPECT_NE(row.at("stimulus") == "sad", against == "sad");
    } else if (kind == "best_worst") {
      std::istringstream shown(row.at("stimulus") + " " + against);
      std::vector<std::string> stimuli;
      for (std::string one; shown >> one;) stimuli.push_back(one);
      ASSERT_EQ(stimuli.size(), 3u) << against;
      EXPECT_EQ(value, stimuli.at(std::stoul(raw) - 1));
      chosen[row.at("trial")][row.at("item")] = value;
    } else {
      EXPECT_EQ(value, raw);
    }
  }
  EXPECT_EQ(raws, asked.raws) << kind;
  EXPECT_GE(checks, 1) << kind;
  for (auto& [trial, items] : chosen) {
    EXPECT_EQ(items.size(), 4u) << trial;
    EXPECT_NE(items["sad-happy/best"], items["sad-happy/worst"]);
    EXPECT_NE(items["weak-strong/best"], items["weak-strong/worst"]);
  }
  // The answers of the page are those that a report takes.
  const fs::path answers = scratch->write("answers.csv", taken.at("answers").get<std::string>());
  must_run(mien_with({"study", "report", answers.string(), (folder / "kind.yaml").string(), "-o",
                      (scratch->path() / (kind + "-report")).string()}));
}

TEST_P(KindsOfTrials, HaveNoFaultOfAccessibility) {
  EXPECT_EQ(played("accessibility", exported(GetParam()) / "page").at("faults"), json::array());
}

INSTANTIATE_TEST_SUITE_P(All, KindsOfTrials, testing::ValuesIn(asked_kinds),
                         [](const auto& asked) { return std::string(asked.param.kind); });

TEST_F(QuestionnairePage, BarsTheBestFromBeingTheWorst) {
  const json set = played("set", exported(asked_kinds.back()) / "page");
  EXPECT_EQ(set.at("troubles"), json::array());
  EXPECT_EQ(set.at("barred").at(0), (json{"free", "chosen", "free"}));
  EXPECT_EQ(set.at("barred").at(1), (json{"free", "barred", "free"}));
  EXPECT_EQ(set.at("chosen").at(0), (json{"free", "chosen", "barred"}));
  EXPECT_EQ(set.at("chosen").at(1), (json{"free", "barred", "chosen"}));
  EXPECT_EQ(set.at("chosen").at(2), (json{"free", "free", "free"}));
}

TEST_F(QuestionnairePage, RatesTheVideosOfAGridAndSaysWhatIsMissing) {
  std::string text = study_of_trials(
      "  trials: grid\n  scales: [sad-happy]\n  grid: {sets: [[usual, sad, proud]], reference: "
      "[usual]}\n");
  for (const char* line : {"  warm_up: 1\n", "  attention: {every: 2}\n"})
    text.erase(text.find(line), std::string(line).size());
  const fs::path manifest = scratch->write("grid.yaml", text);
  const fs::path there = scratch->path() / "grid";
  must_run(mien_with({"study", "export", manifest.string(), "--out",
                      (scratch->path() / "out-grid").string(), "-o", there.string()}));
  const json experiment = json::parse(text_of(there / "experiment.json"));
  const json trial = experiment.at("sessions").at(0).at("trials").at(0);
  EXPECT_EQ(trial.at("media").size(), 3u);
  EXPECT_EQ(experiment.at("stimuli").at(trial.at("reference").get<std::string>()), "usual");
  const json told = played("grid", there);
  EXPECT_EQ(told.at("troubles"), json::array());
  EXPECT_EQ(told.at("covered"), (json{false, false, false, false}));
  EXPECT_EQ(told.at("notes"),
            (json{"The reference is still to be played. Videos still to be played: 1, 2, 3. "
                  "Sliders still to be moved: 1, 2, 3.",
                  "Videos still to be played: 1, 2, 3. Sliders still to be moved: 1, 2, 3.",
                  "Videos still to be played: 1, 3. Sliders still to be moved: 1, 2, 3.",
                  "Videos still to be played: 1. Sliders still to be moved: 1, 2."}));
  // The reference comes first, and then the videos of the three places.
  const json& during = told.at("during");
  EXPECT_EQ(std::count(during.begin(), during.end(), true), 1) << during;
  EXPECT_TRUE(told.at("isStopped"));
  EXPECT_EQ(told.at("values"), (json{"0", "49", "100"}));
  const json taken = played("keys", there);
  EXPECT_EQ(taken.at("troubles"), json::array());
  const auto rows = rows_in(taken.at("answers").get<std::string>());
  ASSERT_EQ(rows.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string shown = trial.at("media").at(i);
    EXPECT_EQ(rows[i].at("stimulus"), experiment.at("stimuli").at(shown).get<std::string>());
    EXPECT_EQ(rows[i].at("stimulus_sha256"),
              experiment.at("media").at(shown).at("sha256").get<std::string>());
    EXPECT_EQ(rows[i].at("against"), "usual");
    EXPECT_EQ(rows[i].at("item"), "sad-happy");
    EXPECT_EQ(rows[i].at("value"), std::to_string(51 + i));
    EXPECT_EQ(rows[i].at("kind"), "grid");
    EXPECT_NEAR(std::stod(rows[i].at("shown_width")) / std::stod(rows[i].at("shown_height")),
                96.0 / 72.0, 0.01);
  }
  std::ofstream(there / "answers.csv") << taken.at("answers").get<std::string>();
  must_run(mien_with({"study", "report", (there / "answers.csv").string(), manifest.string(), "-o",
                      (scratch->path() / "grid-report").string()}));
  EXPECT_EQ(rows_in(text_of(scratch->path() / "grid-report/results/grid.csv")).size(), 3u);
  EXPECT_EQ(played("accessibility", there).at("faults"), json::array());
}

TEST_F(QuestionnairePage, GoesWithTheServerOfALaboratory) {
  const fs::path told = scratch->path() / "serving.txt";
  const Running server({"sh", "-c", "told=$1; shift; exec \"$@\" >\"$told\"", "sh", told.string(),
                        MIEN_PROGRAM, "study", "serve", (scratch->path() / "gaits.yaml").string(),
                        "--out", (scratch->path() / "out").string(), "--port", "0", "--json",
                        "--store", (scratch->path() / "kept.db").string()});
  json places;
  for (int tries = 0; tries < 3000 && !places.is_object(); ++tries) {
    pause_for(0.1);
    places = json::parse(text_of(told), nullptr, false);
  }
  ASSERT_TRUE(places.is_object());
  const std::string lab = places.at("lab");
  const auto links = rows_in(text_of(places.at("links").get<std::string>()));
  const fs::path asked = scratch->write("places.json", json{{"first", links.at(0).at("link")},
                                                            {"second", links.at(1).at("link")},
                                                            {"join", places.at("join")},
                                                            {"status", lab + "status.json"}}
                                                           .dump());
  const json run = played("laboratory", asked);
  const auto says = [&](const char* who, const char* what) {
    return run.at(who).get<std::string>().find(what) != std::string::npos;
  };
  EXPECT_EQ(run.at("reloads"), 1);
  for (const char* who : {"mouse", "keys", "joined"})
    EXPECT_TRUE(says(who, "have been saved")) << who;
  for (const char* who : {"early", "late"}) EXPECT_TRUE(says(who, "open elsewhere")) << who;
  EXPECT_TRUE(says("phone", "screen larger than"));
  EXPECT_TRUE(says("refusing", "no answers have been recorded"));
  // Neither the phone nor who refused has taken a plan.
  EXPECT_EQ(run.at("participants"), (json{3, 3, 4}));
  EXPECT_EQ(run.at("states"), (json{"done", "done", "waiting", "done"}));
  const json& monitored = run.at("monitored");
  EXPECT_EQ(monitored.at("rows"), (json{"p001", "p002", "p004"}));
  EXPECT_EQ(monitored.at("unopened"), "List 1 personal link that nobody has opened");
  EXPECT_EQ(monitored.at("all"), (json{"p003", "p001", "p002", "p004"}));
  EXPECT_EQ(monitored.at("states"), (json{"personal link not opened", "done", "done", "done"}));
  EXPECT_EQ(monitored.at("hide"), "Hide 1 personal link that nobody has opened");
  EXPECT_EQ(run.at("path").get<std::string>().substr(0, 3), "/s/");
  EXPECT_EQ(run.at("troubles"), json::array());
}

TEST_F(QuestionnairePage, PlaysByTheSpaceKeyAndChoosesByDigitsWhereverTheFocusIs) {
  const json keys = played("single_keys");
  EXPECT_TRUE(keys.at("shown"));  // the first Enter shows what the second one presses
  EXPECT_EQ(keys.at("is_there"), 2);
  EXPECT_EQ(keys.at("replayed"), 1);
  EXPECT_EQ(keys.at("chosen"), 0);
  EXPECT_TRUE(keys.at("back"));  // at the question, once it has been replayed
  EXPECT_EQ(keys.at("by_digit"), "2");
  const json& entered = keys.at("entered");
  EXPECT_NE(entered.at("note").get<std::string>().find("missing"), std::string::npos);
  EXPECT_TRUE(entered.at("is_at_group"));
  EXPECT_EQ(entered.at("chosen"), 0) << "Enter chooses nothing";
  EXPECT_EQ(entered.at("by_space"), 1) << "at the answer that the participant went to";
  EXPECT_EQ(entered.at("replayed"), 1) << "at an answer that is chosen, Space plays again";
  EXPECT_EQ(entered.at("by_arrow"), (json{"5", "1"}));
  EXPECT_NE(keys.at("desktop_text").get<std::string>().find("keyboard"), std::string::npos);
  EXPECT_EQ(keys.at("touched_text").get<std::string>().find("keyboard"), std::string::npos);
  EXPECT_EQ(keys.at("troubles"), json::array());
}

TEST_F(QuestionnairePage, SavesFilesByItselfOnce) {
  const json saved = played("thanks_again");
  EXPECT_EQ(saved.at("first"), 3);
  EXPECT_EQ(saved.at("reloaded"), 3);
  EXPECT_EQ(saved.at("asked"), 4);
  EXPECT_EQ(saved.at("troubles"), json::array());
}

TEST_F(QuestionnairePage, FindsRoomForWordsAndForJapaneseOnAPhone) {
  const json seen = played("crowded");
  EXPECT_LE(seen.at("foot"), 768);
  EXPECT_GE(seen.at("letters"), 11.0);
  ASSERT_EQ(seen.at("captions").size(), 2u);
  EXPECT_EQ(seen.at("captions")[0], seen.at("captions")[1]);
  EXPECT_EQ(seen.at("numbers"), 1);
  EXPECT_LE(seen.at("wide"), 390);
  // Words are suggested, and others may be written.
  const json& suggested = seen.at("suggested");
  EXPECT_EQ(suggested.at("value"), "weary");
  EXPECT_EQ(suggested.at("words"), json({"happy", "heavy", "sad"}));
  EXPECT_NE(suggested.at("label"), "");
  EXPECT_EQ(suggested.at("faults"), json::array());
}

TEST_F(QuestionnairePage, BreaksNoWordBelowThePointsOfAScale) {
  const json broken = played("points");
  EXPECT_EQ(broken.size(), 18u);
  for (const auto& [where, words] : broken.items()) EXPECT_EQ(words, json::array()) << where;
}

TEST_F(QuestionnairePage, IsInTheLanguageThatTheBrowserPrefersAndMirroredInArabic) {
  const json told = played("languages");
  EXPECT_EQ(
      told.at("chosen"),
      (json{{"de-AT",
             {"de", "ltr", "Wie geht diese Person?", "Ich bin mit der Teilnahme einverstanden"}},
            {"fr-FR", {"en", "ltr", "How does this person walk?", "I agree to take part"}},
            {"ar-EG", {"ar", "rtl", "كيف", "أوافق على المشاركة"}},
            {"en-GB", {"en", "ltr", "How does this person walk?", "I agree to take part"}}}));
  // The first point is on the right, and the left arrow key moves to the left.
  EXPECT_EQ(told.at("checked"), 2);
  EXPECT_EQ(told.at("back"), 1);
  const auto places = told.at("places").get<std::vector<double>>();
  EXPECT_TRUE(std::is_sorted(places.rbegin(), places.rend())) << told.at("places");
  EXPECT_GT(places.front(), places.back());
  EXPECT_GT(told.at("poles")[0][1], told.at("poles")[1][1]) << told.at("poles");
  EXPECT_EQ(told.at("moved"), 51);
  EXPECT_LT(told.at("clicked"), 20);
  EXPECT_EQ(told.at("faults"), json::array());
  EXPECT_EQ(told.at("troubles"), json::array());
  const auto participant = rows_in(told.at("participant"));
  ASSERT_EQ(participant.size(), 1U);
  EXPECT_EQ(participant[0].at("language"), "ar");
  EXPECT_EQ(participant[0].at("age"), "27");
  EXPECT_EQ(participant[0].at("hand"), "left");
}

TEST_F(QuestionnairePage, HasNoFaultOfAccessibility) {
  const json checked = played("accessibility");
  EXPECT_EQ(checked.at("faults"), json::array());
  EXPECT_GT(checked.at("checked"), 10);
}

TEST_F(QuestionnairePage, HasNoFaultOfAccessibilityAsNarrowAsAPhone) {
  const json checked = played("narrow_accessibility");
  EXPECT_EQ(checked.at("faults"), json::array());
  EXPECT_GT(checked.at("checked"), 10);
}

TEST_F(QuestionnairePage, SendsPhonesAwayAndKeepsNothingOfWhoRefuses) {
  const json phone = played("refused_phone");
  EXPECT_EQ(phone.at("trials"), 0);
  EXPECT_NE(phone.at("text").get<std::string>().find("screen larger than"), std::string::npos);
  const json refusal = played("refusal");
  EXPECT_EQ(refusal.at("troubles"), json::array());
  for (const char* nothing : {"looked", "listed_looked", "refused", "listed_refused"})
    EXPECT_EQ(refusal.at(nothing), json::array()) << nothing;
  EXPECT_NE(refusal.at("text").get<std::string>().find("no answers have been recorded"),
            std::string::npos);
  EXPECT_EQ(refusal.at("agreed"), (json{"session", "taken"}));
  ASSERT_EQ(refusal.at("listed_agreed").size(), 1u);
  EXPECT_NE(refusal.at("listed_agreed")[0].get<std::string>().find("agreed, nothing answered"),
            std::string::npos);
}

TEST_F(QuestionnairePage, KeepsNothingOnJatosOfWhoRefuses) {
  const json run = played("jatos_refusal");
  EXPECT_EQ(run.at("looked"), json::object()) << "no plan is taken before consent";
  EXPECT_EQ(run.at("refused"), json::object());
  EXPECT_EQ(run.at("troubles"), json::array());
}

/// That C++ makes the same rows of the same records is tested beside the file.
TEST_F(QuestionnairePage, MakesTheRowsThatAreExpected) {
  const fs::path there = fs::path(MIEN_SOURCE_DIR) / "tests/pipeline/study/questionnaire";
  const Ended ended = run_program(
      {"node", (page_tests() / "rows.mjs").string(), (there / "page_session.json").string()});
  EXPECT_EQ(ended.output, text_of(there / "page_answers.csv")) << ended.errors;
}

TEST_F(QuestionnairePage, DecidesAboutEndsOfSessionsWithoutAServer) {
  const Ended ended =
      run_program({"node", "--test", (page_tests() / "recruitment.mjs").string()}, 300.0);
  EXPECT_EQ(ended.code, 0) << ended.output << ended.errors;
}

TEST_F(QuestionnairePage, IsWrittenIntoNoFolderOfOthers) {
  const Scratch other;
  other.write("thesis.tex", "mine");
  const Ended refused =
      run_mien({"study", "export", (scratch->path() / "gaits.yaml").string(), "--out",
                (scratch->path() / "out").string(), "-o", other.path().string()});
  EXPECT_NE(refused.code, 0);
  EXPECT_NE(refused.errors.find("was not written by mien study export"), std::string::npos)
      << refused.errors;
}

}  // namespace
}  // namespace mien::test
