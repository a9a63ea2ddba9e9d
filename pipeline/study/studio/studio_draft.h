#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/environment.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/checks/vocabulary.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// What a page asks for is wrong; the page shows the list.
class DraftFaults : public std::exception {
 public:
  explicit DraftFaults(std::vector<Fault> faults) : faults_(std::move(faults)) {}

  const std::vector<Fault>& list() const { return faults_; }
  const char* what() const noexcept override { return "the draft is invalid"; }

 private:
  std::vector<Fault> faults_;
};

/// [{"path": …, "wrong": …, "remedy": …}]
nlohmann::ordered_json faults_json(const std::vector<Fault>& faults);

/// Reads what a page would have made, by all rules of manifests. For several threads.
///
/// Documents come to it through one door, `admit`, whatever is to be done with them.
class DraftReader {
 public:
  DraftReader(std::filesystem::path file, Environment environment)
      : file_(std::move(file)), environment_(std::move(environment)) {}

  /// A page names no file but those that the manifest names as it was opened or saved (`known`),
  /// and motions, folders and characters in its places (studio_places.h). Opens none. Throws
  /// DraftFaults.
  void admit(const nlohmann::ordered_json& document, const nlohmann::ordered_json& known) const;

  /// The manifest of a document that was admitted. Throws DraftFaults.
  Manifest read(const nlohmann::ordered_json& document);

  /// Likewise, but for the stimuli, in whose place stands one that is not to be made.
  Manifest read_examples(const nlohmann::ordered_json& document);

 private:
  ManifestReading reading_of(const nlohmann::ordered_json& document) const;
  Vocabulary vocabulary(const std::string& key, const Manifest& manifest);

  std::filesystem::path file_;
  Environment environment_;
  std::mutex mutex_;
  std::map<std::string, Vocabulary> vocabularies_;  ///< by what tells the examples
};

/// Of a document, what tells which examples there are and what is thought of them.
std::string examples_key(const nlohmann::ordered_json& document);

/// Only what motions and films of those stimuli are made of: no sheets, overlays or questionnaire.
/// Stimuli whose motion is made from another's come with it: what a foil is of, and the references
/// where a hold keeps the others. All keep their places; other stimuli stand in between.
nlohmann::ordered_json document_about(const nlohmann::ordered_json& document,
                                      const std::vector<std::string>& ids);

}  // namespace mien::pipeline
