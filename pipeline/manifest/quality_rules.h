#pragma once

#include <string>
#include <vector>

#include "motion/text/words.h"
#include "pipeline/manifest/questionnaire.h"

namespace mien::pipeline {

/// What can flag an answer or a participant: the attention checks, and the rules of QualityRules.
enum class QualityRule {
  max_failed_checks,
  max_longstring,
  min_sd,
  repeated_by,
  min_rt_ms,
  max_rt_ms,
  max_blur_ms,
};

/// The rules' keys in manifests (in `analysis` and `analysis.quality`): first those that flag
/// participants, then those that flag answers.
inline constexpr Words<QualityRule> quality_rule_words = {
    {"max_failed_checks", QualityRule::max_failed_checks},
    {"max_longstring", QualityRule::max_longstring},
    {"min_sd", QualityRule::min_sd},
    {"repeated_by", QualityRule::repeated_by},
    {"min_rt_ms", QualityRule::min_rt_ms},
    {"max_rt_ms", QualityRule::max_rt_ms},
    {"max_blur_ms", QualityRule::max_blur_ms}};

/// A rule that a manifest states.
struct StatedRule {
  QualityRule rule;
  std::string bound;    ///< its value: "250", "PROLIFIC_PID"
  std::string flagged;  ///< what it flags: "answers with a response time below 250 ms"
};

/// Returns the rules that are set, in the order of quality_rule_words.
std::vector<StatedRule> stated_rules(const QualityRules& rules);

/// Whether no rule is set. `flagged` is no rule.
bool has_no_rules(const QualityRules& rules);

/// Returns the rules and what is done with flagged answers as a part of an analysis plan: a
/// paragraph with a list, ended by a line end. Empty without rules.
std::string quality_plan(const QualityRules& rules);

/// Returns one sentence, without its full stop, for the methods section of a paper. Empty without
/// rules.
std::string quality_sentence(const QualityRules& rules);

}  // namespace mien::pipeline
