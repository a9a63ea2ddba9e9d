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
  std::string version;              ///< hash of the file's text; empty if there is no file
  nlohmann::ordered_json document;  ///< the parsed text
};

/// The result of saving.
struct SaveResult {
  enum class Outcome {
    saved,
    unchanged,  ///< the file already had this text
    elsewhere   ///< the file was changed by another program in the meantime; nothing was written
  };

  Outcome outcome = Outcome::saved;
  ManifestState state;  ///< state of the file after saving
};

/// A manifest file being edited. Thread-safe.
class ManifestFile {
 public:
  /// Opens a file. If `begun_from` is given, begins a new manifest with that text instead; its file
  /// is created when it is first saved. Throws Faults for a manifest that `mien check` refuses.
  ManifestFile(std::filesystem::path file, Environment environment,
               std::optional<std::string> begun_from = std::nullopt);

  const std::filesystem::path& file() const { return file_; }
  const Environment& environment() const { return environment_; }

  /// The manifest as last read or saved.
  ManifestState state() const;

  /// Whether the manifest was read from the file or has been saved to it.
  bool is_on_disk() const;

  /// Replaces the file's text atomically. The parsed text must equal `document`. `version` is the
  /// version that was edited; if the file has another version now, nothing is written. Throws
  /// Faults for a manifest that `mien check` refuses, Error if the text differs from `document`,
  /// and WriteFailure; the file is unchanged in these cases.
  SaveResult save(const std::string& text, const nlohmann::ordered_json& document,
                  const std::string& version);

  /// Reads the file again. Throws Error if it cannot be read, and Faults if `mien check`
  /// refuses the manifest.
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
