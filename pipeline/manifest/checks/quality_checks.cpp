#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/quality_rules.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/questionnaire_grid.h"
#include "pipeline/manifest/recruitment.h"

namespace mien::pipeline {

namespace {

std::string rule_path(const char* rule) {
  return member_path("questionnaire.analysis.quality", rule);
}

/// The number of raw answers on scales that a completed session has for analysis.
int answers_on_scales(const Manifest& manifest) {
  const Questionnaire& asked = *manifest.questionnaire;
  if (asked.answer.words || !asked.trials->is_on_scale) return 0;
  return rated_stimuli_of_session(manifest) *
         static_cast<int>(questionnaire_scales(manifest).scales.size());
}

/// The largest standard deviation (n − 1) of so many raw answers: half of them at each end.
double largest_deviation(const Questionnaire& asked, int answers) {
  const double range = has_sliders(asked) ? 100.0 : asked.answer.points - 1.0;
  const int at_left = answers / 2;
  return range * std::sqrt(1.0 * at_left * (answers - at_left) / (answers * (answers - 1.0)));
}

/// Warns of rules about raw answers on scales in a questionnaire without such answers.
void warn_of_no_scales(const QualityRules& rules, FaultList& list) {
  const auto warn = [&](const char* rule) {
    list.add(rule_path(rule), "flags nobody: the questionnaire has no answers on scales",
             "omit the rule");
  };
  if (rules.max_longstring) warn("max_longstring");
  if (rules.min_sd) warn("min_sd");
}

void warn_of_bounds(const Questionnaire& asked, int answers, FaultList& list) {
  const QualityRules& rules = asked.analysis.quality;
  if (rules.max_longstring && *rules.max_longstring >= answers)
    list.add(rule_path("max_longstring"),
             fmt::format("flags nobody: a session has {} answers on scales", answers),
             "use a smaller number");
  if (!rules.min_sd) return;
  if (answers < 2 || *rules.min_sd == 0.0)
    list.add(rule_path("min_sd"),
             answers < 2 ? "flags nobody: a session has only one answer on a scale"
                         : "flags nobody: no standard deviation is below 0",
             "omit the rule");
  const double most = largest_deviation(asked, answers);
  if (answers > 1 && *rules.min_sd > most)
    list.add(rule_path("min_sd"),
             fmt::format("flags everybody: {} raw answers from {} to {} have a standard deviation "
                         "of at most {:g}",
                         answers, has_sliders(asked) ? 0 : 1,
                         has_sliders(asked) ? 100 : asked.answer.points,
                         std::floor(most * 100.0) / 100.0),
             "use a smaller number");
}

bool has_post_screening(const Questionnaire& asked) {
  return asked.trials->is_grid && (is_stated(asked.grid.reference) || is_stated(asked.grid.anchor));
}

}  // namespace

std::vector<Fault> quality_warnings(const Manifest& manifest) {
  const QualityRules& rules = manifest.questionnaire->analysis.quality;
  FaultList list(manifest.places);
  const int answers = answers_on_scales(manifest);
  if (answers == 0)
    warn_of_no_scales(rules, list);
  else
    warn_of_bounds(*manifest.questionnaire, answers, list);
  if (has_no_rules(rules) && list.was_given(rule_path("flagged")))
    list.add(rule_path("flagged"), "has no effect: no quality rule is stated",
             "state a rule, such as min_rt_ms: 250, or omit it");
  return list.take();
}

std::vector<Fault> check_quality(const Manifest& manifest) {
  if (!manifest.questionnaire) return {};
  const Questionnaire& questionnaire = *manifest.questionnaire;
  const QualityRules& rules = questionnaire.analysis.quality;
  FaultList list(manifest.places);
  if (rules.min_rt_ms && rules.max_rt_ms && *rules.min_rt_ms >= *rules.max_rt_ms)
    list.add(rule_path("min_rt_ms"), fmt::format("is not below max_rt_ms: {}", *rules.max_rt_ms),
             "exchange them");
  if (list.was_given(rule_path("post_screening")) && !has_post_screening(questionnaire))
    list.add_at_key(rule_path("post_screening"),
                    "the questionnaire has no grid trials with a reference or an anchor",
                    "omit it");
  if (rules.repeated_by.empty()) return list.take();
  const std::vector<std::string> kept = kept_parameters(questionnaire.recruitment);
  if (std::ranges::find(kept, rules.repeated_by) == kept.end())
    list.add(rule_path("repeated_by"),
             "the study does not keep the URL parameter " + motion::in_quotes(rules.repeated_by),
             kept.empty() ? "add recruitment: {url_parameters: [" + rules.repeated_by + "]}"
                          : motion::did_you_mean(rules.repeated_by, kept));
  return list.take();
}

}  // namespace mien::pipeline
