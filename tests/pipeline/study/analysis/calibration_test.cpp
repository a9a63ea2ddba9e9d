#include "pipeline/study/analysis/calibration.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/statistics/named_random.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

const ScaleSet& pairs() {
  static const ScaleSet scales = builtin_scales();
  return scales;
}

std::string stimulus(int i) { return "s" + std::to_string(i); }

/// Stimuli requested for 0.1, 0.2, … of one scale.
std::vector<StimulusParameter> requested_submission(int count) {
  std::vector<StimulusParameter> made;
  for (int i = 1; i <= count; ++i) made.push_back({stimulus(i), "slow-fast", 0.1 * i, 0.1 * i});
  return made;
}

/// Answers of people who see `seen(requested)` of it, and err.
template <class Seen>
Answers answers_by(const std::vector<StimulusParameter>& made, int people, double error,
                   Seen seen) {
  Answers answers;
  for (int p = 0; p < people; ++p) {
    for (const StimulusParameter& parameter : made) {
      const std::string person = "p" + std::to_string(p);
      const double share =
          seen(parameter.requested) + error * normal(3, person + " " + parameter.stimulus);
      answers.answers.push_back({person, parameter.stimulus, "slow-fast", 4.0 * share - 2.0});
    }
  }
  return answers;
}

TEST(Calibration, FindsTheLineThatPeopleSeeBy) {
  const auto made = requested_submission(9);
  const Calibration calibration = calibrate(
      made, answers_by(made, 5, 0.0, [](double requested) { return 0.2 + 0.5 * requested; }),
      pairs());
  ASSERT_EQ(calibration.corrections.size(), 1u);
  EXPECT_NEAR(calibration.corrections[0].intercept, 0.2, 1e-12);
  EXPECT_NEAR(calibration.corrections[0].slope, 0.5, 1e-12);
  EXPECT_NEAR(calibration.corrections[0].r_squared, 1.0, 1e-12);
}

// The point of it all: who is requested for `next` is seen as was wanted.
TEST(Calibration, CorrectsTheNextRound) {
  const auto made = requested_submission(9);
  const auto seen = [](double requested) { return 0.1 + 0.7 * requested; };
  const Calibration calibration = calibrate(made, answers_by(made, 4, 0.0, seen), pairs());
  for (const PerceivedParameter& stimulus : calibration.stimuli) {
    ASSERT_TRUE(stimulus.next);
    const double wanted = stimulus.made.requested;
    if (wanted > 0.1 && wanted < 0.8) {
      EXPECT_NEAR(seen(*stimulus.next), wanted, 1e-9);
    }
    EXPECT_GE(*stimulus.next, 0.0);
    EXPECT_LE(*stimulus.next, 1.0);
  }
}

// Nine times out of ten the true slope lies within 1.86 standard errors (t of 7 degrees).
TEST(Calibration, TellsHowSureTheSlopeIs) {
  const auto made = requested_submission(9);
  int within = 0;
  for (int study = 0; study < 200; ++study) {
    Answers answers;
    for (const StimulusParameter& parameter : made) {
      const double error = 0.05 * normal(9, "study " + std::to_string(study) + parameter.stimulus);
      answers.answers.push_back(
          {"p", parameter.stimulus, "slow-fast", 4.0 * (parameter.requested + error) - 2.0});
    }
    const Correction correction = calibrate(made, answers, pairs()).corrections[0];
    within += std::abs(correction.slope - 1.0) < 1.895 * correction.slope_error ? 1 : 0;
  }
  EXPECT_NEAR(within / 200.0, 0.9, 0.06);
}

TEST(Calibration, CorrectsNothingWherePeopleSeeNothing) {
  const auto made = requested_submission(9);
  const Calibration calibration = calibrate(
      made, answers_by(made, 3, 0.0, [](double requested) { return 0.8 - 0.3 * requested; }),
      pairs());
  EXPECT_FALSE(calibration.corrections[0].is_usable());
  for (const PerceivedParameter& stimulus : calibration.stimuli) EXPECT_FALSE(stimulus.next);
}

// The mean of equal numbers may be off by a rounding, which is no spread to fit a line to.
TEST(Calibration, FitsNoLineWhereAllAskForTheSame) {
  for (const double requested : {0.8, 0.1, 0.3}) {
    auto made = requested_submission(6);
    for (StimulusParameter& parameter : made) parameter.requested = requested;
    const Calibration calibration =
        calibrate(made, answers_by(made, 4, 0.1, [](double) { return 0.5; }), pairs());
    EXPECT_FALSE(calibration.corrections[0].is_usable()) << requested;
    for (const PerceivedParameter& stimulus : calibration.stimuli) EXPECT_FALSE(stimulus.next);
  }
}

TEST(Calibration, ReadsAStudysTableAndRefusesOneWithoutWishes) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "parameters.csv";
  write_file(file,
             "stimulus,ratings,parameter,requested,reached,name,name_ja\n"
             "a,given,slow-fast,0.4,0.41,x,y\na,given,sad-happy,,0.5,x,y\n");
  std::vector<Fault> warnings;
  const auto made = read_stimulus_parameters(file, warnings);
  ASSERT_EQ(made.size(), 1u);
  EXPECT_EQ(made[0].requested, 0.4);
  EXPECT_EQ(made[0].reached, 0.41);
  EXPECT_TRUE(other_stimuli(file, made).empty());
  write_file(folder.path() / "stimuli.csv", "stimulus,kind\na,stimulus\nmix,stimulus\n");
  EXPECT_EQ(other_stimuli(file, made), std::set<std::string>{"mix"});
  write_file(file, "stimulus,parameter,requested,reached\na,slow-fast,,0.41\n");
  EXPECT_THROW(read_stimulus_parameters(file, warnings), Error);
  EXPECT_TRUE(warnings.empty());
}

TEST(Calibration, ReadsTablesOfEarlierVersionsAndWarns) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "parameters.csv";
  write_file(file, "stimulus,parameter,asked,reached\na,slow-fast,0.4,0.41\n");
  std::vector<Fault> warnings;
  EXPECT_EQ(read_stimulus_parameters(file, warnings).at(0).requested, 0.4);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(to_string(warnings[0]),
            file.string() + ":1:20: asked: now called requested; rename the column");
}

TEST(Calibration, RefusesAnswersAboutOtherThings) {
  const auto made = requested_submission(3);
  Answers answers;
  answers.answers.push_back({"p", "s1", "sad-happy", 1.0});
  EXPECT_THROW(calibrate(made, answers, pairs()), Error);
}

TEST(Calibration, IsDrawn) {
  const auto made = requested_submission(5);
  const Calibration calibration = calibrate(
      made, answers_by(made, 5, 0.05, [](double requested) { return requested; }), pairs());
  EXPECT_NE(as_svg(calibration_chart(calibration)).find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
