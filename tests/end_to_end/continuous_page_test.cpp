// Films that are rated while they play, in Chromium (page/tests/questionnaire/continuous.mjs).

#include <cmath>
#include <fstream>
#include <sstream>

#include "end_to_end/questionnaire_page.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

using TraceRow = std::map<std::string, std::string>;

std::vector<double> trace_in(const TraceRow& row) {
  std::vector<double> trace;
  std::istringstream samples(row.at("value_raw"));
  for (double sample = 0.0; samples >> sample;) trace.push_back(sample);
  return trace;
}

double sample_at(const std::vector<double>& trace, double seconds) {
  return trace.at(static_cast<std::size_t>(std::lround(10.0 * seconds)));
}

class ContinuousPage : public QuestionnairePage {
 protected:
  static void SetUpTestSuite() {
    QuestionnairePage::SetUpTestSuite();
    if (!scratch) return;
    manifest = scratch->write("courses.yaml", continuous_study_text);
    there = shared_set_up("continuous page",
                          [](const fs::path& folder) {
                            must_run(mien_with({"study", "export", manifest.string(), "--out",
                                                (folder / "out").string(), "-o",
                                                (folder / "page").string()}));
                          }) /
            "page";
  }

  static json outcome_of(const std::string& scenario) {
    return output_of({(page_tests() / "continuous.mjs").string(), scenario, there.string()});
  }

  /// The row of the first trial; checks that the trace is of the whole film and its mean the value.
  static TraceRow first_row(const json& taken) {
    EXPECT_EQ(taken.at("troubles"), json::array());
    const auto rows = rows_in(taken.at("answers").get<std::string>());
    EXPECT_EQ(rows.size(), 2u);
    const json experiment = json::parse(text_of(there / "experiment.json"));
    const double seconds = experiment.at("media").begin().value().at("seconds");
    for (const TraceRow& row : rows) {
      const std::vector<double> trace = trace_in(row);
      EXPECT_EQ(row.at("kind"), "continuous");
      // The film, not the stage that is as wide as the window.
      EXPECT_NEAR(std::stod(row.at("shown_height")), 0.54 * 768.0, 1.0);
      EXPECT_NEAR(std::stod(row.at("shown_width")), 0.54 * 768.0 * 96.0 / 72.0, 1.0);
      EXPECT_EQ(trace.size(), static_cast<std::size_t>(std::ceil(10.0 * seconds - 1e-6)) + 1);
      double sum = 0.0;
      for (std::size_t k = 5; k < trace.size(); ++k) sum += trace[k];
      const double mean = sum / static_cast<double>(trace.size() - 5);
      EXPECT_NEAR(std::stod(row.at("value")), row.at("pole_left") == "high" ? 100.0 - mean : mean,
                  1e-5);
    }
    EXPECT_NE(rows.at(0).at("item"), rows.at(1).at("item"));
    return rows.at(0);
  }

  inline static fs::path manifest, there;
};

TEST_F(ContinuousPage, InterpolatesBetweenTheRefreshesOfTheScreen) {
  const Ended ended = run_program({"node", "--test", (page_tests() / "trace.mjs").string()}, 300.0);
  EXPECT_EQ(ended.code, 0) << ended.output << ended.errors;
}

TEST_F(ContinuousPage, TakesTheTraceOfHeldKeys) {
  const json keys = outcome_of("keys");
  const TraceRow row = first_row(keys);
  EXPECT_EQ(keys.at("focus"), "marker");
  EXPECT_LT(keys.at("tried").get<double>(), 49.0) << "the marker can be tried before the film";
  for (const char* when : {"entered", "entered_nowhere", "note"})
    EXPECT_NE(keys.at(when).get<std::string>().find("while it plays"), std::string::npos) << when;
  EXPECT_EQ(keys.at("begins_at"), 50);
  // While the film plays, nothing asks to play it, and nothing can be gone on with.
  EXPECT_EQ(keys.at("playing"), (json{{"is_disabled", true}, {"note", ""}}));
  EXPECT_TRUE(keys.at("pressed").at("is_disabled"));
  EXPECT_NE(keys.at("pressed").at("note").get<std::string>().find("The video is playing"),
            std::string::npos);
  EXPECT_EQ(keys.at("over"), (json{{"is_disabled", false}, {"note", ""}}));
  EXPECT_FALSE(keys.at("is_movable"));
  EXPECT_FALSE(keys.at("can_replay"));
  const double pressed = keys.at("keydown"), released = keys.at("keyup");
  const std::vector<double> trace = trace_in(row);
  for (double time = 0.0; time < pressed - 0.1; time += 0.1)
    EXPECT_EQ(sample_at(trace, time), 50.0) << time;
  // 40 hundredths a second, steadily.
  const double rise = 40.0 * (released - pressed);
  EXPECT_NEAR(trace.back(), 50.0 + rise, 4.0);
  EXPECT_NEAR(sample_at(trace, 0.5 * (pressed + released)), 50.0 + 0.5 * rise, 5.0);
  for (double time = released + 0.2; 10.0 * time < static_cast<double>(trace.size() - 1);
       time += 0.1)
    EXPECT_EQ(sample_at(trace, time), trace.back()) << time;
  EXPECT_NEAR(std::stod(row.at("rt_ms")), 1000.0 * pressed, 400.0);
  EXPECT_EQ(row.at("attempt"), "1");
}

