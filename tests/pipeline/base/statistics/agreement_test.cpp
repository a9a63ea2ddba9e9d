#include "pipeline/base/statistics/agreement.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

/// Shrout and Fleiss 1979, Table 2: six targets, four judges.
Eigen::MatrixXd shrout_fleiss() {
  Eigen::MatrixXd ratings(6, 4);
  ratings << 9, 2, 5, 8, 6, 1, 3, 2, 8, 4, 6, 8, 7, 1, 2, 6, 10, 5, 6, 9, 6, 2, 4, 7;
  return ratings;
}

TEST(Agreement, MatchesShroutAndFleiss) {
  // Printed: .44, .62 and .91, from MSB 11.24, MSW 6.26, MSJ 32.49, MSE 1.02.
  EXPECT_NEAR(agreement_of(shrout_fleiss()).all.one_k, 0.44, 0.005);
  EXPECT_NEAR(agreement_of(shrout_fleiss()).icc_2_k, 0.62, 0.005);
  EXPECT_NEAR(cronbach_alpha(shrout_fleiss()), 0.91, 0.005);
}

TEST(Agreement, AlphaIsByItsDefinition) {
  // Two raters: 2·(1 − (s₁² + s₂²)/s²).
  Eigen::MatrixXd ratings(4, 2);
  ratings << 1, 2, 2, 2, 3, 5, 4, 3;
  // Variances 5/3 and 2, of the sums 3 4 8 7: 17/3.
  EXPECT_NEAR(cronbach_alpha(ratings), 2.0 * (1.0 - (5.0 / 3.0 + 2.0) / (17.0 / 3.0)), 1e-12);
}

TEST(Agreement, OfRatersWhoAgreeIsOne) {
  const Eigen::MatrixXd same = Eigen::Vector4d(-2, 0, 1, 2).replicate(1, 3);
  EXPECT_NEAR(cronbach_alpha(same), 1.0, 1e-12);
  EXPECT_NEAR(agreement_of(same).icc_2_k, 1.0, 1e-12);
  EXPECT_NEAR(agreement_of(same).all.one_k, 1.0, 1e-12);
}

TEST(Agreement, ARaterWhoLeansLowersAbsoluteAgreementOnly) {
  Eigen::MatrixXd ratings = shrout_fleiss();
  const double alpha = cronbach_alpha(ratings);
  const double icc = agreement_of(ratings).icc_2_k;
  ratings.col(1).array() -= 3.0;
  EXPECT_NEAR(cronbach_alpha(ratings), alpha, 1e-12);
  EXPECT_LT(agreement_of(ratings).icc_2_k, icc - 0.05);
}

TEST(Agreement, CountsWhoRatedEverything) {
  Eigen::MatrixXd ratings(6, 6);
  ratings << shrout_fleiss(), Eigen::MatrixXd::Constant(6, 2, NAN);
  ratings(2, 4) = 5.0;
  const Agreement a = agreement_of(ratings);
  EXPECT_EQ(a.all.raters, 5);
  EXPECT_EQ(a.complete_raters, 4);
  EXPECT_NEAR(a.alpha, cronbach_alpha(shrout_fleiss()), 1e-12);
  EXPECT_NEAR(a.icc_2_k, agreement_of(shrout_fleiss()).icc_2_k, 1e-12);
  // 25 answers: (25 − (5·16 + 25)/25)/5.
  EXPECT_NEAR(a.all.answers_per_stimulus, 4.16, 1e-12);
}

TEST(Agreement, WithoutACompleteRaterIsStillKnownOneWay) {
  Eigen::MatrixXd ratings = Eigen::MatrixXd::Constant(3, 6, NAN);
  ratings(0, 0) = 1, ratings(0, 1) = 2, ratings(1, 2) = 4, ratings(1, 3) = 5, ratings(2, 4) = 8,
             ratings(2, 5) = 7;
  const Agreement a = agreement_of(ratings);
  EXPECT_EQ(a.complete_raters, 0);
  EXPECT_TRUE(std::isnan(a.alpha));
  EXPECT_TRUE(std::isnan(a.icc_2_k));
  // Means 1.5, 4.5, 7.5: MSB 18, MSW 0.5.
  EXPECT_NEAR(a.all.one_k, 17.5 / 18.0, 1e-12);
  EXPECT_DOUBLE_EQ(a.all.answers_per_stimulus, 2.0);
}

TEST(Agreement, IsUnknownWhereNothingVaries) {
  const Eigen::MatrixXd same = Eigen::MatrixXd::Ones(4, 3);
  EXPECT_TRUE(std::isnan(cronbach_alpha(same)));
  EXPECT_TRUE(std::isnan(agreement_of(same).icc_2_k));
  EXPECT_TRUE(std::isnan(agreement_of(same).all.one_k));
  EXPECT_TRUE(std::isnan(cronbach_alpha(Eigen::MatrixXd::Random(4, 1))));
  // What varies by rounding errors alone does not vary.
  const Eigen::MatrixXd third = Eigen::MatrixXd::Constant(7, 3, 33.3);
  EXPECT_TRUE(std::isnan(cronbach_alpha(third)));
  EXPECT_TRUE(std::isnan(agreement_of(third).all.one));
  Eigen::MatrixXd crossed(3, 3);
  crossed << 0.1, 0.2, 0.3, 0.3, 0.1, 0.2, 0.2, 0.3, 0.1;
  EXPECT_TRUE(std::isnan(cronbach_alpha(crossed))) << cronbach_alpha(crossed);
  EXPECT_TRUE(std::isnan(intraclass(crossed).one_k)) << intraclass(crossed).one_k;
}

}  // namespace
}  // namespace mien::pipeline
