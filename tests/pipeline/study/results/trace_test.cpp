// Continuous ratings by people whose traces are known.

#include "pipeline/manifest/ratings/answers/trace.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/statistics/reference_values.h"
#include "pipeline/plot_texts.h"
#include "pipeline/study/results/figures/result_figures.h"
#include "pipeline/study/results/report/dataset.h"
#include "pipeline/study/results/report/page_tables.h"
#include "pipeline/study/results/report/results_report.h"
#include "pipeline/study/results/result_tables.h"
#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

/// Films that are rated on one scale while they play.
Manifest continuous_study(int participants, std::vector<std::string> films = {"sad"},
                          std::uint64_t seed = 1) {
  Manifest manifest = two_emotion_study(participants, seed);
  std::erase_if(manifest.stimuli, [&](const Stimulus& one) {
    return std::ranges::find(films, one.id) == films.end();
  });
  Questionnaire& asked = *manifest.questionnaire;
  asked.trials = &continuous_form;
  asked.answer = {};
  asked.scales.ids = {"sad-happy"};
  return manifest;
}

/// The rows of a study of one film in which participant i gives `traces[i]`.
std::vector<AnswerRow> rows_of_traces(const Manifest& manifest,
                                      const std::vector<std::vector<double>>& traces) {
  std::vector<AnswerRow> rows = answers_to(manifest);
  EXPECT_EQ(rows.size(), traces.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<double> shown = traces[i];
    if (rows[i].pole_left == "high")
      for (double& sample : shown) sample = 100.0 - sample;
    rows[i].value_raw = to_text(shown);
    const auto mean = mean_of_trace(traces[i], manifest.questionnaire->continuous.lead);
    rows[i].value = mean ? fmt::format("{:.6f}", *mean) : "";
  }
  return rows;
}

std::vector<std::vector<double>> reference_traces() {
  const std::vector<double> all = test::sample("traces");  // by time, then by participant
  constexpr std::size_t people = 6;
  std::vector<std::vector<double>> traces(people);
  for (std::size_t i = 0; i < all.size(); ++i) traces[i % people].push_back(all[i]);
  return traces;
}

TEST(TraceResults, AreTheMeansIntervalsAndAgreementOfR) {
  Manifest manifest = continuous_study(6);
  manifest.questionnaire->analysis.lag = 0.5;
  const AnswerSet answers = collect_answers(manifest, rows_of_traces(manifest, reference_traces()));
  const TraceResults found = trace_results(answers);
  ASSERT_EQ(found.means.size(), 1u);
  const std::vector<TracePoint>& points = found.means[0].points;
  ASSERT_EQ(points.size(), 36u);  // 41 samples, of which 5 are before the film, less the lag
  for (const std::size_t k : {0u, 7u, 35u}) {
    test::Expected expected("traces/" + std::to_string(k));
    EXPECT_DOUBLE_EQ(points[k].time_s, 0.1 * static_cast<double>(k));
    EXPECT_EQ(points[k].people, 6);
    expected.is("mean", points[k].mean);
    expected.is("sd", points[k].deviation);
    expected.is("low", points[k].ends.low);
    expected.is("high", points[k].ends.high);
  }
  ASSERT_EQ(found.agreement.size(), 1u);
  const TraceAgreement& agreement = found.agreement[0];
  EXPECT_EQ(agreement.people, 6);
  EXPECT_EQ(agreement.samples, 26);
  EXPECT_EQ(agreement.unmoved, 1);
  test::Expected expected("traces/agreement");
  expected.is("two", agreement.intraclass.two);
  expected.is("two_k", agreement.intraclass.two_k);
  expected.is("alpha", agreement.alpha);
  // The means of trials are ratings.
  const std::vector<RatingSummary> summaries = summaries_of(answers);
  ASSERT_EQ(summaries.size(), 1u);
  test::Expected means("traces/means");
  means.is("mean", summaries[0].mean);
  means.is("low", summaries[0].low);
  means.is("high", summaries[0].high);
}

