#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/environment.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/checks/vocabulary.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/study/studio/seen_files.h"

namespace mien::pipeline {

/// Thrown for an invalid document or request from a page; the page displays the faults.
class DraftFaults : public std::exception {
 public:
  explicit DraftFaults(std::vector<Fault> faults) : faults_(std::move(faults)) {}

  const std::vector<Fault>& list() const { return faults_; }
  const char* what() const noexcept override { return "the draft is invalid"; }

 private:
  std::vector<Fault> faults_;
};

/// Faults as [{"path": …, "wrong": …, "remedy": …}].
nlohmann::ordered_json faults_json(const std::vector<Fault>& faults);

/// Reads documents sent by a page, with the same checks as for manifests. Thread-safe.
///
/// Every document must first pass `check_files`.
class DraftReader {
 public:
  DraftReader(std::filesystem::path file, Environment environment)
      : file_(std::move(file)), environment_(std::move(environment)) {}

  /// Checks the file names in a document. Permitted are those in the manifest as opened or last
  /// saved (`known`), and motions, folders and characters in the permitted folders
  /// (studio_places.h). Opens no file. Throws DraftFaults.
  void check_files(const nlohmann::ordered_json& document,
                   const nlohmann::ordered_json& known) const;

  /// The manifest of a document that has passed check_files. Throws DraftFaults.
  Manifest read(const nlohmann::ordered_json& document);

  /// Reads the manifest without its stimuli, which are replaced by a placeholder. Throws
  /// DraftFaults.
  Manifest read_examples(const nlohmann::ordered_json& document);

 private:
  ManifestReading reading_of(const nlohmann::ordered_json& document) const;
  Vocabulary vocabulary(const std::string& key, const Manifest& manifest);

  std::filesystem::path file_;
  Environment environment_;
  std::mutex mutex_;
  std::map<std::string, std::pair<Vocabulary, SeenFiles>> vocabularies_;  ///< by examples_key
};

/// A cache key: the parts of a document that determine the examples and their ratings.
std::string examples_key(const nlohmann::ordered_json& document);

/// The parts of a document that determine the motions and films of the stimuli `ids`, without
/// sounds, levels, sheets, overlays, experiments, equalization and design. Stimuli on which these
/// stimuli depend are included: all stimuli if one of `ids` is a foil or has a `swap`, and the
/// reference stimuli if one of `ids` has a `hold`. Stimuli that are not needed are replaced by
/// placeholders, so that indices are preserved; those after the last needed stimulus are omitted.
nlohmann::ordered_json document_excerpt(const nlohmann::ordered_json& document,
                                        const std::vector<std::string>& ids);

}  // namespace mien::pipeline
