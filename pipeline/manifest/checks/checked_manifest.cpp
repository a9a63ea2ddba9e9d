#include "pipeline/manifest/checks/checked_manifest.h"

#include <algorithm>
#include <map>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/document_checks.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/checks/vocabulary.h"
#include "pipeline/manifest/named_motions.h"
#include "pipeline/manifest/packed_recordings.h"
#include "pipeline/manifest/reading/levelled_document.h"

namespace mien::pipeline {

namespace {

/// Faults of the examples' files. What has no line of its own, as a folder, is reported where it is
/// named.
std::vector<Fault> faults_of_examples(const Error& error, const Places& places) {
  if (const auto* several = dynamic_cast<const Faults*>(&error)) return several->list();
  if (error.place().line > 0) return {{{}, "", error.what(), ""}};
  return {{place_of(places, "examples.set"), "examples.set", error.what(), ""}};
}

/// Files of a study's recordings that are named by its manifest and do not exist, by the names that
/// its provenance gives them.
std::map<std::string, std::filesystem::path> absent_files(const StudyRecord& record,
                                                          const Manifest& manifest) {
  std::map<std::string, std::filesystem::path> absent;
  std::error_code unknown;
  const std::filesystem::path& folder = manifest.examples.folder;
  if (!folder.empty() && manifest.examples.builtin.empty()) {
    for (const RecordedInput& recording : record.recordings) {
      const std::filesystem::path name(recording.name);
      const std::filesystem::path file = folder / name.filename();
      if (name.parent_path() == folder.filename() && !std::filesystem::exists(file, unknown))
        absent[recording.name] = file;
    }
  }
  for (const Stimulus& stimulus : manifest.stimuli) {
    for (const NamedMotion& motion : named_motions(stimulus)) {
      if (std::filesystem::exists(motion.file, unknown)) continue;
      const std::filesystem::path around = motion.file.parent_path().filename();
      absent[(around / motion.file.filename()).generic_string()] = motion.file;
    }
  }
  return absent;
}

/// A fault for each recording of a study that is missing, with what its provenance says about it.
std::vector<Fault> missing_recordings(const StudyRecord& record, const Manifest& manifest,
                                      const std::filesystem::path& provenance) {
  std::vector<Fault> faults;
  const auto absent = absent_files(record, manifest);
  for (const RecordedInput& recording : record.recordings) {
    const auto file = absent.find(recording.name);
    if (file == absent.end()) continue;
    std::string wrong = "the recording " + motion::in_quotes(recording.name) + " (hash " +
                        motion::printable(recording.hash);
    if (!recording.licence.empty()) wrong += ", licence " + motion::in_quotes(recording.licence);
    wrong += recording.share ? ") is missing" : ", not to be shared) is missing";
    const std::string place = motion::printable(file->second.string());
    faults.push_back(
        {{provenance.string(), 0, 0},
         "",
         wrong,
         recording.source.empty()
             ? "save it as " + place
             : "get it from " + motion::printable(recording.source) + " and save it as " + place});
  }
  return faults;
}

/// Where in an unpacked archive a recording is, or is expected if it was left out; empty if the
/// text names none.
std::filesystem::path place_in_archive(const StudyRecord& record, const PackedRecordings& packed,
                                       const std::filesystem::path& folder,
                                       const std::string& text) {
  std::filesystem::path place = packed_place(packed, folder, text);
  if (!place.empty() || packed.empty()) return place;
  const std::filesystem::path named(text);
  const std::filesystem::path file = named.parent_path().filename() / named.filename();
  for (const RecordedInput& recording : record.recordings) {
    const std::filesystem::path name(recording.name);
    if (name == file) return folder / packed_recordings_folder / name;
    if (name.parent_path() == named.filename())
      return folder / packed_recordings_folder / named.filename();
  }
  return {};
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
  const std::filesystem::path folder = file.parent_path();
  const PackedRecordings packed = packed_recordings_in(folder);
  reading = read_manifest(record.as_run, environment, [&](const std::string& text, auto& path) {
    std::error_code unknown;
    std::filesystem::path place = place_in_archive(record, packed, folder, text);
    if (place.empty()) return;
    if (std::filesystem::exists(place, unknown) || !std::filesystem::exists(path, unknown))
      path = std::move(place);
  });
  std::vector<Fault> missing = missing_recordings(record, reading.manifest, file);
  if (!missing.empty()) return {{}, std::move(missing)};
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
  std::vector<Fault> names = check_names(manifest, known.vocabulary);
  append(names, check_modification_names(manifest, known.vocabulary));
  append(faults, with_written_paths(std::move(names), manifest.origins));
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
