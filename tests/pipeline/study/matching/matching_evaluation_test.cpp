#include "pipeline/study/matching/matching_evaluation.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/study/matching/matching_report.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

constexpr const char* header = "participant,target,interface,first_guess_d,time_s,success\n";

MatchingResults read(const std::string& rows) {
  return matching_results({parse_csv(header + rows, "r.csv")});
}

std::string refusal(const std::string& rows) {
  try {
    read(rows);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

/// Three people, two targets, two interfaces; p3 never tried t2 with weights.
MatchingResults sessions() {
  return read(
      "p1,t1,weights,0.10,200,1\np1,t2,weights,0.08,,0\n"
      "p1,t1,adjectives,0.05,100,1\np1,t2,adjectives,0.07,120,1\n"
      "p2,t1,weights,0.12,150,1\np2,t2,weights,,250,1\n"
      "p2,t1,adjectives,0.04,90,1\np2,t2,adjectives,0.03,110,1\n"
      "p3,t1,weights,0.09,100,1\n"
      "p3,t1,adjectives,0.06,130,1\np3,t2,adjectives,0.02,80,1\n");
}

const MatchingMean& mean_of(const MatchingEvaluation& evaluation, MatchingMeasure measure,
                            std::string_view interface, std::string_view target) {
  for (const MatchingMean& m : evaluation.means) {
    if (m.measure == measure && m.interface == interface && m.target == target) return m;
  }
  throw std::runtime_error("no such mean");
}

TEST(MatchingEvaluation, AveragesPeopleAndCountsFailuresAsTheLimit) {
  const MatchingEvaluation e = evaluate(sessions());
  const MatchingMean& time = mean_of(e, MatchingMeasure::time_s, "weights", "");
  EXPECT_EQ(time.n, 3);
  EXPECT_NEAR(time.mean, (250.0 + 200.0 + 100.0) / 3.0, 1e-12);
  EXPECT_NEAR(time.sd, std::sqrt((66.6667 * 66.6667 + 16.6667 * 16.6667 + 83.3333 * 83.3333) / 2),
              1e-3);
  const MatchingMean& guess = mean_of(e, MatchingMeasure::first_guess_d, "weights", "t2");
  EXPECT_EQ(guess.n, 1);
  EXPECT_NEAR(guess.mean, 0.08, 1e-12);
  EXPECT_TRUE(std::isnan(guess.sd));
  EXPECT_NEAR(mean_of(e, MatchingMeasure::time_s, "adjectives", "t1").mean, 320.0 / 3.0, 1e-12);
}

TEST(MatchingEvaluation, CountsGuessesAndFailures) {
  const MatchingEvaluation e = evaluate(sessions());
  ASSERT_EQ(e.shares.size(), 6u);  // over all, then of each target
  EXPECT_EQ(e.shares[0].target, "");
  EXPECT_EQ(e.shares[2].target, "t1");
  EXPECT_EQ(e.shares[2].trials + e.shares[4].trials, e.shares[0].trials);
  EXPECT_EQ(e.shares[0].interface, "weights");
  EXPECT_EQ(e.shares[0].guesses, 4);
  EXPECT_EQ(e.shares[0].near_guesses, 0);
  EXPECT_EQ(e.shares[0].trials, 5);
  EXPECT_EQ(e.shares[0].failures, 1);
  // 0.06 is the threshold itself, so it is no match.
  EXPECT_EQ(e.shares[1].near_guesses, 4);
  EXPECT_EQ(e.shares[1].guesses, 6);
}

TEST(MatchingEvaluation, PairsWhatEachPersonTriedWithBoth) {
  const MatchingEvaluation e = evaluate(sessions());
  ASSERT_EQ(e.comparisons.size(), 6u);  // each measure over all, then of each target
  const MatchingComparison& time = e.comparisons[3];
  EXPECT_EQ(time.target, "");
  ASSERT_EQ(time.measure, MatchingMeasure::time_s);
  EXPECT_EQ(time.first, "weights");
  EXPECT_EQ(time.second, "adjectives");
  // p1 (100 + 180)/2, p2 (60 + 140)/2, p3 −30 on t1 alone.
  EXPECT_EQ(time.exact.pairs, 3);
  EXPECT_NEAR(time.difference.mean, (140.0 + 100.0 - 30.0) / 3.0, 1e-12);
  EXPECT_EQ(time.exact.w_plus, 5.0);
  EXPECT_NEAR(time.exact.p, 0.5, 1e-12);
  EXPECT_NEAR(time.difference.high(0.9) - time.difference.mean,
              time.difference.mean - time.difference.low(0.9), 1e-12);
  // Student's t with 2 degrees of freedom: 2.919986 at 0.95.
  EXPECT_NEAR(time.difference.high(0.9) - time.difference.mean,
              2.919986 * time.difference.standard_error, 1e-4);
}

TEST(MatchingEvaluation, CorrectsForTheComparisonsOfOneMeasure) {
  std::string rows;
  for (int p = 0; p < 8; ++p) {
    const std::string name = "p" + std::to_string(p);
    rows += name + ",t,a,0.1,200,1\n" + name + ",t,b,0.1," + std::to_string(100 + p) + ",1\n" +
            name + ",t,c,0.1," + std::to_string(150 - 3 * p) + ",1\n";
  }
  const MatchingEvaluation e = evaluate(read(rows));
  ASSERT_EQ(e.comparisons.size(), 6u);
  for (const MatchingComparison& c : e.comparisons) {
    if (c.measure == MatchingMeasure::first_guess_d) {
      EXPECT_EQ(c.exact_holm, 1.0);
    } else {
      EXPECT_NEAR(c.exact.p, 2.0 / 256.0, 1e-12);
      EXPECT_NEAR(c.exact_holm, 6.0 / 256.0, 1e-12);
    }
  }
}

/// Of n people whose W+ is w: ranks from the largest down, as far as they go.
std::vector<int> differences_with(int n, int w) {
  std::vector<int> differences;
  for (int rank = n; rank >= 1; --rank) {
    differences.push_back(rank <= w ? rank : -rank);
    if (rank <= w) w -= rank;
  }
  return differences;
}

const MatchingComparison& comparison_of(const MatchingEvaluation& evaluation,
                                        MatchingMeasure measure, std::string_view target,
                                        std::string_view first, std::string_view second) {
  for (const MatchingComparison& c : evaluation.comparisons)
    if (c.measure == measure && c.target == target && c.first == first && c.second == second)
      return c;
  throw std::runtime_error("no such comparison");
}

// With 13 people the paper's p values are those of these W.
TEST(MatchingEvaluation, HasThePapersTestsOfEachTargetAndOverAll) {
  const std::vector<std::pair<int, double>> published = {
      {0, 0.0015}, {9, 0.0107}, {24, 0.1330}, {33, 0.3824}, {42, 0.8068}};
  std::string rows;
  for (std::size_t t = 0; t < published.size(); ++t) {
    const std::vector<int> differences = differences_with(13, published[t].first);
    for (std::size_t p = 0; p < differences.size(); ++p) {
      const auto add = [&](const char* interface, double d, double time) {
        rows += fmt::format("p{},t{},{},{},{},1\n", p, t, interface, d, time);
      };
      add("adjectives", 0.05, 100.0);
      add("weights", 0.05 + 0.001 * differences[p], 100.0 + 0.1 * differences[p]);
      add("features", 0.05 + 0.002 * differences[p], 120.0);
    }
  }
  const MatchingEvaluation e = evaluate(read(rows));
  EXPECT_EQ(e.comparisons.size(), 36u);
  for (std::size_t t = 0; t < published.size(); ++t) {
    for (const auto measure : {MatchingMeasure::first_guess_d, MatchingMeasure::time_s}) {
      const MatchingComparison& c =
          comparison_of(e, measure, fmt::format("t{}", t), "weights", "adjectives");
      EXPECT_EQ(c.exact.pairs, 13);
      EXPECT_EQ(c.exact.tied, 0);
      EXPECT_EQ(c.exact.w_plus, published[t].first);
      EXPECT_NEAR(c.paper.p, published[t].second, 5e-5);
    }
  }
  const MatchingComparison& all =
      comparison_of(e, MatchingMeasure::time_s, "", "features", "adjectives");
  EXPECT_DOUBLE_EQ(all.difference.mean, 20.0);
  EXPECT_TRUE(std::isnan(all.difference.p));  // everybody saves the same
}

TEST(MatchingEvaluation, SaysWhatTheLaterInterfaceSavesWhoeverCameFirst) {
  const std::string fast = "p1,t,adjectives,0.1,100,1\np2,t,adjectives,0.1,110,1\n";
  const std::string slow = "p1,t,weights,0.1,150,1\np2,t,weights,0.1,180,1\n";
  for (const std::string& rows : {fast + slow, slow + fast}) {
    const MatchingEvaluation e = evaluate(read(rows));
    EXPECT_DOUBLE_EQ(
        comparison_of(e, MatchingMeasure::time_s, "", "weights", "adjectives").difference.mean,
        60.0);
    const BarChart chart = time_saved_chart(e, false);
    ASSERT_EQ(chart.bars.size(), 1u);  // one target: nothing twice
    EXPECT_EQ(chart.bars[0].name, "adjectives");
    EXPECT_GT(chart.bars[0].value, 0.0);
  }
}

// 0.3 − 0.1 and 0.5 − 0.3 are 0.2, but not as doubles.
TEST(MatchingEvaluation, RanksEqualDifferencesOfDecimalsAsTies) {
  const MatchingEvaluation e =
      evaluate(read("p1,t,weights,0.3,10,1\np1,t,adjectives,0.1,10,1\np2,t,weights,0.5,10,1\n"
                    "p2,t,adjectives,0.3,10,1\np3,t,weights,0.1,10,1\np3,t,adjectives,0.3,10,1\n"));
  const MatchingComparison& c =
      comparison_of(e, MatchingMeasure::first_guess_d, "", "weights", "adjectives");
  EXPECT_EQ(c.exact.tied, 3);
  EXPECT_EQ(c.exact.w_plus, 4.0);
}

TEST(MatchingEvaluation, DrawsEachTargetThenAll) {
  const BarChart chart = time_chart(evaluate(sessions()), false);
  std::vector<std::string> groups;
  for (const Bar& bar : chart.bars)
    if (groups.empty() || groups.back() != bar.group) groups.push_back(bar.group);
  EXPECT_EQ(groups, (std::vector<std::string>{"t1", "t2", "all targets"}));
}

TEST(MatchingEvaluation, RefusesEveryBadRowWithItsPlace) {
  EXPECT_EQ(
      refusal("p,t,w,-1,3,1\np,t,,0.1,3,yes\np,t,w,0.1,400,1\np,u,w,0.1,,1\n"),
      "r.csv:2:7: \"-1\" is not a number of at least 0; write a decimal number, or leave the field "
      "empty\n"
      "r.csv:3:5: no interface; give a name\n"
      "r.csv:3:12: \"yes\" is neither 1 nor 0; write 1 for a match within the limit, otherwise 0\n"
      "r.csv:4:1: participant \"p\" has already matched \"t\" with \"w\"; keep one of the two "
      "trials\n"
      "r.csv:4:11: a success after 400 s exceeds the limit of 300 s; correct it, or state the "
      "limit with --limit\n"
      "r.csv:5:11: a success without a time; write the seconds that it took");
  EXPECT_EQ(refusal(""), "r.csv: there are no trials; add a row for each trial");
}

/// A table of one participant, as the pages save it.
CsvTable saved_table(const std::string& participant, const std::string& design,
                     const std::string& limit, const std::string& threshold) {
  const std::string rest = "," + design + "," + limit + "," + threshold + "\n";
  return parse_csv(
      "participant,target,interface,first_guess_d,time_s,success,design,limit_s,threshold_m\n" +
          participant + ",t1,weights,0.03,,0" + rest + participant + ",t1,adjectives,0.01,40,1" +
          rest,
      participant + ".csv");
}

TEST(MatchingEvaluation, JoinsTheTablesOfParticipantsAndKnowsTheirTerms) {
  const MatchingResults results = matching_results(
      {saved_table("p1", "a", "120", "0.02"), saved_table("p2", "a", "120", "0.02")});
  EXPECT_EQ(results.trials.size(), 4u);
  EXPECT_EQ(results.limit_s, 120.0);
  const MatchingEvaluation evaluation = evaluate(results);
  EXPECT_DOUBLE_EQ(mean_of(evaluation, MatchingMeasure::time_s, "weights", "").mean, 120.0);
  EXPECT_EQ(evaluation.shares.at(0).near_guesses, 0);  // 0.03 m is near by the paper's threshold
  EXPECT_EQ(evaluation.shares.at(1).near_guesses, 2);
  EXPECT_NE(first_guess_success_chart(evaluation, false).axis.find("D < 0.02 m"),
            std::string::npos);
}

TEST(MatchingEvaluation, CountsGuessesByAnotherThresholdButNotFailuresByAnotherLimit) {
  const std::vector<CsvTable> tables = {saved_table("p1", "a", "120", "0.02"),
                                        saved_table("p2", "a", "120", "0.02")};
  const MatchingResults results = matching_results(tables, {.limit_s = 120.0, .threshold_m = 0.06});
  EXPECT_EQ(evaluate(results).shares.at(0).near_guesses, 2);
  EXPECT_THROW(matching_results(tables, {.limit_s = 300.0, .threshold_m = {}}), Error);
  const CsvTable untold = parse_csv(std::string(header) + "p1,t1,weights,0.03,,0\n", "u.csv");
  EXPECT_EQ(matching_results({untold}, {.limit_s = 90.0, .threshold_m = {}}).trials.at(0).time_s,
            90.0);
}

TEST(MatchingEvaluation, KeepsPeopleAndSimulatedOnesApart) {
  const auto table = [](const std::string& name, const std::string& simulated) {
    return parse_csv("participant,target,interface,first_guess_d,time_s,success,simulated\n" +
                         name + ",t1,weights,0.03,10,1," + simulated + "\n",
                     name + ".csv");
  };
  EXPECT_TRUE(matching_results({table("a", "1"), table("b", "1")}).simulated);
  EXPECT_THROW(matching_results({table("a", "0"), table("b", "1")}), Error);
}

TEST(MatchingEvaluation, RefusesTablesThatDoNotBelongTogether) {
  const auto refused = [](const CsvTable& second) -> std::string {
    try {
      matching_results({saved_table("p1", "a", "120", "0.02"), second});
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refused(saved_table("p2", "b", "120", "0.02")),
            "p2.csv:2:23: design is \"b\", but \"a\" before; evaluate the sessions of each design "
            "separately");
  EXPECT_EQ(refused(saved_table("p2", "a", "60", "0.02")).find("p2.csv:2:25: limit_s is"), 0u);
  EXPECT_EQ(refused(saved_table("p2", "a", "120", "0.03")).find("p2.csv:2:29: threshold_m is"), 0u);
  EXPECT_EQ(refused(saved_table("p1", "a", "120", "0.02")).find("p1.csv:2:1: participant"), 0u);
  CsvTable empty = saved_table("p2", "a", "120", "0.02");
  empty.rows.clear();
  EXPECT_EQ(refused(empty), "p2.csv: there are no trials; add a row for each trial");
}

TEST(MatchingEvaluation, RefusesTermsThatAreNone) {
  for (const char* limit : {"0", "-1", "", "soon"})
    EXPECT_THROW(matching_results({saved_table("p1", "a", limit, "0.02")}), Error) << limit;
}

TEST(MatchingEvaluation, WritesTablesAndFigures) {
  const test::TemporaryFolder folder;
  MatchingResults results = sessions();
  results.simulated = true;
  write_evaluation(evaluate(results), results, folder.path() / "e");
  const auto rows = [&](const char* name) {
    const CsvTable table = read_csv(folder.path() / "e" / name);
    const int column = require_column(table, "sessions");
    for (const auto& row : table.rows) {
      EXPECT_EQ(row[static_cast<size_t>(column)].text, "simulated");
    }
    return table.rows.size();
  };
  EXPECT_EQ(rows("means.csv"), 12u);
  EXPECT_EQ(rows("shares.csv"), 6u);
  EXPECT_EQ(rows("time_saved.csv"), 3u);
  EXPECT_EQ(rows("comparisons.csv"), 6u);
  for (const char* figure :
       {"first_guess_d", "first_guess_success", "time", "time_saved", "failures"}) {
    for (const char* ending : {".pdf", ".svg", ".png"}) {
      EXPECT_GT(std::filesystem::file_size(folder.path() / "e" / (std::string(figure) + ending)),
                1000u);
    }
  }
}

}  // namespace
}  // namespace mien::pipeline
