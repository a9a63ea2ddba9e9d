#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/recruitment.h"

namespace mien::pipeline {

std::vector<Fault> check_quality(const Manifest& manifest) {
  if (!manifest.questionnaire) return {};
  const Questionnaire& questionnaire = *manifest.questionnaire;
  const QualityRules& rules = questionnaire.analysis.quality;
  FaultList list(manifest.places);
  const std::string at = member_path(member_path("questionnaire", "analysis"), "quality");
  if (rules.min_rt_ms && rules.max_rt_ms && *rules.min_rt_ms >= *rules.max_rt_ms)
    list.add(member_path(at, "min_rt_ms"),
             fmt::format("is not below max_rt_ms: {}", *rules.max_rt_ms), "exchange them");
  if (rules.repeated_by.empty()) return list.take();
  const std::vector<std::string> kept = kept_parameters(questionnaire.recruitment);
  if (std::ranges::find(kept, rules.repeated_by) == kept.end())
    list.add(member_path(at, "repeated_by"),
             "the study does not keep the URL parameter " + motion::in_quotes(rules.repeated_by),
             kept.empty() ? "add recruitment: {url_parameters: [" + rules.repeated_by + "]}"
                          : motion::did_you_mean(rules.repeated_by, kept));
  return list.take();
}

}  // namespace mien::pipeline
