#include "pipeline/manifest/reported_analyses.h"

#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/asked_study.h"

namespace mien::pipeline {
namespace {

std::string words_of(const Manifest& manifest, ReportTense tense = ReportTense::past) {
  return fmt::format("{}.", fmt::join(reported_analyses(manifest, tense), ". "));
}

bool holds(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

TEST(ReportedAnalyses, OfRatingsAreByTheFactorsUnlessThePlanStatesThem) {
  Manifest manifest = test::asked_study(8, "participants: 4, scales: [sad-happy]");
  EXPECT_EQ(words_of(manifest),
            "Ratings on each scale were analysed by a repeated-measures analysis of variance with "
            "the factors actor and emotion within participants, as far as their levels are "
            "crossed, with p values corrected by Greenhouse and Geisser's method. Participants "
            "without an analysed rating in each cell of the design were left out of the analysis "
            "of variance of that scale. All pairs of "
            "levels of the factors actor and emotion were compared within participants by paired t "
            "tests and Wilcoxon signed-rank tests; the pairs of a factor on all scales formed one "
            "family. The answers of participants who did not finish were included.");
  EXPECT_TRUE(
      holds(words_of(manifest, ReportTense::present), "Ratings on each scale are analysed"));
  manifest.questionnaire->analysis.factorial.factors = {"emotion"};
  EXPECT_TRUE(words_of(manifest).starts_with("Participants without an analysed rating in"));
  EXPECT_TRUE(holds(words_of(manifest), "All pairs of levels of the factor emotion were"));
  for (Stimulus& stimulus : manifest.stimuli) stimulus.factors.clear();
  manifest.questionnaire->analysis.factorial = {};
  EXPECT_EQ(words_of(manifest), "The answers of participants who did not finish were included.");
}

TEST(ReportedAnalyses, OfContinuousTrialsAreOfTracesMoodsAndAgreement) {
  Manifest manifest =
      test::asked_study(8, "participants: 4, scales: [sad-happy], trials: continuous");
  const std::string text = words_of(manifest);
  for (const char* words :
       {"the mean trace over participants was computed ten times in each second, with a 95 %",
        "Cronbach's α and by the intraclass correlations ICC(2,1) and ICC(2,k)",
        "The means of trials on each scale were analysed by a repeated-measures",
        "All pairs of levels of the factors actor and emotion"})
    EXPECT_TRUE(holds(text, words)) << words;
  EXPECT_FALSE(holds(text, "in which the mood changes"));
  WalkPath path;
  path.script.resize(2);
  path.script[0].mood = path.script[1].mood = {{"sad", 1.0}};
  manifest.stimuli[0].walk = path;
  EXPECT_FALSE(holds(words_of(manifest), "in which the mood changes"));
  manifest.stimuli[0].walk->script[1].mood = {{"happy", 1.0}};
  EXPECT_TRUE(holds(words_of(manifest), "For films in which the mood changes, each participant's"));
}

TEST(ReportedAnalyses, WithoutRatingsAreOfUnfinishedAnswersOnly) {
  for (const char* asked : {"participants: 4, trials: emotion, choices: [sad, happy, calm]",
                            "participants: 4, scales: [sad-happy], trials: pair"})
    EXPECT_EQ(words_of(test::asked_study(8, asked), ReportTense::present),
              "The answers of participants who do not finish are included.");
}

}  // namespace
}  // namespace mien::pipeline
