#include "pipeline/study/results/summaries.h"

#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/statistics/reference_values.h"

namespace mien::pipeline {
namespace {

TEST(Summaries, AgreeWithR) {
  for (const std::string name : {"ratings", "few", "smooth"}) {
    AnswerSet answer_set;
    answer_set.stimuli.resize(1);
    answer_set.scales.resize(1);
    answer_set.scales[0].least = -4.0;
    answer_set.scales[0].most = 4.0;
    for (const double value : test::sample(name))
      answer_set.ratings.push_back({answer_set.ratings.size(), 0, 0, value});
    const std::vector<RatingSummary> all = summaries_of(answer_set);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].answers, static_cast<int>(answer_set.ratings.size()));
    test::Expected expected(name + "/summary");
    expected.is("mean", all[0].mean);
    expected.is("sd", all[0].deviation);
    expected.is("median", all[0].median);
    expected.is("low", all[0].low);
    expected.is("high", all[0].high);
  }
}

}  // namespace
}  // namespace mien::pipeline
