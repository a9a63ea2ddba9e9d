#include "pipeline/manifest/checks/checked_manifest.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/document_checks.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/checks/vocabulary.h"

namespace mien::pipeline {

namespace {

/// Faults of the examples' files. What has no line of its own, as a folder, is reported where it is
/// named.
std::vector<Fault> faults_of_examples(const Error& error, const Places& places) {
  if (const auto* several = dynamic_cast<const Faults*>(&error)) return several->list();
  if (error.place().line > 0) return {{{}, "", error.what(), ""}};
  return {{place_of(places, "examples.set"), "examples.set", error.what(), ""}};
}

/// A study is made again under the name of the manifest that it was made from, so that it comes out
/// the same to the last byte.
ManifestReading read_again(const StudyRecord& record, const std::filesystem::path& file,
                           const Environment& environment) {
  ManifestReading reading;
  for (const std::filesystem::path& needed : {record.as_run, record.manifest}) {
    std::error_code unknown;
    if (std::filesystem::is_regular_file(needed, unknown)) continue;
    reading.faults.push_back({{file.string(), 0, 0},
                              "",
                              "there is no " + needed.string() + ", which it depends on",
                              "keep the folder inputs beside it"});
  }
  if (!reading.faults.empty()) return reading;
  reading = read_manifest(record.as_run, environment);
  reading.manifest.file = record.manifest;
  reading.manifest.command = record.command;
  // The copy must not be edited: its hash is recorded.
  reading.manifest.renamed.clear();
  return reading;
}

/// The known names, and the faults of the examples, if any.
struct KnownVocabulary {
  Vocabulary vocabulary;
  std::vector<Fault> faults;  ///< of the examples
};

KnownVocabulary known_vocabulary(const Manifest& manifest) {
  const ScalesSource& scales = manifest.scales;
  const bool has_scales =
      scales.file.empty() || !scales.set.scales.empty();  // else already reported
  if (!has_scales) return {certain_vocabulary(manifest), {}};
  try {
    return {vocabulary_of(manifest), {}};
  } catch (const Error& error) {
    return {certain_vocabulary(manifest), faults_of_examples(error, manifest.places)};
  }
}

bool is_about_examples(const Fault& fault) { return fault.path.starts_with("examples"); }

/// The reading with what names of examples and parameters are at fault. Faults of the examples'
/// files are reported unless the manifest's own part about them is at fault already.
ManifestReading checked(ManifestReading reading, const std::filesystem::path& out) {
  const Manifest& manifest = reading.manifest;
  std::vector<Fault> faults = std::move(reading.faults);
  if (!out.empty() && !manifest.study.empty())
    append(faults, check_sources(manifest, out / manifest.study));
  KnownVocabulary known = known_vocabulary(manifest);
  if (std::ranges::none_of(faults, is_about_examples)) append(faults, std::move(known.faults));
  append(faults, check_names(manifest, known.vocabulary));
  append(faults, check_modification_names(manifest, known.vocabulary));
  return {std::move(reading.manifest), in_reading_order(std::move(faults))};
}

}  // namespace

ManifestReading check_manifest(const std::filesystem::path& file, const Environment& environment,
                               const std::filesystem::path& out) {
  const std::optional<StudyRecord> record = study_record_in(file);
  ManifestReading reading =
      record ? read_again(*record, file, environment) : read_manifest(file, environment);
  if (record && reading.manifest.study.empty()) return reading;
  return checked(std::move(reading), out);
}

ManifestReading check_manifest_text(std::string_view text, const std::filesystem::path& file,
                                    const Environment& environment,
                                    const std::filesystem::path& out) {
  return checked(parse_manifest(text, file, environment), out);
}

Manifest load_manifest(const std::filesystem::path& file, const Environment& environment,
                       const std::filesystem::path& out) {
  ManifestReading reading = check_manifest(file, environment, out);
  if (!reading.faults.empty()) throw Faults(std::move(reading.faults));
  return std::move(reading.manifest);
}

}  // namespace mien::pipeline
