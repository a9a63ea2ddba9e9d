#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>

#include "pipeline/production/film/film.h"
#include "render/scene/quality.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// A shot to be shown in one file, without plan and store.
struct ShotWork {
  const scenes::Shot& shot;
  const FilmSettings& settings;
  std::stop_token stop;
  std::function<void(double)> progress;  ///< called with the share that is done
};

/// All its frames as the first kind of video of the settings, checked. Returns what the check
/// found.
std::string write_video(const ShotWork& work, const std::filesystem::path& file);

/// Frames spread over it, side by side (PNG). Returns how many.
std::string write_contact_sheet(const ShotWork& work, const std::filesystem::path& file);

/// One frame: .png, with alpha where the background does not show; or .exr, with its layers.
void write_still(const ShotWork& work, int frame, render::Background background,
                 const std::filesystem::path& file);

}  // namespace mien::pipeline
