#include "pipeline/manifest/quality_rules.h"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "pipeline/manifest/questionnaire_grid.h"

namespace mien::pipeline {

namespace {

std::string bound_text(const std::optional<int>& bound) { return fmt::format("{}", *bound); }
std::string bound_text(const std::optional<double>& bound) { return fmt::format("{}", *bound); }

std::vector<StatedRule> post_screening_rules(const Questionnaire& asked) {
  std::vector<StatedRule> stated;
  if (!asked.trials->is_grid) return stated;
  const std::string bound =
      fmt::format("{:g}, {:.0f} %", post_screening_rating, 100.0 * post_screening_share);
  const auto add = [&](QualityRule rule, const char* what) {
    stated.push_back({rule, bound,
                      fmt::format("participants who rated the {} {:g} in more than {:.0f} % of the "
                                  "trials",
                                  what, post_screening_rating, 100.0 * post_screening_share)});
  };
  if (is_stated(asked.grid.reference)) add(QualityRule::hidden_reference, "hidden reference below");
  if (is_stated(asked.grid.anchor)) add(QualityRule::anchor, "anchor above");
  return stated;
}

std::string flagged_text(const std::vector<StatedRule>& stated) {
  std::string text;
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const bool is_last = i + 1 == stated.size();
    text += (i == 0 ? "" : is_last ? " and " : ", ") + stated[i].flagged;
  }
  return text;
}

}  // namespace

std::vector<StatedRule> stated_rules(const QualityRules& rules) {
  std::vector<StatedRule> stated;
  const auto add = [&](QualityRule rule, const auto& bound, fmt::format_string<std::string> words) {
    if (bound) stated.push_back({rule, bound_text(bound), fmt::format(words, bound_text(bound))});
  };
  add(QualityRule::max_longstring, rules.max_longstring,
      "participants who gave the same raw answer on scales more than {} times in succession");
  add(QualityRule::min_sd, rules.min_sd,
      "participants whose raw answers on scales have a standard deviation below {}");
  if (!rules.repeated_by.empty())
    stated.push_back({QualityRule::repeated_by, rules.repeated_by,
                      "participants who had taken part before, identified by the URL parameter " +
                          rules.repeated_by});
  add(QualityRule::min_rt_ms, rules.min_rt_ms, "answers with a response time below {} ms");
  add(QualityRule::max_rt_ms, rules.max_rt_ms, "answers with a response time above {} ms");
  add(QualityRule::max_blur_ms, rules.max_blur_ms,
      "answers of trials during which the window was left for more than {} ms");
  return stated;
}

std::vector<StatedRule> stated_rules(const Questionnaire& asked) {
  std::vector<StatedRule> stated = stated_rules(asked.analysis.quality);
  for (StatedRule& rule : post_screening_rules(asked)) stated.push_back(std::move(rule));
  return stated;
}

bool is_excluding(QualityRule rule, const QualityRules& rules) {
  if (rule == QualityRule::max_failed_checks) return true;
  const bool is_post_screening =
      rule == QualityRule::hidden_reference || rule == QualityRule::anchor;
  return (is_post_screening ? rules.post_screening : rules.flagged) == FlaggedAnswers::excluded;
}

bool has_no_rules(const QualityRules& rules) { return stated_rules(rules).empty(); }

std::string quality_plan(const Questionnaire& asked) {
  const QualityRules& rules = asked.analysis.quality;
  const std::vector<StatedRule> stated = stated_rules(rules);
  const std::string screening = post_screening_sentence(asked);
  const std::string end = screening.empty() ? "" : screening + ".\n";
  if (stated.empty()) return end;
  std::string text = "Quality rules, stated before the data are collected. Flagged are:\n";
  for (const StatedRule& one : stated)
    text += fmt::format("- {} ({}: {})\n", one.flagged, word_of(quality_rule_words, one.rule),
                        one.bound);
  text +=
      "Answers in practice and warm-up, to attention checks and to repeated stimuli are not "
      "considered.\n";
  return text +
         (rules.flagged == FlaggedAnswers::excluded
              ? "Flagged answers, and all answers of flagged participants, are left out of "
                "the analysis. The data are kept, with the reasons.\n"
              : "The analysis uses flagged answers and participants, too. The report lists "
                "them with the reasons.\n") +
         end;
}

std::string quality_sentence(const QualityRules& rules) {
  const std::vector<StatedRule> stated = stated_rules(rules);
  if (stated.empty()) return "";
  return "By rules stated before data collection, " + flagged_text(stated) + " were flagged; " +
         (rules.flagged == FlaggedAnswers::excluded
              ? "flagged answers, and all answers of flagged participants, were left out of the "
                "analysis"
              : "they were reported, but not left out of the analysis");
}

std::string post_screening_sentence(const Questionnaire& asked) {
  const std::vector<StatedRule> stated = post_screening_rules(asked);
  if (stated.empty()) return "";
  return "Post-screening (ITU-R BS.1534-3): " + flagged_text(stated) + " are flagged and " +
         (asked.analysis.quality.post_screening == FlaggedAnswers::excluded
              ? "left out of the analysis"
              : "reported, but not left out of the analysis");
}

}  // namespace mien::pipeline
