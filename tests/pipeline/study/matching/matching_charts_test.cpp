#include <gtest/gtest.h>

#include "pipeline/plot_texts.h"
#include "pipeline/study/matching/matching_report.h"

namespace mien::pipeline {
namespace {

/// Three people, two targets, two interfaces; p3 never tried t2 with weights.
MatchingResults charted_sessions() {
  return matching_results(
      {parse_csv("participant,target,interface,first_guess_d,time_s,success\n"
                 "p1,t1,weights,0.10,200,1\np1,t2,weights,0.08,,0\n"
                 "p1,t1,adjectives,0.05,100,1\np1,t2,adjectives,0.07,120,1\n"
                 "p2,t1,weights,0.12,150,1\np2,t2,weights,,250,1\n"
                 "p2,t1,adjectives,0.04,90,1\np2,t2,adjectives,0.03,110,1\n"
                 "p3,t1,weights,0.09,100,1\n"
                 "p3,t1,adjectives,0.06,130,1\np3,t2,adjectives,0.02,80,1\n",
                 "r.csv")});
}

TEST(MatchingCharts, KeepTheirTextsToThePageAndApart) {
  const MatchingEvaluation e = evaluate(charted_sessions());
  for (const BarChart& chart :
       {first_guess_chart(e, true), first_guess_success_chart(e, false), time_chart(e, true),
        time_saved_chart(e, true), failures_chart(e, true)}) {
    const Plot plot = bar_chart_plot(chart);
    test::expect_texts_apart(plot);
    EXPECT_EQ(test::says(plot, "Simulated sessions"), chart.simulated);
  }
}

}  // namespace
}  // namespace mien::pipeline