TEST(TraceResults, AreMovedByTheLagOfTheAnalysisOnly) {
  Manifest manifest = continuous_study(2);
  std::vector<double> ramp(41);
  for (std::size_t k = 0; k < ramp.size(); ++k) ramp[k] = static_cast<double>(k);
  const std::vector<AnswerRow> rows = rows_of_traces(manifest, {ramp, ramp});
  const TraceResults plain = trace_results(collect_answers(manifest, rows));
  EXPECT_EQ(plain.means[0].points.size(), 41u);
  EXPECT_DOUBLE_EQ(plain.means[0].points[20].mean, 20.0);
  EXPECT_DOUBLE_EQ(collect_answers(manifest, rows).ratings[0].value, 25.0);  // of 10 … 40
  manifest.questionnaire->analysis.lag = 1.5;
  const AnswerSet moved = collect_answers(manifest, rows);
  EXPECT_EQ(moved.design, collect_answers(continuous_study(2), rows).design);
  const TraceResults found = trace_results(moved);
  EXPECT_EQ(found.means[0].points.size(), 26u);
  EXPECT_DOUBLE_EQ(found.means[0].points[20].time_s, 2.0);
  EXPECT_DOUBLE_EQ(found.means[0].points[20].mean, 35.0);
  EXPECT_DOUBLE_EQ(moved.ratings[0].value, 32.5);  // of 25 … 40
  manifest.questionnaire->analysis.lag = 3.5;
  EXPECT_THROW(collect_answers(manifest, rows), Faults) << "nothing is left after lag and lead";
}

TEST(TraceResults, RefuseTracesThatAreNoneOrContradictTheirMeans) {
  const Manifest manifest = continuous_study(2);
  const std::vector<std::vector<double>> traces(2, std::vector<double>(41, 40.0));
  const auto fault_of = [&](auto&& change) {
    std::vector<AnswerRow> rows = rows_of_traces(manifest, traces);
    change(rows[0]);
    try {
      collect_answers(manifest, rows);
    } catch (const Faults& faults) {
      return std::string(faults.what());
    }
    return std::string();
  };
  EXPECT_EQ(fault_of([](AnswerRow&) {}), "");
  EXPECT_NE(fault_of([](AnswerRow& row) {
              row.value = "41";
            }).find("the mean of the trace after 1 s is 40, not 41"),
            std::string::npos);
  EXPECT_NE(fault_of([](AnswerRow& row) { row.value_raw = "40 140"; }).find("is no trace"),
            std::string::npos);
  EXPECT_NE(fault_of([](AnswerRow& row) {
              row.pole_left = row.pole_left == "low" ? "high" : "low";
            }).find("is 60, not 40"),
            std::string::npos);
}

/// The impression of simulated participants, without their reaction lag.
double true_trace(double seconds, double opinion) {
  return 50.0 + (opinion - 50.0) * (1.0 - std::exp(-seconds / 1.5));
}

constexpr double true_opinion = 70.0;

SimulatedParticipants watchers(double seconds) {
  SimulatedParticipants people = {
      .spread = RatingSpread{.participant = 4.0, .stimulus = 0.0, .residual = 6.0},
      .attention_pass_rate = 1.0};
  people.film_seconds = {{"sad", seconds}, {"happy", seconds}};
  return people;
}

TEST(TraceResults, FindTheTraceOfSimulatedParticipantsOnceTheirLagIsTakenOff) {
  Manifest manifest = continuous_study(60);
  const StatedTruth stated = {{{"sad", "sad-happy"}, true_opinion}};
  const std::vector<AnswerRow> rows = answers_to(manifest, stated, watchers(8.0));
  EXPECT_TRUE(rows.front().simulated);
  EXPECT_EQ(std::ranges::count(rows.front().value_raw, ' '), 80);
  manifest.questionnaire->analysis.lag = 2.0;
  const TraceResults found = trace_results(collect_answers(manifest, rows));
  ASSERT_EQ(found.means[0].points.size(), 61u);
  // The standard error of a mean is at most √(4² + 6² + 3²) / √60 = 1.
  for (const TracePoint& point : found.means[0].points)
    EXPECT_NEAR(point.mean, true_trace(point.time_s, true_opinion), 3.5) << point.time_s;
  EXPECT_NEAR(found.means[0].points[0].mean, 50.0, 1e-9);
  // Without the lag, the trace comes 2 s late.
  manifest.questionnaire->analysis.lag = 0.0;
  const TraceResults late = trace_results(collect_answers(manifest, rows));
  EXPECT_NEAR(late.means[0].points[20].mean, 50.0, 1e-9);
  EXPECT_NEAR(late.means[0].points[50].mean, true_trace(3.0, true_opinion), 3.5);
}

