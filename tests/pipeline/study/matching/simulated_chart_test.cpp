#include <gtest/gtest.h>

#include "pipeline/plot_texts.h"
#include "pipeline/study/matching/simulated_evaluation.h"

namespace mien::pipeline {
namespace {

std::vector<InterfaceSummary> summaries(bool users) {
  std::vector<InterfaceSummary> all;
  for (const InterfaceKind kind :
       {InterfaceKind::adjectives, InterfaceKind::features, InterfaceKind::weights}) {
    for (const double step : {0.1, 0.25, 0.0}) {
      if (step == 0.0 && !users) continue;
      InterfaceSummary s;
      s.kind = kind;
      s.step = step;
      s.count = 5;
      s.mean_first = 0.02 + 0.1 * step;
      s.sd_first = 0.012;
      s.first_success = 0.8;
      s.failure = 0.1;
      all.push_back(s);
    }
  }
  return all;
}

TEST(SimulatedChart, KeepsItsTextsToThePageAndApart) {
  test::expect_texts_apart(simulated_chart(summaries(true), 0.06));
  test::expect_texts_apart(simulated_chart(summaries(false), 0.06));
}

TEST(SimulatedChart, AlwaysSaysThatNobodyTookPart) {
  for (const bool users : {true, false}) {
    const Plot plot = simulated_chart(summaries(users), 0.06);
    EXPECT_TRUE(test::says(plot, "Simulated participants  模擬"));
    EXPECT_TRUE(test::says(plot, "0.06 m"));
    EXPECT_EQ(test::says(plot, "80 %"), users);  // which only users have: shares
    EXPECT_EQ(test::says(plot, "Never matched"), users);
  }
}

}  // namespace
}  // namespace mien::pipeline
