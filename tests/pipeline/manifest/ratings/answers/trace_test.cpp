#include "pipeline/manifest/ratings/answers/trace.h"

#include <random>

#include <gtest/gtest.h>

#include "pipeline/manifest/ratings/answers/trace_table.h"

namespace mien::pipeline {
namespace {

TEST(Traces, HaveTenSamplesASecondAndOneAtTheEnd) {
  EXPECT_EQ(trace_samples(3.0), 31u);
  EXPECT_EQ(trace_samples(3.01), 32u);
  EXPECT_EQ(trace_samples(27 * (1.0 / 30)), 10u);  // about 0.9 s in binary
  EXPECT_EQ(trace_samples(3.0 + 1e-9), 31u);
  EXPECT_EQ(trace_samples(0.05), 2u);
  EXPECT_EQ(first_sample_from(0.0), 0u);
  EXPECT_EQ(first_sample_from(1.0), 10u);
  EXPECT_EQ(first_sample_from(1.05), 11u);
}

TEST(Traces, AreReadAsTheyAreWritten) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> tenths(0, 1000), sizes(1, 60);
  for (int i = 0; i < 500; ++i) {
    std::vector<double> trace(static_cast<std::size_t>(sizes(random)));
    for (double& sample : trace) sample = tenths(random) / 10.0;
    EXPECT_EQ(read_trace(to_text(trace)), trace);
  }
  EXPECT_EQ(to_text({50.0, 52.5, 0.04, 99.96}), "50 52.5 0 100");
  const std::vector<double> longest(trace_samples(longest_trace_seconds), 99.9);
  EXPECT_LE(to_text(longest).size(), longest_trace_text());
}

TEST(Traces, OfAnythingButNumbersFrom0To100AreRefused) {
  for (const char* text : {"", " ", "50 ", " 50", "50  50", "50,50", "-1", "100.1", "101", "5e1",
                           "nan", "50.", ".5", "50.25", "0x10", "50\t50", "high", "1000"})
    EXPECT_FALSE(read_trace(text).has_value()) << "\"" << text << "\"";
  EXPECT_TRUE(read_trace("0 100 99.9 7").has_value());
}

TEST(Traces, HaveTheMeanOfWhatFollowsLeadAndLag) {
  const std::vector<double> trace = {0, 10, 20, 30, 40};  // until 0.4 s
  EXPECT_DOUBLE_EQ(mean_of_trace(trace, 0.0).value(), 20.0);
  EXPECT_DOUBLE_EQ(mean_of_trace(trace, 0.3).value(), 35.0);
  EXPECT_DOUBLE_EQ(mean_of_trace(trace, 0.2, 0.1).value(), 35.0);
  EXPECT_DOUBLE_EQ(mean_of_trace(trace, 0.4).value(), 40.0);
  EXPECT_FALSE(mean_of_trace(trace, 0.4, 0.1).has_value());
}

AnswerRow answered(const std::string& raw, const std::string& pole_left) {
  AnswerRow row;
  row.participant = "p002";
  row.session = "ab";
  row.trial = 3;
  row.kind = "continuous";
  row.stimulus = "walk";
  row.item = "sad-happy";
  row.value_raw = raw;
  row.pole_left = pole_left;
  return row;
}

TEST(Traces, AreATableOfASampleARowTowardsTheHighEnd) {
  AnswerRow rating = answered("50", "low");
  rating.kind = "rating";
  const std::vector<AnswerRow> rows = {answered("50 62.5", "low"), rating, answered("", ""),
                                       answered("0 62.5", "high")};
  EXPECT_TRUE(has_traces(rows));
  EXPECT_FALSE(has_traces({rating}));
  EXPECT_EQ(traces_csv(rows, {}),
            "participant,session,trial,stimulus,scale,time_s,value,simulated\n"
            "p002,ab,3,walk,sad-happy,0,50,0\n"
            "p002,ab,3,walk,sad-happy,0.1,62.5,0\n"
            "p002,ab,3,walk,sad-happy,0,100,0\n"
            "p002,ab,3,walk,sad-happy,0.1,37.5,0\n");
}

TEST(Traces, EndWithTheFilm) {
  EXPECT_EQ(trace_samples(12.04), 122u);
  EXPECT_EQ(sample_time(120, 12.04), 12.0);
  EXPECT_EQ(sample_time(121, 12.04), 12.04);
  EXPECT_EQ(sample_time(121, 0.0), 12.1) << "of unknown duration";
  const std::string csv = traces_csv({answered("50 60 70", "low")}, {{"walk", 0.16}});
  EXPECT_NE(csv.find(",0.1,60,0\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",0.16,70,0\n"), std::string::npos) << csv;
}

}  // namespace
}  // namespace mien::pipeline
