#include "pipeline/checks/checked_manifest.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "pipeline/checks/modification_checks.h"
#include "pipeline/checks/name_checks.h"
#include "pipeline/checks/source_checks.h"
#include "pipeline/checks/vocabulary.h"
#include "pipeline/documents/fault_list.h"

namespace mien::pipeline {

namespace {

/// Faults of the examples' files, unless the manifest's own part about them is at fault already:
/// one mistake is told once.
void add_faults_of_examples(std::vector<Fault>& faults, const Error& error) {
  const auto is_about_examples = [](const Fault& fault) {
    return fault.path.starts_with("examples");
  };
  if (std::any_of(faults.begin(), faults.end(), is_about_examples)) return;
  if (const auto* several = dynamic_cast<const Faults*>(&error)) {
    faults.insert(faults.end(), several->list().begin(), several->list().end());
  } else {
    faults.push_back({{}, "", error.what(), ""});
  }
}

}  // namespace

ManifestReading check_manifest(const std::filesystem::path& file, const Environment& environment,
                               const std::filesystem::path& out) {
  ManifestReading reading = read_manifest(file, environment);
  if (!out.empty() && !reading.manifest.study.empty())
    append(reading.faults, check_sources(reading.manifest, out / reading.manifest.study));
  try {
    const ScalesSource& scales = reading.manifest.scales;
    if (!scales.file.empty() && scales.set.scales.empty()) return reading;  // as was told
    const Vocabulary vocabulary = vocabulary_of(reading.manifest);
    append(reading.faults, check_names(reading.manifest, vocabulary));
    append(reading.faults, check_modification_names(reading.manifest, vocabulary));
  } catch (const Error& error) {
    add_faults_of_examples(reading.faults, error);
  }
  reading.faults = in_reading_order(std::move(reading.faults));
  return reading;
}

Manifest load_manifest(const std::filesystem::path& file, const Environment& environment,
                       const std::filesystem::path& out) {
  ManifestReading reading = check_manifest(file, environment, out);
  if (!reading.faults.empty()) throw Faults(std::move(reading.faults));
  return std::move(reading.manifest);
}

}  // namespace mien::pipeline
