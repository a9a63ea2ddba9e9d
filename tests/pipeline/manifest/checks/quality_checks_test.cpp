#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/study/questionnaire/asked_study.h"

namespace mien::pipeline {
namespace {

/// The faults of a questionnaire of five stimuli with these rules.
std::string rule_faults(const std::string& rules, const std::string& more = "") {
  const ManifestReading reading =
      parse_manifest(test::asked_study_text(5, "participants: 4, scales: [sad-happy]" + more +
                                                   ", analysis: {quality: {" + rules + "}}"),
                     "/nowhere/m.yaml", [](const std::string&) { return std::nullopt; });
  return reading.faults.empty() ? "" : Faults(reading.faults).what();
}

/// The warnings about these rules; `more` are members of the questionnaire.
std::string rule_warnings(const std::string& rules,
                          const std::string& more = ", scales: [sad-happy]") {
  std::string text;
  for (const Fault& warning : questionnaire_warnings(test::asked_study(
           5, "participants: 4" + more + ", analysis: {quality: {" + rules + "}}")))
    text += warning.path + ": " + warning.wrong + "\n";
  return text;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(QualityChecks, RefuseRulesThatContradictEachOtherOrTheRecruitment) {
  EXPECT_EQ(rule_faults("min_rt_ms: 250, max_rt_ms: 251"), "");
  EXPECT_TRUE(holds(rule_faults("min_rt_ms: 250, max_rt_ms: 250"),
                    "questionnaire.analysis.quality.min_rt_ms: is not below max_rt_ms: 250"));
  EXPECT_TRUE(holds(rule_faults("repeated_by: PID"), "add recruitment: {url_parameters: [PID]}"));
  const std::string recruited = ", recruitment: {url_parameters: [PROLIFIC_PID]}";
  EXPECT_EQ(rule_faults("repeated_by: PROLIFIC_PID", recruited), "");
  EXPECT_TRUE(
      holds(rule_faults("repeated_by: PROLIFIC_PDI", recruited), "did you mean \"PROLIFIC_PID\"?"));
  EXPECT_TRUE(holds(rule_faults("max_longstring: 0"), "quality.max_longstring"));
  EXPECT_TRUE(holds(rule_faults("flagged: dropped"), "excluded, kept"));
}

TEST(QualityChecks, WarnOfRulesAboutScalesWithoutAnswersOnScales) {
  const std::string rules = "max_longstring: 3, min_sd: 0.2, min_rt_ms: 200";
  const std::string both =
      "questionnaire.analysis.quality.max_longstring: flags nobody: the questionnaire has no "
      "answers on scales\n"
      "questionnaire.analysis.quality.min_sd: flags nobody: the questionnaire has no answers on "
      "scales\n";
  EXPECT_EQ(rule_warnings(rules), "");
  EXPECT_EQ(rule_warnings(rules, ", scales: [sad-happy], answer: {words: true}"), both);
  EXPECT_EQ(rule_warnings(rules, ", scales: [sad-happy], trials: pair"), both);
  EXPECT_EQ(rule_warnings(rules, ", trials: emotion, choices: [sad, happy]"), both);
  EXPECT_EQ(rule_warnings(rules, ", trials: emotion, choices: [sad, happy], scales: [sad-happy]"),
            "");
}

// A session has five answers on the scale, or four by per_participant.
TEST(QualityChecks, WarnOfBoundsThatNoSessionCanReach) {
  EXPECT_EQ(rule_warnings("max_longstring: 4"), "");
  EXPECT_TRUE(holds(rule_warnings("max_longstring: 5"), "flags nobody: a session has 5 answers"));
  EXPECT_TRUE(holds(rule_warnings("max_longstring: 4", ", scales: [sad-happy], per_participant: 4"),
                    "flags nobody: a session has 4 answers"));
  EXPECT_EQ(rule_warnings("min_sd: 2.19"), "");
  EXPECT_TRUE(holds(rule_warnings("min_sd: 2.2"),
                    "flags everybody: 5 raw answers from 1 to 5 have a standard deviation of at "
                    "most 2.19"));
  EXPECT_EQ(rule_warnings("min_sd: 54.7", ", scales: [sad-happy], answer: {slider: true}"), "");
  EXPECT_TRUE(holds(rule_warnings("min_sd: 54.8", ", scales: [sad-happy], answer: {slider: true}"),
                    "from 0 to 100 have a standard deviation of at most 54.77"));
  EXPECT_TRUE(holds(rule_warnings("min_sd: 0"), "no standard deviation is below 0"));
}

TEST(QualityChecks, WarnOfFlaggedWithoutRules) {
  EXPECT_TRUE(holds(rule_warnings("flagged: kept"), "quality.flagged: has no effect"));
  EXPECT_EQ(rule_warnings("flagged: kept, min_rt_ms: 250"), "");
}

}  // namespace
}  // namespace mien::pipeline