TEST_F(ContinuousPage, TakesTheTraceOfAMouseByTheTimeOfTheFilm) {
  const json mouse = outcome_of("mouse");
  const TraceRow row = first_row(mouse);
  const std::vector<double> trace = trace_in(row);
  const double pressed = mouse.at("pointerdown");
  // A stop of 1.5 s after 0.6 s of the film leaves no samples.
  EXPECT_GT(std::stod(row.at("ended_ms")) - std::stod(row.at("play_start_ms")),
            100.0 * static_cast<double>(trace.size() - 1) + 1000.0);
  for (double time = 0.0; time < pressed - 0.1; time += 0.1)
    EXPECT_EQ(sample_at(trace, time), 50.0) << time;
  EXPECT_NEAR(trace.back(), 80.0, 1.5);
  EXPECT_NEAR(sample_at(trace, mouse.at("pointerup").get<double>() + 0.2), 80.0, 1.5);
}

TEST_F(ContinuousPage, BeginsAnewAfterAReloadAndTellsTheAttempts) {
  const TraceRow row = first_row(outcome_of("reloaded"));
  EXPECT_EQ(row.at("attempt"), "3");
  EXPECT_EQ(row.at("plays_before"), "2");
  EXPECT_GT(std::stod(row.at("watched_before_ms")), 500.0);
  EXPECT_EQ(sample_at(trace_in(row), 0.2), 50.0) << "nothing is left of the first attempt";
}

TEST_F(ContinuousPage, IsAccessibleAndMirrored) {
  const json looked = outcome_of("looked");
  for (const char* when : {"before", "during", "after"})
    EXPECT_EQ(looked.at(when), json::array()) << when;
  // Where one writes to the left, the first end is on the right.
  EXPECT_NEAR(looked.at("right_end").get<double>(), 10.0, 2.0);
  EXPECT_GT(looked.at("moved_left").get<double>(), looked.at("right_end").get<double>() + 5.0);
}

TEST_F(ContinuousPage, SaysThatTheQuestionChangesAndGreetsOnce) {
  std::string text = continuous_study_text;
  text.replace(text.find("  - {id: sad,"), 0, "  - {id: usual, weights: {normal: 1}}\n");
  text += "  practice: [usual]\n  ending: |\n    Thank you.\n\n    Thank you for your patience.\n";
  const fs::path with_practice = scratch->write("practised.yaml", text);
  const fs::path page = scratch->path() / "practised";
  must_run(mien_with({"study", "export", with_practice.string(), "--out",
                      (scratch->path() / "out-practised").string(), "-o", page.string()}));
  const json told =
      output_of({(page_tests() / "continuous.mjs").string(), "two_scales", page.string()});
  EXPECT_EQ(told.at("troubles"), json::array());
  // Of each page after the instructions and questions, its first line, or the trial.
  std::vector<std::string> order, poles, changes;
  for (const json& lines : told.at("said")) {
    order.push_back(lines.at(0));
    if (order.back() == "The question changes") changes = lines;
    if (order.back() == "trial 3") poles = {lines.at(1), lines.at(2)};
  }
  const auto first = std::ranges::find(order, "Practice");
  ASSERT_NE(first, order.end());
  order.erase(order.begin(), first);
  const std::string title = order.at(2);
  // The page was loaded again at the fourth trial, which begins with the instructions.
  EXPECT_EQ(order,
            (std::vector<std::string>{"Practice", "trial 1", title, "trial 2",
                                      "The question changes", "trial 3", title, "Instructions",
                                      "trial 4", "That was the last question", "Thank you"}));
  ASSERT_EQ(poles.size(), 2u);
  ASSERT_EQ(changes.size(), 4u);
  EXPECT_NE(changes[1].find("between “" + poles[0] + "” and “" + poles[1] + "”"), std::string::npos)
      << changes[1];
  EXPECT_NE(changes[2].find("Some practice comes first"), std::string::npos) << changes[2];
  const auto says = [&](const std::string& what) {
    const std::string all = told.at("said").dump();
    std::size_t times = 0;
    for (std::size_t at = all.find(what); at != std::string::npos; at = all.find(what, at + 1))
      ++times;
    return times;
  };
  EXPECT_EQ(says("We begin with some practice"), 1u);
  EXPECT_EQ(says("The main part begins now"), 1u);
  EXPECT_EQ(says("The main part goes on now"), 1u);
  // Of the ending, only what repeats the heading is left out.
  EXPECT_EQ(says("Thank you for your patience."), 1u);
  EXPECT_EQ(says("Thank you.\""), 0u);
}

TEST_F(ContinuousPage, GivesAnswersThatAReportTakes) {
  const json mouse = outcome_of("mouse");
  const fs::path answers = scratch->write("answers.csv", mouse.at("answers").get<std::string>());
  const fs::path report = scratch->path() / "courses-report";
  must_run(
      mien_with({"study", "report", answers.string(), manifest.string(), "-o", report.string()}));
  const auto means = rows_in(text_of(report / "results/mean_traces.csv"));
  const auto rows = rows_in(mouse.at("answers").get<std::string>());
  EXPECT_EQ(means.size(), 2 * trace_in(rows.at(0)).size());
  // On JATOS, results are the same table.
  const json run = played("jatos", there);
  const auto kept = rows_in(run.at("answers").get<std::string>());
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(trace_in(kept[0]).size(), trace_in(rows.at(0)).size());
}

}  // namespace
}  // namespace mien::test
