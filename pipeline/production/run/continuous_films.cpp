#include "pipeline/production/run/continuous_films.h"

#include <algorithm>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/ratings/answers/trace.h"

namespace mien::pipeline {

std::vector<Fault> continuous_film_faults(const Manifest& manifest, const VideoSeconds& seconds) {
  if (!manifest.questionnaire || !manifest.questionnaire->trials->is_continuous) return {};
  const Questionnaire& asked = *manifest.questionnaire;
  FaultList list(manifest.places);
  for (const std::string& id : shown_stimuli(manifest)) {
    const auto film = seconds.find(id);
    const auto stimulus = std::ranges::find(manifest.stimuli, id, &Stimulus::id);
    if (film == seconds.end() || stimulus == manifest.stimuli.end()) continue;
    if (film->second > longest_trace_seconds)
      list.add(stimulus->path,
               fmt::format("the film of {} lasts {:g} s; a film that is rated while it plays lasts "
                           "at most {:g} s",
                           motion::in_quotes(id), film->second, longest_trace_seconds),
               "shorten it, or divide it into several stimuli");
    const double lag = asked.analysis.lag;
    const std::size_t samples = trace_samples(film->second);
    if (samples <= first_sample_from(asked.continuous.lead))
      list.add(stimulus->path,
               fmt::format("the film of {} lasts {:g} s and is over before the lead of {:g} s",
                           motion::in_quotes(id), film->second, asked.continuous.lead),
               "use a smaller continuous: {lead: …}, or a longer film");
    else if (samples <= first_sample_from(asked.continuous.lead + lag))
      list.add(stimulus->path,
               fmt::format("the film of {} lasts {:g} s and is over before the lead of {:g} s and "
                           "the lag of {:g} s",
                           motion::in_quotes(id), film->second, asked.continuous.lead, lag),
               "use a smaller analysis: {lag: …}, or a longer film");
  }
  return list.take();
}

void check_continuous_films(const Manifest& manifest, const VideoSeconds& seconds) {
  std::vector<Fault> faults = continuous_film_faults(manifest, seconds);
  if (!faults.empty()) throw Faults(std::move(faults));
}

}  // namespace mien::pipeline
