#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/manifest/recording_files.h"
#include "pipeline/production/methods/methods_parts.h"
#include "pipeline/production/methods/prose.h"
#include "pipeline/production/synthesis/fitted_recordings.h"

namespace mien::pipeline {

namespace {

void describe_licences(MethodsText& out) {
  std::map<std::pair<std::string, std::string>, std::size_t> counts;  // of licence and source
  for (const RecordingFile& recording : recording_files(out.manifest))
    ++counts[{recording.licence.name, recording.source}];
  Names terms;
  for (const auto& [term, count] : counts) {
    const auto& [licence, source] = term;
    if (licence.empty() && source.empty()) continue;
    std::string text = count_of(count, "recording", "recordings");
    if (!licence.empty()) text += " under the licence " + motion::printable(licence);
    if (!source.empty()) text += " from " + motion::printable(source);
    terms.push_back(text);
  }
  if (!terms.empty()) out.say("The following recordings were used: " + listed(terms));
}

void describe_fits(MethodsText& out) {
  Range residuals;
  for (const FittedRecording& recording : fitted_recordings(out.manifest, out.motions))
    residuals.add(recording.fit.residual_mm);
  if (residuals.count == 0) return;
  out.say(
      fmt::format("A body was fitted to the points of {}; the root mean square distance between "
                  "points and body "
                  "was {}. Gaps of up to 0.2 s were interpolated",
                  count_of(static_cast<std::size_t>(residuals.count), "recording", "recordings"),
                  with_mean(residuals, 1, " mm")));
}

}  // namespace

void describe_recordings(MethodsText& out) {
  describe_licences(out);
  describe_fits(out);
}

}  // namespace mien::pipeline
