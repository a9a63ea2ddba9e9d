#include "pipeline/manifest/checks/checked_manifest.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/modification_checks.h"
#include "pipeline/manifest/checks/name_checks.h"
#include "pipeline/manifest/checks/source_checks.h"
#include "pipeline/manifest/checks/study_record.h"
#include "pipeline/manifest/checks/vocabulary.h"

namespace mien::pipeline {

namespace {

/// Faults of the examples' files, unless the manifest's own part about them is at fault already:
/// one mistake is told once. What has no line of its own, as a folder, is told where it is named.
void add_faults_of_examples(std::vector<Fault>& faults, const Error& error, const Places& places) {
  const auto is_about_examples = [](const Fault& fault) {
    return fault.path.starts_with("examples");
  };
  if (std::any_of(faults.begin(), faults.end(), is_about_examples)) return;
  if (const auto* several = dynamic_cast<const Faults*>(&error)) {
    faults.insert(faults.end(), several->list().begin(), several->list().end());
  } else if (error.place().line > 0) {
    faults.push_back({{}, "", error.what(), ""});
  } else {
    faults.push_back({place_of(places, "examples.set"), "examples.set", error.what(), ""});
  }
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
                              "there is no " + needed.string() + ", which it rests on",
                              "keep the folder inputs beside it"});
  }
  if (!reading.faults.empty()) return reading;
  reading = read_manifest(record.as_run, environment);
  reading.manifest.file = record.manifest;
  reading.manifest.command = record.command;
  return reading;
}

/// What of it is known although something is wrong with the examples, which is added to the faults.
Vocabulary known_vocabulary(ManifestReading& reading) {
  const ScalesSource& scales = reading.manifest.scales;
  const bool has_scales = scales.file.empty() || !scales.set.scales.empty();  // else as was told
  try {
    if (has_scales) return vocabulary_of(reading.manifest);
  } catch (const Error& error) {
    add_faults_of_examples(reading.faults, error, reading.manifest.places);
  }
  return certain_vocabulary(reading.manifest);
}

/// The reading with what names of examples and parameters are at fault.
ManifestReading checked(ManifestReading reading, const std::filesystem::path& out) {
  if (!out.empty() && !reading.manifest.study.empty())
    append(reading.faults, check_sources(reading.manifest, out / reading.manifest.study));
  const Vocabulary vocabulary = known_vocabulary(reading);
  append(reading.faults, check_names(reading.manifest, vocabulary));
  append(reading.faults, check_modification_names(reading.manifest, vocabulary));
  reading.faults = in_reading_order(std::move(reading.faults));
  return reading;
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
