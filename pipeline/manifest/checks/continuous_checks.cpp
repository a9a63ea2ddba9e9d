#include <string>
#include <vector>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/questionnaire_content.h"

namespace mien::pipeline {

namespace {

std::string asked_path(const char* key) { return member_path("questionnaire", key); }

/// Refuses keys that do not suit continuous ratings: a film plays once, while it is rated.
void check_continuous_keys(const Questionnaire& asked, FaultList& list) {
  const std::string replays = asked_path("replays");
  if (list.was_given(replays) && asked.replays.most != 0)
    list.add_at_key(replays, "in continuous trials, a video plays once, while it is rated",
                    "omit it, or use replays: none");
  if (list.was_given(asked_path("watch")) && asked.watch != Watching::full)
    list.add_at_key(asked_path("watch"), "continuous trials end with the video", "omit it");
  if (asked.view == ShownAs::turn)
    list.add_at_key(asked_path("view"), "continuous trials follow the time of a video",
                    "omit it, or use view: video");
  if (!asked.reference.empty())
    list.add_at_key(asked_path("reference"), "one video is watched while it is rated", "omit it");
  for (const char* key : {"points", "slider", "words", "suggest", "anchors", "default"}) {
    const std::string path = member_path(asked_path("answer"), key);
    if (list.was_given(path))
      list.add_at_key(path, "continuous trials are answered by moving a marker from 0 to 100",
                      "omit it");
  }
}

void check_input(const Questionnaire& asked, FaultList& list) {
  const bool is_by_keys = asked.continuous.input == TraceInput::keys;
  if (is_by_keys && asked.phones == Phones::served)
    list.add(asked_path("phones"), "phones have no arrow keys",
             "use phones: refused, or continuous: {input: slider}");
}

/// Rules about single raw answers find nothing in traces.
void check_trace_rules(const Questionnaire& asked, FaultList& list) {
  const std::string rules = "questionnaire.analysis.quality";
  const QualityRules& quality = asked.analysis.quality;
  for (const auto& [key, is_stated] : {std::pair{"max_longstring", !!quality.max_longstring},
                                       std::pair{"min_sd", !!quality.min_sd}})
    if (is_stated)
      list.add_at_key(member_path(rules, key), "continuous trials have traces as raw answers",
                      "omit it");
}

}  // namespace

std::vector<Fault> check_continuous(const Manifest& manifest) {
  if (!manifest.questionnaire) return {};
  const Questionnaire& asked = *manifest.questionnaire;
  FaultList list(manifest.places);
  if (!asked.trials->is_continuous) {
    const std::string lag = "questionnaire.analysis.lag";
    if (list.was_given(lag)) list.add_at_key(lag, "only continuous trials have traces", "omit it");
    return list.take();
  }
  check_continuous_keys(asked, list);
  check_input(asked, list);
  check_trace_rules(asked, list);
  return list.take();
}

}  // namespace mien::pipeline
