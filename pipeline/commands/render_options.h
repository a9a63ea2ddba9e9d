#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/film/film.h"
#include "pipeline/look/look.h"
#include "pipeline/look/look_options.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// What the command line of `mien render` says.
struct RenderOptions {
  std::vector<std::string> files;
  std::string out;
  std::string layout = "superimposed";
  std::string size = "960x540";
  double scale = 1.0;
  std::vector<int> crop;
  std::string quality = "standard";
  std::string background = "shown";
  double shutter = 0.0;
  LookOptions look;
  std::string dots;
  std::optional<std::string> still;  ///< seconds, or "middle"
  std::uint64_t seed = 0;
  double fps = 30.0;
  int jobs = 0;
  bool repeat = false;
  bool in_place = false;
};

/// How the film is drawn. Throws Error for a size or crop that is none.
FilmSettings settings_of(const RenderOptions& options);

scenes::Layout layout_of(const RenderOptions& options);

/// The file to make; its ending says what. Throws Error for one that says nothing.
std::filesystem::path output_of(const RenderOptions& options);

/// Whether a file is a picture, not a video.
bool is_picture(const std::filesystem::path& out);

/// ".mp4, .lossless.mp4, …"
std::string video_endings();

/// Throws Error for a size or rate that the file cannot have.
void check_size(const std::filesystem::path& out, const Output& output);

/// Throws Error for what a picture of that kind cannot show; a manifest's output may not ask for it
/// either.
void check_kind(const RenderOptions& options, const Look& look, const std::filesystem::path& out,
                bool is_still);

}  // namespace mien::pipeline
