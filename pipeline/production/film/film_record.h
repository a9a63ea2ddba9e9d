#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "render/image/luminance.h"
#include "render/video/video_check.h"

namespace mien::pipeline {

/// One video of a film and what its check found.
struct VideoRecord {
  std::string file;    ///< "videos/walk.webm"
  std::string format;  ///< "webm"
  int frames = 0;      ///< of the whole video
  double fps = 0.0;
  double duration_s = 0.0;
  bool identical = false;  ///< every frame is the frame drawn; then the rest says nothing
  double worst_psnr_db = 0.0;
  int worst_psnr_frame = 0;
  double worst_ssim = 0.0;
  int worst_ssim_frame = 0;

  friend bool operator==(const VideoRecord&, const VideoRecord&) = default;
};

/// What is known of a film when it has been drawn.
struct FilmRecord {
  render::ClipLuminance luminance;  ///< of the film's frames, without what is shown around them
  double exposure_stops = 0.0;      ///< that were added
  double figure_px = 0.0;           ///< height of the standing figure (figure_pixels)
  std::optional<std::array<double, 2>> figure_place;  ///< in the picture (figure_place)
  std::optional<double> visual_degrees;               ///< of it on the screen that the camera names
  int film_frames = 0;
  int first_film_frame = 0;  ///< in the videos
  std::vector<VideoRecord> videos;
  std::vector<std::string> warnings;  ///< of the figures: what of a character is not shown, say
};

VideoRecord video_record(const std::string& file, render::VideoKind kind, double fps,
                         const render::VideoCheck& check);

/// The video's entry in the record of a film.
nlohmann::ordered_json video_json(const VideoRecord& video);

/// Throws nlohmann::json::exception when it is none.
VideoRecord video_record_of(const nlohmann::json& json);

std::string film_record_text(const FilmRecord& record);

/// Throws std::runtime_error when the text is no such record.
FilmRecord parse_film_record(const std::string& json);

}  // namespace mien::pipeline
