#include "pipeline/commands/study/study_subject.h"

#include <filesystem>

#include "pipeline/base/documents/environment.h"
#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/example_source.h"

namespace mien::pipeline {

Manifest manifest_of(const StudySubject& subject, const Console& console) {
  const std::filesystem::path file(subject.examples);
  Manifest manifest;
  if (file.extension() == ".yaml" || file.extension() == ".yml") {
    manifest = load_manifest(given_or_installed(subject.examples, console), process_environment());
    refuse_unblendable(manifest.examples);
  } else {
    manifest.examples = parse_examples(subject.examples);
    if (!manifest.examples.builtin.empty()) manifest.ratings.source = Ratings::Source::builtin;
  }
  if (!subject.ratings.empty()) {
    manifest.ratings.source = Ratings::Source::file;
    manifest.ratings.file = subject.ratings;
  }
  if (!subject.scales.empty()) manifest.scales = scales_in(subject.scales);
  return manifest;
}

}  // namespace mien::pipeline
