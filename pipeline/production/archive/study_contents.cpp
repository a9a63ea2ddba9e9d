#include "pipeline/production/archive/study_contents.h"

#include <algorithm>
#include <stdexcept>
#include <system_error>

#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/json_depth.h"
#include "motion/text/safe_name.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Throws for what would lead out of the study's folder.
std::string safe_path(const std::string& path) {
  const std::string fault = motion::fault_of_relative(path);
  if (fault.empty()) return path;
  throw std::runtime_error("names " + motion::in_quotes(path) + ", a path that " + fault);
}

ArtifactRecord artifact_of(const std::string& path, const json& entry) {
  return {safe_path(path), entry.at("hash"), entry.at("size"), entry.value("frames", 0),
          entry.value("not_shared", std::vector<std::string>())};
}

void take(const json& record, StudyContents& contents) {
  contents.study = record.at("study");
  if (const std::string fault = motion::fault_of_name(contents.study); !fault.empty())
    throw std::runtime_error("calls the study " + motion::in_quotes(contents.study) +
                             ", a name that " + fault);
  contents.program = record.at("mien");
  contents.command = record.value("command", "");
  contents.seed = record.at("seed");
  contents.as_run = safe_path(record.at("manifest").at("as_run"));
  for (const auto& [path, entry] : record.at("artifacts").items())
    contents.artifacts.push_back(artifact_of(path, entry));
  for (const auto& [path, hash] : record.at("inputs").items()) {
    if (path.starts_with("inputs/")) {
      contents.inputs.push_back({safe_path(path), hash.get<std::string>(), 0, 0});
    } else {
      ++contents.inputs_elsewhere;
    }
  }
  for (const json& entry : record.value("recordings", json::array()))
    contents.recordings.push_back({safe_path(entry.at("path")), entry.at("hash"),
                                   entry.value("licence", ""), entry.value("share", true)});
  std::ranges::sort(contents.recordings, {}, &RecordingRecord::path);
  std::ranges::sort(contents.artifacts, {}, &ArtifactRecord::path);
  std::ranges::sort(contents.inputs, {}, &ArtifactRecord::path);
}

}  // namespace

const ArtifactRecord* StudyContents::find(const std::string& path) const {
  const auto found = std::ranges::lower_bound(artifacts, path, {}, &ArtifactRecord::path);
  return found != artifacts.end() && found->path == path ? &*found : nullptr;
}

const RecordingRecord* StudyContents::find_recording(const std::string& path) const {
  const auto found = std::ranges::lower_bound(recordings, path, {}, &RecordingRecord::path);
  return found != recordings.end() && found->path == path ? &*found : nullptr;
}

fs::path study_folder_of(const fs::path& study) {
  std::error_code unknown;
  if (study.filename() == "provenance.json")
    return study.has_parent_path() ? study.parent_path() : fs::path(".");
  if (fs::is_regular_file(study / "bagit.txt", unknown) &&
      fs::is_directory(study / "data", unknown))
    return study / "data";
  return study;
}

StudyContents contents_of(const fs::path& study) {
  StudyContents contents;
  contents.folder = study_folder_of(study);
  std::error_code unknown;
  if (fs::is_regular_file(contents.folder, unknown)) {
    throw Error(
        {study.string()}, "is a file, not the folder of a study",
        "unpack archives of mien pack first, for example with tar -xf, and name the folder");
  }
  if (!fs::is_directory(contents.folder, unknown)) {
    throw Error({study.string()}, "there is no such study",
                "name the folder of a study (out/my-study), or its provenance.json");
  }
  const fs::path file = contents.provenance();
  const motion::FileReading text = motion::bytes_of_file(file, motion::max_table_bytes);
  if (!text.bytes) {
    throw Error({file.string()}, text.error,
                "mien run writes it when the whole study has been made");
  }
  const auto refuse = [&] {
    throw Error({file.string()}, "this is not the provenance of a study",
                "mien run writes it when the whole study has been made");
  };
  if (motion::is_nested_deeper(*text.bytes, motion::max_json_depth)) refuse();
  try {
    take(json::parse(*text.bytes), contents);
  } catch (const json::exception&) {
    refuse();
  } catch (const std::runtime_error& error) {
    throw Error({file.string()}, error.what(), "do not trust this study");
  }
  contents.packed = packed_recordings_in(contents.folder);
  for (const std::vector<std::string>* names :
       {&contents.packed.packed, &contents.packed.left_out}) {
    for (const std::string& name : *names)
      contents.inputs_elsewhere -= contents.find_recording(name) != nullptr ? 1 : 0;
  }
  return contents;
}

bool is_only_in_archive(const StudyContents& contents, const std::string& path) {
  if (path == packed_recordings_path || path == crate_path) return true;
  const std::string recordings = std::string(packed_recordings_folder) + "/";
  if (path.starts_with(recordings))
    return contents.find_recording(path.substr(recordings.size())) != nullptr;
  std::error_code unknown;
  return path.starts_with(std::string(bids_folder) + "/") &&
         fs::exists(contents.folder / crate_path, unknown);
}

bool is_bookkeeping(const std::string& path) {
  const std::string first = path.substr(0, path.find('/'));
  return first == ".mien" || first == "farm";
}

}  // namespace mien::pipeline
