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

/// Stimuli synthesised for the values 0.1, 0.2, … of one scale.
std::vector<MadeParameter> asked_for(int count) {
  std::vector<MadeParameter> made;
  for (int i = 1; i <= count; ++i) made.push_back({stimulus(i), "slow-fast", 0.1 * i, 0.1 * i});
  return made;
}

/// Answers of people who see `seen(asked)` of it, and err.
template <class Seen>
Answers answers_by(const std::vector<MadeParameter>& made, int people, double error, Seen seen) {
  Answers answers;
  for (int p = 0; p < people; ++p) {
    for (const MadeParameter& parameter : made) {
      const std::string person = "p" + std::to_string(p);
      const double share =
          seen(parameter.asked) + error * normal(3, person + " " + parameter.stimulus);
      answers.answers.push_back({person, parameter.stimulus, "slow-fast", 4.0 * share - 2.0});
    }
  }
  return answers;
}

TEST(Calibration, FindsTheLineThatPeopleSeeBy) {
  const auto made = asked_for(9);
  const Calibration calibration = calibrate(
      made, answers_by(made, 5, 0.0, [](double asked) { return 0.2 + 0.5 * asked; }), pairs());
  ASSERT_EQ(calibration.corrections.size(), 1u);
  EXPECT_NEAR(calibration.corrections[0].intercept, 0.2, 1e-12);
  EXPECT_NEAR(calibration.corrections[0].slope, 0.5, 1e-12);
  EXPECT_NEAR(calibration.corrections[0].r_squared, 1.0, 1e-12);
}

// A stimulus synthesised for `next` is perceived at the wanted value.
TEST(Calibration, CorrectsTheNextRound) {
  const auto made = asked_for(9);
  const auto seen = [](double asked) { return 0.1 + 0.7 * asked; };
  const Calibration calibration = calibrate(made, answers_by(made, 4, 0.0, seen), pairs());
  for (const PerceivedParameter& stimulus : calibration.stimuli) {
    ASSERT_TRUE(stimulus.next);
    const double wanted = stimulus.made.asked;
    if (wanted > 0.1 && wanted < 0.8) {
      EXPECT_NEAR(seen(*stimulus.next), wanted, 1e-9);
    }
    EXPECT_GE(*stimulus.next, 0.0);
    EXPECT_LE(*stimulus.next, 1.0);
  }
}

// Nine times out of ten the true slope lies within 1.86 standard errors (t of 7 degrees).
TEST(Calibration, TellsHowSureTheSlopeIs) {
  const auto made = asked_for(9);
  int within = 0;
  for (int study = 0; study < 200; ++study) {
    Answers answers;
    for (const MadeParameter& parameter : made) {
      const double error = 0.05 * normal(9, "study " + std::to_string(study) + parameter.stimulus);
      answers.answers.push_back(
          {"p", parameter.stimulus, "slow-fast", 4.0 * (parameter.asked + error) - 2.0});
    }
    const Correction correction = calibrate(made, answers, pairs()).corrections[0];
    within += std::abs(correction.slope - 1.0) < 1.895 * correction.slope_error ? 1 : 0;
  }
  EXPECT_NEAR(within / 200.0, 0.9, 0.06);
}

TEST(Calibration, CorrectsNothingWherePeopleSeeNothing) {
  const auto made = asked_for(9);
  const Calibration calibration = calibrate(
      made, answers_by(made, 3, 0.0, [](double asked) { return 0.8 - 0.3 * asked; }), pairs());
  EXPECT_FALSE(calibration.corrections[0].is_usable());
  for (const PerceivedParameter& stimulus : calibration.stimuli) EXPECT_FALSE(stimulus.next);
}

// The mean of equal numbers may be off by a rounding, which is no spread to fit a line to.
TEST(Calibration, FitsNoLineWhereAllAskForTheSame) {
  for (const double asked : {0.8, 0.1, 0.3}) {
    auto made = asked_for(6);
    for (MadeParameter& parameter : made) parameter.asked = asked;
    const Calibration calibration =
        calibrate(made, answers_by(made, 4, 0.1, [](double) { return 0.5; }), pairs());
    EXPECT_FALSE(calibration.corrections[0].is_usable()) << asked;
    for (const PerceivedParameter& stimulus : calibration.stimuli) EXPECT_FALSE(stimulus.next);
  }
}

TEST(Calibration, ReadsAStudysTableAndRefusesOneWithoutWishes) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "parameters.csv";
  write_file(file,
             "stimulus,ratings,parameter,asked,reached,name,name_ja\n"
             "a,given,slow-fast,0.4,0.41,x,y\na,given,sad-happy,,0.5,x,y\n");
  const auto made = read_made_parameters(file);
  ASSERT_EQ(made.size(), 1u);
  EXPECT_EQ(made[0].asked, 0.4);
  EXPECT_EQ(made[0].reached, 0.41);
  EXPECT_TRUE(other_stimuli(file, made).empty());
  write_file(folder.path() / "stimuli.csv", "stimulus,kind\na,stimulus\nmix,stimulus\n");
  EXPECT_EQ(other_stimuli(file, made), std::set<std::string>{"mix"});
  write_file(file, "stimulus,parameter,asked,reached\na,slow-fast,,0.41\n");
  EXPECT_THROW(read_made_parameters(file), Error);
}

TEST(Calibration, RefusesAnswersAboutOtherThings) {
  const auto made = asked_for(3);
  Answers answers;
  answers.answers.push_back({"p", "s1", "sad-happy", 1.0});
  EXPECT_THROW(calibrate(made, answers, pairs()), Error);
}

TEST(Calibration, IsDrawn) {
  const auto made = asked_for(5);
  const Calibration calibration =
      calibrate(made, answers_by(made, 5, 0.05, [](double asked) { return asked; }), pairs());
  EXPECT_NE(as_svg(calibration_chart(calibration)).find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
