#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>

#include "pipeline/film/film.h"
#include "render/scene/quality.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// A shot to be shown in one file, without plan and store.
struct ShotWork {
  const scenes::Shot& shot;
  const FilmSettings& settings;
  std::stop_token stop;
  std::function<void(double)> progress;  ///< told the share that is done
};

/// All its frames as the first kind of video of the settings, checked. Returns what the check
/// found.
std::string write_video(const ShotWork& work, const std::filesystem::path& file);

/// Frames spread over it, side by side (PNG). Returns how many.
std::string write_contact_sheet(const ShotWork& work, const std::filesystem::path& file);

/// One frame: .png, with alpha where the background does not show; or .exr, with its layers.
void write_still(const ShotWork& work, int frame, render::Background background,
                 const std::filesystem::path& file);

/// A file of that name in a folder of its own beside the one that is wanted, removed unless it
/// takes its place.
class DraftFile {
 public:
  explicit DraftFile(std::filesystem::path target);
  ~DraftFile();
  DraftFile(const DraftFile&) = delete;
  DraftFile& operator=(const DraftFile&) = delete;

  /// Where to write.
  const std::filesystem::path& file() const { return file_; }

  /// A message about it as one about the file that is wanted.
  std::string told(std::string message) const;

  /// Puts it in the place of the one that is wanted, whole.
  void publish() const;

 private:
  std::filesystem::path target_;
  std::filesystem::path folder_;
  std::filesystem::path file_;
};

}  // namespace mien::pipeline
