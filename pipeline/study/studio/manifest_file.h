#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/environment.h"

namespace mien::pipeline {

/// A manifest's text and its parsed document.
struct ManifestState {
  std::string text;
  std::string version;  ///< digest of the file's text; empty without a file
  nlohmann::ordered_json document;
};

/// The result of saving.
struct SaveResult {
  enum class Outcome {
    saved,
    unchanged,  ///< there was nothing to write
    elsewhere  ///< the file was changed by another program since it was opened; nothing was written
  };

  Outcome outcome = Outcome::saved;
  ManifestState state;  ///< of the file afterwards
};

/// A manifest file being edited. Thread-safe.
class ManifestFile {
 public:
  /// Opens a file. With `begun_from`, a new manifest with that text, whose file is created when it
  /// is first saved. Throws Faults for a manifest that `mien check` refuses.
  ManifestFile(std::filesystem::path file, Environment environment,
               std::optional<std::string> begun_from = std::nullopt);

  const std::filesystem::path& file() const { return file_; }
  const Environment& environment() const { return environment_; }

  /// The manifest as last read or saved.
  ManifestState state() const;

  /// Whether the file exists.
  bool is_on_disk() const;

  /// Replaces the file's text atomically. `document` is the content that the text must have,
  /// `version` the version of the file that was edited; when the file has another version, nothing
  /// is written. Throws Faults for a manifest that `mien check` refuses, Error for a text whose
  /// content is not `document`, and WriteFailure; nothing is written then.
  SaveResult save(const std::string& text, const nlohmann::ordered_json& document,
                  const std::string& version);

  /// Reads the file again. Throws Faults for a manifest that `mien check` refuses.
  ManifestState reload();

 private:
  ManifestState state_of(std::string text, bool is_on_disk = true) const;
  std::optional<std::string> text_on_disk() const;
  void write(const std::string& text) const;

  std::filesystem::path file_;
  Environment environment_;
  mutable std::mutex mutex_;
  ManifestState state_;
  bool is_on_disk_ = true;
};

}  // namespace mien::pipeline
