// Answers of known truth: what was put in is found as often as it should be, what was not is not.

#include <cmath>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>

#include "pipeline/study/questionnaire/paired_t_power.h"
#include "pipeline/study/questionnaire/power.h"
#include "pipeline/study/results/comparisons.h"
#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

constexpr double level = 0.05;

/// In how many studies each kind of test found something.
struct Findings {
  int studies = 0;
  int paired = 0;
  int welch = 0;
  int wilcoxon = 0;
  int any_after_holm = 0;  ///< any comparison of the family on its own scale
  int other_scale = 0;     ///< the same stimuli on the scale on which they do not differ
};

/// A modified sad walk against the neutral one, by the paired test.
Findings findings_of(int studies, int participants, const StatedTruth& truth) {
  Findings found;
  for (int study = 0; study < studies; ++study) {
    const Manifest manifest =
        two_emotion_study(participants, 1000 + static_cast<std::uint64_t>(study));
    bool any = false;
    for (const Comparison& c : compare(collect_answers(manifest, answers_to(manifest, truth)))) {
      if (c.family != ComparisonFamily::modified_neutral) continue;
      if (c.intended_end != 0) any = any || c.paired_adjusted < level;
      if (c.stimulus != 3) continue;
      if (c.intended_end == 0) {
        found.other_scale += c.within.t.p < level ? 1 : 0;
        continue;
      }
      found.paired += c.within.t.p < level ? 1 : 0;
      found.welch += c.welch.p < level ? 1 : 0;
      found.wilcoxon += c.within.wilcoxon.p < level ? 1 : 0;
    }
    found.any_after_holm += any ? 1 : 0;
    ++found.studies;
  }
  return found;
}

/// Whether so many of so many are what a probability gives in 999 of 1000 cases.
void expect_share(int found, int studies, double probability, const char* what) {
  const boost::math::binomial outcomes(studies, probability);
  EXPECT_GE(found, quantile(outcomes, 0.0005)) << what << " of " << studies;
  EXPECT_LE(found, quantile(complement(outcomes, 0.0005))) << what << " of " << studies;
}

void expect_no_more(int found, int studies, double probability, const char* what) {
  EXPECT_LE(found, quantile(complement(boost::math::binomial(studies, probability), 0.001)))
      << what << " of " << studies;
}

void expect_false_alarms_at_their_level(int studies) {
  const Findings found = findings_of(studies, 16, {});
  expect_share(found.paired, studies, level, "paired t tests");
  expect_share(found.other_scale, studies, level, "paired t tests on the other scale");
  // Discrete, and blind to what people have in common: at most the level.
  expect_no_more(found.wilcoxon, studies, level, "Wilcoxon tests");
  expect_no_more(found.welch, studies, level, "Welch tests");
  expect_no_more(found.any_after_holm, studies, level, "families after Holm");
}

void expect_power_of_the_design(int studies) {
  constexpr double difference = 0.25;
  constexpr int participants = 20;
  const Findings found = findings_of(studies, participants, {{{"sad", "sad-happy"}, -difference}});
  PowerOptions question;
  question.spread = *steady_people.spread;
  question.difference = difference;
  question.studies = 2000;
  const PowerEstimate estimate = estimate_power(two_emotion_study(participants), question);
  const double exact = test::paired_t_power(participants, difference,
                                            std::sqrt(2.0) * steady_people.spread->residual, level);
  EXPECT_NEAR(estimate.power.share, exact, 0.04);
  expect_share(found.paired, studies, exact, "paired t tests");
  // And where nothing was put in, nothing is found.
  expect_share(found.other_scale, studies, level, "paired t tests on the other scale");
}

TEST(KnownTruth, RaisesFalseAlarmsNoMoreOftenThanStated) { expect_false_alarms_at_their_level(40); }

TEST(KnownTruth, IsFoundAsOftenAsTheDesignSays) { expect_power_of_the_design(40); }

TEST(KnownTruthInManyStudies, RaisesFalseAlarmsNoMoreOftenThanStated) {
  expect_false_alarms_at_their_level(200);
}

TEST(KnownTruthInManyStudies, IsFoundAsOftenAsTheDesignSays) { expect_power_of_the_design(200); }

}  // namespace
}  // namespace mien::pipeline
