#include "pipeline/commands/study/study_subject.h"

#include <filesystem>

#include "pipeline/base/documents/environment.h"
#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/manifest/asked.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/reading/example_source.h"

namespace mien::pipeline {

std::vector<motion::InterpolationMethod> methods_with_parameters() {
  using enum motion::InterpolationMethod;
  return {reach, cardinal, nearest, inverse_distance, grid, kriging, pca, incremental};
}

CommandOption methods_option(std::vector<motion::InterpolationMethod>& methods,
                             const std::string& otherwise) {
  WordValues<motion::InterpolationMethod> by_name;
  for (const motion::InterpolationMethod method : methods_with_parameters())
    by_name.emplace_back(motion::name_of(method), method);
  return choice("--methods", methods, by_name,
                "Interpolation methods to try, separated by commas; " + otherwise);
}

Manifest asked_manifest(const std::string& name, const Console& console) {
  Manifest manifest = load_manifest(manifest_meant(name, console), process_environment());
  questionnaire_of(manifest);
  return manifest;
}

Manifest participants_manifest(const std::string& name, const Console& console) {
  Manifest manifest = load_manifest(manifest_meant(name, console), process_environment());
  if (!manifest.matching) questionnaire_of(manifest);
  return manifest;
}

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
