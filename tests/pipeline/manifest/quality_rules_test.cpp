#include "pipeline/manifest/quality_rules.h"

#include <set>

#include <gtest/gtest.h>

#include "pipeline/base/reading/field_writer.h"

namespace mien::pipeline {
namespace {

QualityRules all_rules() {
  QualityRules rules;
  rules.min_rt_ms = 250.0;
  rules.max_rt_ms = 60000.0;
  rules.max_blur_ms = 1234567.5;
  rules.max_longstring = 12;
  rules.min_sd = 0.4;
  rules.repeated_by = "PROLIFIC_PID";
  return rules;
}

Questionnaire asked_with(const QualityRules& rules) {
  Questionnaire asked;
  asked.analysis.quality = rules;
  return asked;
}

TEST(QualityRules, AreStatedWithTheirBounds) {
  std::string text;
  for (const StatedRule& one : stated_rules(all_rules()))
    text += std::string(word_of(quality_rule_words, one.rule)) + " " + one.bound + " ";
  EXPECT_EQ(text,
            "max_longstring 12 min_sd 0.4 repeated_by PROLIFIC_PID min_rt_ms 250 max_rt_ms 60000 "
            "max_blur_ms 1234567.5 ");
}

// Whoever adds a rule to the manifest must say what it flags.
TEST(QualityRules, HaveTheKeysOfManifests) {
  // What is done with those who are flagged, and what the form of the trials brings.
  const std::set<std::string> consequences = {"flagged", "post_screening"};
  const std::set<std::string> of_grids = {"hidden_reference", "anchor"};
  std::set<std::string> keys, words = consequences;
  for (const FieldEntry& entry : entries_of(QualityRules{}, {})) keys.insert(entry.path);
  for (const auto& [word, rule] : quality_rule_words)
    if (rule != QualityRule::max_failed_checks && !of_grids.contains(word)) words.insert(word);
  EXPECT_EQ(keys, words);
  EXPECT_EQ(stated_rules(all_rules()).size() + consequences.size(), keys.size());
}

TEST(QualityRules, ArePlannedInWords) {
  QualityRules rules;
  rules.min_rt_ms = 250.0;
  rules.max_longstring = 12;
  EXPECT_EQ(quality_plan(asked_with(rules)),
            "Quality rules, stated before the data are collected. Flagged are:\n"
            "- participants who gave the same raw answer on scales more than 12 times in "
            "succession (max_longstring: 12)\n"
            "- answers with a response time below 250 ms (min_rt_ms: 250)\n"
            "Answers in practice and warm-up, to attention checks and to repeated stimuli are not "
            "considered.\n"
            "Flagged answers, and all answers of flagged participants, are left out of the "
            "analysis. The data are kept, with the reasons.\n");
  rules.flagged = FlaggedAnswers::kept;
  EXPECT_NE(quality_plan(asked_with(rules)).find("uses flagged answers and participants, too"),
            std::string::npos);
}

TEST(QualityRules, AreASentenceOfAPaper) {
  QualityRules rules;
  rules.max_rt_ms = 60000.0;
  EXPECT_EQ(quality_sentence(rules),
            "By rules stated before data collection, answers with a response time above 60000 ms "
            "were flagged; flagged answers, and all answers of flagged participants, were left out "
            "of the analysis");
  rules.min_rt_ms = 250.0;
  rules.flagged = FlaggedAnswers::kept;
  EXPECT_EQ(quality_sentence(rules),
            "By rules stated before data collection, answers with a response time below 250 ms and "
            "answers with a response time above 60000 ms were flagged; they were reported, but not "
            "left out of the analysis");
}

TEST(QualityRules, AreSilentWhereThereAreNone) {
  QualityRules none;
  none.flagged = FlaggedAnswers::kept;
  EXPECT_TRUE(has_no_rules(none));
  EXPECT_EQ(quality_plan(asked_with(none)), "");
  EXPECT_EQ(quality_sentence(none), "");
}

}  // namespace
}  // namespace mien::pipeline
