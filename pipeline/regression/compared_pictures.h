#pragma once

#include <filesystem>
#include <string>

#include "render/compare/pixel_map.h"
#include "render/image/image.h"

namespace mien::pipeline {

/// The folder of the pictures shown in a report; it is created if necessary.
///
///     <id>-00012-before.png, <id>-00012-now.png, <id>-00012-flip.png
class ComparedPictures {
 public:
  explicit ComparedPictures(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path before(const std::string& id, int frame) const;
  std::filesystem::path now(const std::string& id, int frame) const;
  std::filesystem::path flip(const std::string& id, int frame) const;

  /// Writes both pictures and the ꟻLIP map. There is no map for pictures that differ in size.
  /// Throws render::Error and WriteFailure.
  void put(const std::string& id, int frame, const render::Image8& before,
           const render::Image8& now, const render::PixelMap& error) const;
  void put_before(const std::string& id, int frame, const render::Image8& picture) const;
  void put_now(const std::string& id, int frame, const render::Image8& picture) const;

 private:
  std::filesystem::path file(const std::string& id, int frame, const char* what) const;

  std::filesystem::path folder_;
};

}  // namespace mien::pipeline
