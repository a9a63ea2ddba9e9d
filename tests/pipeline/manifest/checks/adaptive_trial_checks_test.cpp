#include <gtest/gtest.h>

#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/study/thresholds/dose_study.h"

namespace mien::pipeline {
namespace {

using mien::test::adaptive_members;

/// What is wrong with the dose study; empty if nothing is.
std::string wrong_with(const std::string& members) {
  const ManifestReading reading =
      parse_manifest(mien::test::dose_study_text(members), "/nowhere/m.yaml",
                     [](const std::string&) { return std::nullopt; });
  return reading.faults.empty() ? "" : Faults(reading.faults).what();
}

TEST(AdaptiveTrialChecks, PermitAllMethodsAndForms) {
  for (const char* form : {"two_interval", "yes_no", "same_different"})
    for (const char* more :
         {"factor: dose", "factor: dots, easier: falling, tracks: 3",
          "factor: dose, until: {sd: 0.2, at_most: 60}",
          "factor: dose, method: staircase, down: 3, step: {up: 2, down: 1}, reversals: 8"})
      EXPECT_EQ(wrong_with(adaptive_members(form, more)), "") << form << ": " << more;
  EXPECT_EQ(wrong_with(adaptive_members("two_interval", "factor: dots, easier: falling") +
                       ", signal: {actor: [a]}"),
            "")
      << "references may have the levels of the others";
  EXPECT_EQ(wrong_with(adaptive_members("yes_no", "method: staircase, factor: dose, down: 1")), "");
  EXPECT_EQ(
      wrong_with(adaptive_members("yes_no", "factor: dose") +
                 ", signal: {dose: [0.5, '1', 1.5, 2]}, stimuli: {dose: [0, 0.5, 1, 1.5, 2]}"),
      "")
      << "levels may be numbers";
}

TEST(AdaptiveTrialChecks, TellWhatIsWrongWithItsPlace) {
  struct Wrong {
    std::string members;
    const char* place;
    const char* words;
  };
  const Wrong wrong_ones[] = {
      {"participants: 3, scales: all, adaptive: {factor: dose}", "m.yaml:5:47: questionnaire",
       "rating trials are not adaptive"},
      {adaptive_members("yes_no", "trials: 40"), "questionnaire.adaptive.factor", "missing"},
      {adaptive_members("yes_no", "factor: doze"), "questionnaire.adaptive.factor",
       "did you mean \"dose\""},
      {adaptive_members("yes_no", "factor: word"), "questionnaire.adaptive.factor",
       "the level \"w0\" of \"a0\" is not a number"},
      {adaptive_members("two_interval", "factor: dose") + ", stimuli: {dose: ['0', '0.5', '1']}",
       "questionnaire.adaptive.factor", "there are 2 levels of dose with the signal"},
      {adaptive_members("yes_no", "factor: dose") + ", signal: {dose: ['0', '0.5', '1', '2']}",
       "questionnaire.adaptive.factor", "is not below all levels with the signal"},
      {adaptive_members("yes_no", "factor: dots, easier: falling") +
           ", signal: {dots: ['70', '60', '40', '20']}",
       "questionnaire.adaptive.factor", "is not above all levels"},
      {adaptive_members("two_interval", "factor: dose, method: staircase, down: 1"),
       "questionnaire.adaptive.down", "comes to 50 % right answers"},
      {adaptive_members("two_interval", "factor: dose, method: staircase, step: {up: 6, down: 1}"),
       "questionnaire.adaptive.step", "as large as the grid of 6 levels"},
      {adaptive_members("yes_no",
                        "factor: dose, method: staircase, down: 1, step: {up: 1, down: 9}"),
       "questionnaire.adaptive.step", "comes to 10 % positive answers"},
      {adaptive_members("two_interval", "factor: dose, proportion: 0.5"),
       "questionnaire.adaptive.proportion", "use more than 0.5"},
      {adaptive_members("two_interval", "factor: dose, noise: 0.2"), "questionnaire.adaptive",
       "omit it"},
      {adaptive_members("yes_no", "factor: dose, down: 3"), "questionnaire.adaptive",
       "only staircases have down"},
      {adaptive_members("yes_no", "factor: dose, trials: 500, tracks: 3"),
       "questionnaire.adaptive.trials", "a session would have 1875 trials"},
      {adaptive_members("yes_no", "factor: dose, trials: 40, until: {sd: 0.2, at_most: 60}"),
       "m.yaml:5:96: questionnaire.adaptive.trials", "until already states"},
      {adaptive_members("yes_no", "factor: dose, method: staircase, until: {sd: 0.2, at_most: 60}"),
       "questionnaire.adaptive.until", "only QUEST+ knows"},
      {adaptive_members("yes_no", "factor: dose, until: {sd: 0.7, at_most: 60}"),
       "questionnaire.adaptive.until.sd", "use at most 0.625"},
      {adaptive_members("yes_no", "factor: dose, tracks: 4, until: {sd: 0.2, at_most: 500}"),
       "questionnaire.adaptive.until.at_most", "a session would have 2500 trials"},
      {adaptive_members("yes_no", "factor: dose, until: {sd: 0.2}"), "questionnaire.adaptive.until",
       "at_most"},
      {adaptive_members("yes_no", "factor: dose, until: {sd: 0, at_most: 60}"),
       "questionnaire.adaptive.until.sd", "out of range"},
      {adaptive_members("yes_no", "factor: dose, trials: 4"), "questionnaire.adaptive.trials", "5"},
      {adaptive_members("yes_no", "factor: dose, tracks: 9"), "questionnaire.adaptive.tracks", "8"},
      {adaptive_members("yes_no", "factor: dose") + ", order: fixed", "questionnaire.order",
       "adaptive trials choose what is shown by the answers"},
      {adaptive_members("two_interval", "factor: dose") + ", pairs: [[a0, a1]]",
       "questionnaire.pairs", "omit it"},
      {adaptive_members("same_different", "factor: dose") + ", same_different: {same: 0.3}",
       "questionnaire.same_different", "omit it"}};
  for (const Wrong& one : wrong_ones) {
    const std::string told = wrong_with(one.members);
    EXPECT_NE(told.find(one.place), std::string::npos) << one.members << "\n" << told;
    EXPECT_NE(told.find(one.words), std::string::npos) << one.members << "\n" << told;
  }
}

TEST(AdaptiveTrialChecks, TellAWrongStaircaseOnce) {
  for (const char* more : {"down: 0", "down: 1", "up: 0", "down: 9", "step: 0"}) {
    const std::string told = wrong_with(
        adaptive_members("two_interval", std::string("factor: dose, method: staircase, ") + more));
    EXPECT_NE(told, "");
    EXPECT_EQ(told.find("m.yaml"), told.rfind("m.yaml")) << told;
  }
}

}  // namespace
}  // namespace mien::pipeline
