#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/environment.h"

namespace mien::pipeline {

/// A manifest as it was read: its text, and what it says.
struct ManifestState {
  std::string text;
  std::string version;  ///< of the file: a digest of its text; empty where there is no file
  nlohmann::ordered_json document;
};

/// What a wish to save comes to.
struct Saving {
  enum class Outcome {
    saved,
    unchanged,  ///< there was nothing to write
    elsewhere   ///< the file has been changed since it was opened; nothing was written
  };

  Outcome outcome = Outcome::saved;
  ManifestState state;  ///< of the file now
};

/// A manifest that is opened to be edited. For several threads.
class ManifestFile {
 public:
  /// Opens a file. With `begun_from`, the file is not there yet and begins with that text: it is
  /// made when it is saved first. Throws Faults for what `mien check` refuses.
  ManifestFile(std::filesystem::path file, Environment environment,
               std::optional<std::string> begun_from = std::nullopt);

  const std::filesystem::path& file() const { return file_; }
  const Environment& environment() const { return environment_; }

  /// As it was opened, or saved last.
  ManifestState state() const;

  /// Whether there is a file of it.
  bool is_on_disk() const;

  /// Writes a text at once: a reader sees the old one or the new one. `document` is what it is
  /// meant to say, `version` that of the file it was made from; where that is another by now,
  /// nothing is written. Throws Faults for what `mien check` would refuse, Error for a text that
  /// says something else, and WriteFailure; nothing is written then.
  Saving save(const std::string& text, const nlohmann::ordered_json& document,
              const std::string& version);

  /// What is in the file now. Throws Faults for what `mien check` refuses.
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
