#include "pipeline/manifest/factorial_plan.h"

#include <gtest/gtest.h>

#include "pipeline/study/questionnaire/asked_study.h"

namespace mien::pipeline {
namespace {

FactorialPlan planned() {
  FactorialPlan plan;
  plan.factors = {"actor", "emotion"};
  plan.between = "gender";
  plan.contrasts = {
      {"sad against the rest",
       {{"emotion", {{"sad", 1.0}, {"happy", -0.5}, {"angry", -0.5}}}},
       {{"actor", "a"}},
       {"sad-happy"}},
      {"both",
       {{"actor", {{"b", -1.0}, {"a", 1.0}}}, {"emotion", {{"sad", 1.0}, {"happy", -1.0}}}},
       {},
       {}}};
  return plan;
}

TEST(FactorialPlan, IsStatedInWords) {
  EXPECT_EQ(factorial_plan_text(planned(), AnalysedAnswers::ratings),
            "Analysis of variance of each scale by the factors actor, emotion within participants "
            "and groups by gender; p values with Greenhouse and Geisser's correction. The mixed "
            "models have random intercepts of participants and, if cells have several stimuli, of "
            "stimuli.\n"
            "Planned contrasts, tested by paired t tests of the participants' contrast scores:\n"
            "- “sad against the rest” (sad − 0.5 happy − 0.5 angry; at actor a; on sad-happy)\n"
            "- “both” ((−b + a) × (sad − happy))\n");
  FactorialPlan slopes;
  slopes.random_slopes = true;
  EXPECT_NE(factorial_plan_text(slopes, AnalysedAnswers::ratings)
                .find("random slopes of the factors for participants"),
            std::string::npos);
}

TEST(FactorialPlan, IsASentenceOfAPaper) {
  EXPECT_EQ(factorial_sentence(planned(), AnalysedAnswers::ratings),
            "Ratings on each scale were planned to be analysed by a repeated-measures analysis of "
            "variance with the factors actor, emotion within participants and groups by gender, "
            "with p values corrected by Greenhouse and Geisser's method, and by the planned "
            "contrasts “sad against the rest” (sad − 0.5 happy − 0.5 angry; at actor a; on "
            "sad-happy), “both” ((−b + a) × (sad − happy))");
}

TEST(FactorialPlan, OfPairsIsOfWorths) {
  FactorialPlan plan = planned();
  plan.between = "";
  EXPECT_EQ(factorial_plan_text(plan, AnalysedAnswers::choices),
            "Worths of the combinations of the levels of actor and emotion, on each scale.\n"
            "Planned contrasts of log-worths, tested with resampled participants:\n"
            "- “sad against the rest” (sad − 0.5 happy − 0.5 angry; at actor a; on sad-happy)\n"
            "- “both” ((−b + a) × (sad − happy))\n");
  plan.factors.clear();
  plan.contrasts.resize(1);
  EXPECT_EQ(factorial_sentence(plan, AnalysedAnswers::choices),
            "Choices were planned to be analysed by the Bradley-Terry model of the stimuli, and by "
            "the planned contrast “sad against the rest” (sad − 0.5 happy − 0.5 angry; at actor a; "
            "on sad-happy)");
}

TEST(FactorialPlan, ThatIsEmptySaysNothing) {
  EXPECT_EQ(factorial_plan_text({}, AnalysedAnswers::ratings), "");
  EXPECT_EQ(factorial_sentence({}, AnalysedAnswers::ratings), "");
}

TEST(FactorialPlan, TakesTheVariedFactorsOfRatedStimuli) {
  const Manifest all = test::asked_study(5, "participants: 4, scales: all");
  EXPECT_EQ(design_factors(all), (std::vector<std::string>{"actor", "emotion"}));
  // The first four stimuli are sad.
  const Manifest sad = test::asked_study(
      5, "participants: 4, scales: all, stimuli: {emotion: [sad]}, practice: [b5]");
  EXPECT_EQ(design_factors(sad), std::vector<std::string>{"actor"});
  const FactorTable table = design_table(sad);
  ASSERT_EQ(table.rows.size(), 5u);
  EXPECT_EQ(table.rows[1], std::vector<std::string>{"b"});
  EXPECT_EQ(table.rows[4], std::vector<std::string>{""}) << "not rated";
  const Manifest stated =
      test::asked_study(5, "participants: 4, scales: all, analysis: {factors: [emotion]}");
  EXPECT_EQ(design_factors(stated), std::vector<std::string>{"emotion"});
}

}  // namespace
}  // namespace mien::pipeline
