#include "pipeline/base/statistics/t_test.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/base/statistics/p_correction.h"

namespace mien::pipeline {
namespace {

// Student 1908, R's `sleep`.
const std::vector<double> drug_1 = {0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
const std::vector<double> drug_2 = {1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

std::vector<double> differences() {
  std::vector<double> d;
  for (size_t i = 0; i < drug_1.size(); ++i) d.push_back(drug_1[i] - drug_2[i]);
  return d;
}

TEST(TTest, WelchMatchesR) {
  const TTest test = welch_t_test(drug_1, drug_2);
  EXPECT_NEAR(test.t, -1.8608135, 5e-8);
  EXPECT_NEAR(test.degrees, 17.776474, 5e-7);
  EXPECT_NEAR(test.p, 0.0793941, 5e-8);
  // R: 95 percent confidence interval −3.3654832 0.2054832.
  EXPECT_NEAR(test.low(0.95), -3.3654832, 5e-8);
  EXPECT_NEAR(test.high(0.95), 0.2054832, 5e-8);
}

TEST(TTest, PairedMatchesR) {
  const TTest test = paired_t_test(differences());
  EXPECT_NEAR(test.t, -4.0621277, 5e-8);
  EXPECT_EQ(test.degrees, 9.0);
  EXPECT_NEAR(test.p, 0.0028329, 5e-8);
  // R: −2.4598858 −0.7001142.
  EXPECT_NEAR(test.low(0.95), -2.4598858, 5e-8);
  EXPECT_NEAR(test.high(0.95), -0.7001142, 5e-8);
  EXPECT_NEAR(cohens_dz(differences()), test.t / std::sqrt(10.0), 1e-12);
}

TEST(TTest, IntervalAndPValueSayTheSame) {
  // The interval of confidence 1 − p just touches 0.
  const TTest test = paired_t_test(differences());
  EXPECT_NEAR(test.high(1.0 - test.p), 0.0, 1e-9);
}

TEST(TTest, EndsWellWhereNothingVaries) {
  EXPECT_TRUE(std::isnan(paired_t_test({1.0}).p));
  EXPECT_TRUE(std::isnan(paired_t_test({}).mean));
  EXPECT_EQ(paired_t_test({2.0, 2.0}).p, 0.0);
  EXPECT_EQ(paired_t_test({0.0, 0.0}).p, 1.0);
  EXPECT_TRUE(std::isnan(welch_t_test({1.0}, {1.0, 2.0}).p));
  EXPECT_TRUE(std::isnan(cohens_dz({1.0})));
}

TEST(Holm, CorrectsByItsDefinition) {
  // R: p.adjust(c(0.01, 0.04, 0.03, 0.005), "holm").
  const std::vector<double> corrected = holm({0.01, 0.04, 0.03, 0.005});
  const std::vector<double> expected = {0.03, 0.06, 0.06, 0.02};
  for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(corrected[i], expected[i], 1e-15) << i;
  EXPECT_EQ(holm({0.7, 0.9}), (std::vector<double>{1.0, 1.0}));
  EXPECT_TRUE(holm({}).empty());
}

TEST(Holm, LeavesWhatIsUnknownAside) {
  const std::vector<double> corrected = holm({NAN, 0.02, 0.5});
  EXPECT_TRUE(std::isnan(corrected[0]));
  EXPECT_DOUBLE_EQ(corrected[1], 0.04);
  EXPECT_DOUBLE_EQ(corrected[2], 0.5);
}

}  // namespace
}  // namespace mien::pipeline
