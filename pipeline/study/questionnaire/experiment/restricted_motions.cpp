#include "pipeline/study/questionnaire/experiment/restricted_motions.h"

#include <string>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/places.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/recording_files.h"

namespace mien::pipeline {

namespace {

using motion::in_quotes;

/// The examples and targets are sent to browsers, which interpolate them.
std::vector<Fault> restricted_examples(const Manifest& manifest,
                                       const std::vector<RecordingFile>& recordings) {
  std::vector<Fault> faults;
  for (const RecordingFile& recording : recordings) {
    if (recording.licence.share) continue;
    faults.push_back({place_of(manifest.places, recording.path), recording.path,
                      fmt::format("the licence {} does not permit sharing {}, but the "
                                  "experiment sends its motions to browsers",
                                  in_quotes(recording.licence.name),
                                  in_quotes(recording.file.filename().string())),
                      "use recordings that may be shared"});
  }
  return faults;
}

std::vector<Fault> restricted_turns(const Manifest& manifest,
                                    const std::vector<RecordingFile>& recordings) {
  std::vector<Fault> faults;
  for (const std::string& id : shown_stimuli(manifest)) {
    const Stimulus& stimulus = *find_stimulus(manifest, id);
    for (const std::string& licence : restricting_licences(stimulus, recordings))
      faults.push_back({place_of(manifest.places, stimulus.path), stimulus.path,
                        fmt::format("the licence {} does not permit sharing the motion of {}, but "
                                    "view: turn sends it to browsers",
                                    in_quotes(licence), in_quotes(id)),
                        "use view: video"});
  }
  return faults;
}

}  // namespace

std::vector<Fault> restricted_motions(const Manifest& manifest) {
  const std::vector<RecordingFile> recordings = recording_files(manifest);
  if (manifest.matching || manifest.adaptive) return restricted_examples(manifest, recordings);
  if (questionnaire_of(manifest).view != ShownAs::turn) return {};
  return restricted_turns(manifest, recordings);
}

}  // namespace mien::pipeline
