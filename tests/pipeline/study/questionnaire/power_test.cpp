#include "pipeline/study/questionnaire/power.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/study/questionnaire/asked_study.h"
#include "pipeline/study/questionnaire/paired_t_power.h"

namespace mien::pipeline {
namespace {

using test::asked_study;
using test::paired_t_power;

TEST(PairedTPower, IsThatOfPublishedTables) {
  // Cohen 1988, G*Power 3: d_z = 0.5, two-sided 0.05: 34 pairs for 0.80 (0.8078), and 27 pairs give
  // 0.7045; d_z = 0.8: 15 pairs, 0.8213.
  EXPECT_NEAR(paired_t_power(34, 0.5, 1.0, 0.05), 0.8078, 5e-4);
  EXPECT_NEAR(paired_t_power(15, 0.8, 1.0, 0.05), 0.8213, 5e-4);
  EXPECT_LT(paired_t_power(33, 0.5, 1.0, 0.05), 0.8);
  EXPECT_NEAR(paired_t_power(20, 0.0, 1.0, 0.05), 0.05, 1e-9);
}

TEST(Power, OfASimulationIsThatOfThePairedTTest) {
  const Manifest manifest = asked_study(6, "participants: 30, scales: [sad-happy]");
  PowerOptions question;
  question.spread = RatingSpread{.participant = 2.0, .stimulus = 1.0, .residual = 0.8};
  const PowerEstimate estimate = estimate_power(manifest, question);
  // Participants' leaning falls out of a difference, whose deviation is √2 that of a rating.
  const double deviation = std::sqrt(2.0) * 0.8;
  const double expected = paired_t_power(30, 0.5, deviation, 0.05);
  EXPECT_NEAR(estimate.power.share, expected, 0.025);  // 3.5 standard errors of 4000 studies
  EXPECT_LE(estimate.power.low, expected);
  EXPECT_GE(estimate.power.high, expected);
  EXPECT_NEAR(estimate.false_positives.share, 0.05, 0.0125);
  EXPECT_EQ(estimate.usable, 30.0);
  int needed = 2;
  while (paired_t_power(needed, 0.5, deviation, 0.05) < 0.8) ++needed;
  EXPECT_LE(estimate.needed_low, needed);
  EXPECT_GE(estimate.needed_high, needed);
  EXPECT_LE(estimate.needed_high - estimate.needed_low, 6);
}

TEST(Power, CountsWhoSawBothOfAnIncompleteDesign) {
  const Manifest manifest =
      asked_study(12, "participants: 44, scales: [sad-happy], per_participant: 6");
  PowerOptions question;
  question.studies = 2000;
  const PowerEstimate estimate = estimate_power(manifest, question);
  EXPECT_NEAR(estimate.usable, 44.0 * 6 * 5 / (12 * 11), 0.1);  // 10
  const double expected = paired_t_power(10, 0.5, std::sqrt(2.0) * 0.8, 0.05);
  EXPECT_NEAR(estimate.power.share, expected, 0.05);
  EXPECT_GT(estimate.needed, 100);
}

TEST(Power, ComparesLevelsByTheMeansOfTheirStimuli) {
  const Manifest manifest = asked_study(12, "participants: 12, scales: [sad-happy]");
  PowerOptions question;
  question.spread.stimulus = 0.0;
  question.factor = "actor";
  question.level = "a";
  question.other_level = "b";
  // Four stimuli each: a mean of four ratings less one of four.
  const double expected = paired_t_power(12, 0.5, std::sqrt(2.0 / 4.0) * 0.8, 0.05);
  EXPECT_NEAR(estimate_power(manifest, question).power.share, expected, 0.025);
  question.other_level = "bb";
  EXPECT_THROW(estimate_power(manifest, question), Error);
}

TEST(Power, TellsNoNumberWhereDifferencesOfStimuliMisleadTheTest) {
  const Manifest manifest = asked_study(12, "participants: 12, scales: [sad-happy]");
  PowerOptions question;
  question.studies = 400;
  question.factor = "actor";
  question.level = "a";
  question.other_level = "b";
  const PowerEstimate estimate = estimate_power(manifest, question);
  EXPECT_TRUE(is_false_positive_rate_inflated(question, estimate));
  for (const std::string& sentence : power_sentences(question, estimate))
    EXPECT_EQ(sentence.find("Sample size for"), std::string::npos) << sentence;
}

TEST(Power, IsTheSameForTheSameSeed) {
  const Manifest manifest = asked_study(4, "participants: 20, scales: [sad-happy]");
  PowerOptions question;
  question.studies = 500;
  const double once = estimate_power(manifest, question).power.share;
  EXPECT_EQ(estimate_power(manifest, question).power.share, once);
  question.seed = 1;
  EXPECT_NE(estimate_power(manifest, question).power.share, once);
}

TEST(SimulatedShare, HasWilsonsInterval) {
  // Newcombe 1998, table I: 81 of 263: 0.2553 to 0.3662; 0 of 20: 0 to 0.1611.
  const SimulatedShare share = simulated_share(81, 263);
  EXPECT_NEAR(share.low, 0.2553, 5e-5);
  EXPECT_NEAR(share.high, 0.3662, 5e-5);
  EXPECT_NEAR(simulated_share(0, 20).high, 0.1611, 5e-5);
}

}  // namespace
}  // namespace mien::pipeline
