#include "pipeline/study/results/summaries.h"

#include <cmath>
#include <string>
#include <vector>

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

/// The reliability of ratings, stimuli × participants.
Reliability reliability_of_table(const std::vector<std::vector<double>>& table) {
  AnswerSet answer_set;
  answer_set.stimuli.resize(table.size());
  answer_set.people.resize(table.front().size());
  answer_set.scales.resize(1);
  for (std::size_t i = 0; i < table.size(); ++i)
    for (std::size_t k = 0; k < table[i].size(); ++k)
      answer_set.ratings.push_back({k, i, 0, table[i][k]});
  return reliability_of(answer_set).front();
}

TEST(Summaries, SayWhyThereIsNoAgreement) {
  const auto expect_none = [](const std::vector<std::vector<double>>& table, const char* why) {
    const Reliability found = reliability_of_table(table);
    EXPECT_EQ(found.remark, why);
    for (const double one :
         {found.intraclass.one, found.intraclass.two, found.intraclass.three_k, found.alpha})
      EXPECT_TRUE(std::isnan(one)) << why << one;
  };
  expect_none({{1.0, 2.0, 0.0}}, "none: fewer than two videos");
  expect_none({{1.0}, {2.0}, {0.0}}, "none: one participant");
  expect_none({{0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}}, "none: all answers are equal");
  // The means of all videos are equal but for rounding errors.
  expect_none({{0.1, 0.2, 0.3}, {0.3, 0.1, 0.2}, {0.2, 0.3, 0.1}},
              "none: the means of all videos are equal");
  EXPECT_EQ(reliability_of_table({{0.0, 1.0, 2.0}, {1.0, 2.0, 0.0}, {2.0, 0.0, 1.1}}).remark,
            "negative: differences between videos are no larger than by chance");
  // Raters of different levels, who agree on the course: of all coefficients, only ICC(1) is
  // negative, and differences between videos are larger than by chance.
  const Reliability levels =
      reliability_of_table({{0.0, 1.0, 2.0}, {0.1, 1.1, 2.1}, {0.2, 1.2, 2.1}});
  EXPECT_LT(levels.intraclass.one, 0.0);
  EXPECT_GT(levels.intraclass.two, 0.0);
  EXPECT_GT(levels.alpha, 0.0);
  EXPECT_EQ(levels.remark, "ICC(1) is negative: participants differ in level more than videos do");
  const Reliability good =
      reliability_of_table({{0.0, 0.1, 0.2}, {1.0, 1.2, 1.0}, {2.0, 2.1, 2.3}});
  EXPECT_EQ(good.remark, "");
  EXPECT_GT(good.intraclass.two, 0.9);
}

}  // namespace
}  // namespace mien::pipeline