/// The truth rises from 30 to 75 at 6 s; what is seen at 6 s is rated after the lag, and 63 % of
/// the change 1.5 s later.
TEST(TraceResults, FollowATruthThatChangesAfterTheLag) {
  Manifest manifest = continuous_study(80);
  const StatedTruth stated = {{{"sad", "sad-happy"}, 30.0}};
  const TruthCourses courses = {{{"sad", "sad-happy"}, {{6.0, 75.0}}}};
  SimulatedParticipants people = watchers(14.0);
  people.reaction_lag_s = 1.5;
  const std::vector<AnswerRow> rows =
      simulated_sessions(manifest, plan_sessions(manifest), stated, people, courses);
  manifest.questionnaire->analysis.lag = 1.5;
  const ReportChoices choices{.moods = {{"sad", {{0.0, "sad"}, {6.0, "happy"}}}}};
  const AnswerSet answers = collect_answers(manifest, rows, choices);
  const TraceResults found = trace_results(answers);
  const std::vector<TracePoint>& points = found.means[0].points;
  const auto level_at = [&](double at) { return points[static_cast<std::size_t>(10.0 * at)].mean; };
  EXPECT_NEAR(level_at(5.9), 30.0, 3.0);
  EXPECT_NEAR(level_at(12.0), 75.0, 3.0);
  // The mean trace crosses half of the change ln 2 × 1.5 s after it.
  const double half = 0.5 * (level_at(5.9) + level_at(12.0));
  const auto crossing = std::ranges::find_if(
      points, [&](const TracePoint& one) { return one.time_s > 6.0 && one.mean > half; });
  ASSERT_NE(crossing, points.end());
  EXPECT_NEAR(crossing->time_s - 6.0, 1.5 * std::log(2.0), 0.35);
  // The levels of both moods, and the change, which holds the way there.
  ASSERT_EQ(found.segments.size(), 2u);
  EXPECT_EQ(found.segments[0].mood, "sad");
  EXPECT_EQ(found.segments[0].from_s, 1.0) << "after the lead";
  EXPECT_EQ(found.segments[0].to_s, 6.0);
  EXPECT_EQ(found.segments[1].from_s, 6.0);
  EXPECT_NEAR(found.segments[1].to_s, 12.5, 1e-9) << "the last sample, less the lag";
  EXPECT_TRUE(std::isnan(found.segments[0].change));
  const double settling = 1.5 * (1.0 - std::exp(-6.5 / 1.5)) / 6.5;  // share of the change
  EXPECT_NEAR(found.segments[1].mean, 75.0 - 45.0 * settling, 2.5);
  EXPECT_NEAR(found.segments[1].change, found.segments[1].mean - found.segments[0].mean, 1e-9);
  EXPECT_LT(found.segments[1].change_ends.low, found.segments[1].change);
  EXPECT_GT(found.segments[1].change_ends.high, found.segments[1].change);
  EXPECT_LT(found.segments[1].ends.high - found.segments[1].ends.low, 5.0);
}

TEST(TraceResults, DoNotGoOnAfterTheFilm) {
  Manifest manifest = continuous_study(2);
  manifest.questionnaire->analysis.lag = 1.5;
  const std::vector<AnswerRow> rows = answers_to(manifest, {}, watchers(12.04));
  const ReportChoices choices{.moods = {{"sad", {{0.0, "sad"}, {6.0, "happy"}}}},
                              .film_seconds = {{"sad", 12.04}}};
  const Results results = results_of(collect_answers(manifest, rows, choices), rows, {});
  EXPECT_NEAR(results.traces.means.front().points.back().time_s, 10.54, 1e-9);
  EXPECT_NEAR(results.traces.segments.back().to_s, 10.54, 1e-9);
  const std::string html = trace_section_html(results, "");
  EXPECT_NE(html.find("6.0–10.5"), std::string::npos) << html;
}

TEST(TraceResults, AreReportedWithoutSectionsOnRatingsAfterFilms) {
  const Manifest manifest = continuous_study(4, {"sad", "happy"});
  const std::vector<AnswerRow> rows = answers_to(manifest, {}, watchers(8.0));
  const Results results = results_of(collect_answers(manifest, rows), rows, {});
  const std::string page = results_page(results, {}, {}, {});
  EXPECT_EQ(page.find("Highest-rated"), std::string::npos);
  EXPECT_EQ(page.find("slider"), std::string::npos);
  EXPECT_NE(page.find("Those of a trial are the mean of its trace after the lead."),
            std::string::npos);
}

