#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/temporary_folder.h"

namespace mien::test {

/// A fresh copy of a finished study in a folder that is removed with the object. It has frames as
/// PNG of film a (9 frames) and as EXR of film d, an MP4 with a fade and a blank of film b, a
/// lossless one and a WebP of film c, equalized luminance, an overlay and an input of its own.
class MadeStudy {
 public:
  MadeStudy();

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path operator/(const std::string& path) const { return folder_ / path; }
  std::filesystem::path beside(const std::string& name) const { return temporary_.path() / name; }

  /// Turns the study into a copy received from elsewhere, without the store's internal files.
  void forget_receipts() const;

  /// Changes provenance.json and updates its hashes.
  void forge(const std::function<void(nlohmann::ordered_json&)>& change) const;

  /// Replaces an artifact's bytes, and its hash and size in the provenance.
  void forge_artifact(const std::string& path, const std::string& bytes) const;

 private:
  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_.path() / "tiny";
};

}  // namespace mien::test
