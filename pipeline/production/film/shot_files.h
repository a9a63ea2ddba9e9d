#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>

#include "pipeline/production/film/film.h"
#include "render/scene/quality.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// A shot to be written to one file, without a task graph or store.
struct ShotWork {
  const scenes::Shot& shot;
  const FilmSettings& settings;
  std::stop_token stop;
  std::function<void(double)> progress;  ///< called with the completed share, 0 … 1
};

/// Writes all frames as a video in the first format of the settings, and checks it. Returns the
/// result of the check as text.
std::string write_video(const ShotWork& work, const std::filesystem::path& file);

/// Writes evenly spaced frames into one picture (PNG). Returns their number as text: "12 on a
/// sheet".
std::string write_contact_sheet(const ShotWork& work, const std::filesystem::path& file);

/// Writes one frame: as .png, with alpha unless `background` is `shown`, or as .exr with its
/// layers.
void write_still(const ShotWork& work, int frame, render::Background background,
                 const std::filesystem::path& file);

}  // namespace mien::pipeline