/// Means over parts of traces that are known exactly.
TEST(TraceResults, HaveTheExactLevelsOfParts) {
  const Manifest manifest = continuous_study(2);
  std::vector<double> low(41, 20.0), high(41, 30.0);
  for (std::size_t k = 20; k < 41; ++k) {
    low[k] = 60.0;
    high[k] = 80.0;
  }
  const ReportChoices choices{.moods = {{"sad", {{0.0, "sad"}, {2.0, "happy"}}}}};
  const std::vector<AnswerRow> rows = rows_of_traces(manifest, {low, high});
  const Results results = results_of(collect_answers(manifest, rows, choices), rows, {});
  ASSERT_EQ(results.traces.segments.size(), 2u);
  const TraceSegment &first = results.traces.segments[0], &second = results.traces.segments[1];
  EXPECT_DOUBLE_EQ(first.mean, 25.0);
  EXPECT_DOUBLE_EQ(second.mean, 70.0);
  EXPECT_DOUBLE_EQ(second.change, 45.0);
  // Two differences, 40 and 50: Student's interval with 1 degree of freedom.
  EXPECT_NEAR(second.change_ends.high, 45.0 + 12.7062 * 5.0, 1e-3);
  EXPECT_NEAR(second.deviation, std::sqrt(200.0), 1e-9);
  const std::string html = trace_section_html(results, "");
  EXPECT_NE(html.find("Mean level in each mood"), std::string::npos);
  EXPECT_NE(html.find("2.0–4.0"), std::string::npos);
  bool has_table = false;
  for (const WrittenTable& table : result_tables(results))
    has_table = has_table || (table.form.path == "results/trace_segments.csv" &&
                              table.csv.find("sad,sad-happy,happy,2,4,2,70,") != std::string::npos);
  EXPECT_TRUE(has_table);
  for (const ResultFigure& figure : result_figures(results)) {
    if (figure.section != "traces") continue;
    for (const char* words : {"sad", "happy", "from 2.0 s"})
      EXPECT_TRUE(mien::test::says(figure.plot, words)) << words;
    EXPECT_NE(figure.caption.find("Dashed lines"), std::string::npos);
  }
}

/// How often pointwise intervals have the true value, at times that are far from each other.
TEST(TraceResults, HaveIntervalsThatCoverTheTruth) {
  const StatedTruth stated = {{{"sad", "sad-happy"}, true_opinion}};
  constexpr int studies = 400;
  int covered[3] = {};
  for (int study = 0; study < studies; ++study) {
    Manifest manifest = continuous_study(8, {"sad"}, 5000 + static_cast<std::uint64_t>(study));
    manifest.questionnaire->analysis.lag = 2.0;
    const TraceResults found =
        trace_results(collect_answers(manifest, answers_to(manifest, stated, watchers(6.0))));
    for (int at = 0; at < 3; ++at) {
      const TracePoint& point = found.means[0].points[static_cast<std::size_t>(10 + 15 * at)];
      const double expected = true_trace(point.time_s, true_opinion);
      covered[at] += point.ends.low <= expected && point.ends.high >= expected;
    }
  }
  for (int at = 0; at < 3; ++at) {
    RecordProperty(fmt::format("covered_{}", at), covered[at]);
    // 99.9 % limits of a binomial count with n = 400 and p = 0.95.
    EXPECT_GE(covered[at], 365);
    EXPECT_LE(covered[at], 394);
  }
}

TEST(TraceResults, AreTablesAFigureASectionAndAFileOfTheDataset) {
  const Manifest manifest = continuous_study(12, {"sad", "happy"});
  const StatedTruth stated = {{{"sad", "sad-happy"}, 30.0}, {{"happy", "sad-happy"}, 75.0}};
  const std::vector<AnswerRow> rows = answers_to(manifest, stated, watchers(5.0));
  const Results results = results_of(collect_answers(manifest, rows), rows, {});
  std::size_t points = 0;
  for (const WrittenTable& table : result_tables(results))
    if (table.form.path == "results/mean_traces.csv")
      points = static_cast<std::size_t>(std::ranges::count(table.csv, '\n')) - 1;
  EXPECT_EQ(points, 2u * 51u);
  const std::vector<ResultFigure> figures = result_figures(results);
  EXPECT_EQ(std::ranges::count(figures, "traces", &ResultFigure::section), 1);
  const std::string html = trace_section_html(results, "");
  EXPECT_NE(html.find("which is not taken off here"), std::string::npos);
  EXPECT_NE(html.find("leave out the first 1 s"), std::string::npos);
  const DatasetPaths paths = dataset_paths("two-emotions");
  const std::vector<DatasetFile> files = dataset_files(results, rows, result_tables(results));
  const auto file = std::ranges::find(files, paths.traces, &DatasetFile::path);
  ASSERT_NE(file, files.end());
  EXPECT_EQ(std::ranges::count(file->bytes, '\n'), 1 + 24 * 51);
  const auto book = std::ranges::find(files, "codebook.csv", &DatasetFile::path);
  EXPECT_NE(book->bytes.find(paths.traces), std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
