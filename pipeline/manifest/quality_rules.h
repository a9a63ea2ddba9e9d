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
  hidden_reference,
  anchor,
  min_rt_ms,
  max_rt_ms,
  max_blur_ms,
};

/// The rules' keys in manifests (in `analysis` and `analysis.quality`; `hidden_reference` and
/// `anchor` are the post-screening of grid trials): first those that flag participants, then those
/// that flag answers.
inline constexpr Words<QualityRule> quality_rule_words = {
    {"max_failed_checks", QualityRule::max_failed_checks},
    {"max_longstring", QualityRule::max_longstring},
    {"min_sd", QualityRule::min_sd},
    {"repeated_by", QualityRule::repeated_by},
    {"hidden_reference", QualityRule::hidden_reference},
    {"anchor", QualityRule::anchor},
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

/// The post-screening of ITU-R BS.1534-3 (2015), section 4.1.2: ratings of the hidden reference
/// below this number, and of the anchor above it, in more than this share of the trials.
inline constexpr double post_screening_rating = 90.0;
inline constexpr double post_screening_share = 0.15;

/// Returns the rules that are set and, for grid trials with references or anchors, those of the
/// post-screening.
std::vector<StatedRule> stated_rules(const Questionnaire& asked);

/// Whether answers or participants that break the rule are left out of the analysis.
bool is_excluding(QualityRule rule, const QualityRules& rules);

/// Whether no rule is set. `flagged` is no rule.
bool has_no_rules(const QualityRules& rules);

/// Returns the rules and what is done with flagged answers as a part of an analysis plan: a
/// paragraph with a list, ended by a line end, and a sentence on the post-screening. Empty without
/// rules.
std::string quality_plan(const Questionnaire& asked);

/// Returns one sentence, without its full stop, for the methods section of a paper. Empty without
/// rules.
std::string quality_sentence(const QualityRules& rules);

/// Returns one such sentence on the post-screening. Empty without it.
std::string post_screening_sentence(const Questionnaire& asked);

}  // namespace mien::pipeline
