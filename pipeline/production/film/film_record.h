#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "render/image/luminance.h"
#include "render/video/sound_file.h"
#include "render/video/video_check.h"

namespace mien::pipeline {

/// The sound of a video and the result of its check (render::check_sound).
struct VideoSoundRecord {
  std::string codec;  ///< "aac"
  int rate = 0;       ///< sample frames per second
  int channels = 0;
  std::int64_t frames = 0;  ///< sample frames
  std::string hash;         ///< of the sound that was encoded: XXH3-64, 16 hexadecimal digits
  std::optional<int> offset_frames;  ///< measured shift of the decoded sound; not set for silence
  double correlation = 0.0;          ///< of the decoded sound with the encoded one

  friend bool operator==(const VideoSoundRecord&, const VideoSoundRecord&) = default;
};

/// What is heard in a film: its source, and how it was fitted to the film (film_sound.h).
struct SoundRecord {
  std::string file;       ///< file name of the source
  std::string of;         ///< id of the stimulus that states it
  double offset_s = 0.0;  ///< time of the source at which the film begins
  double gain_db = 0.0;   ///< applied in all, including that of equalized loudness
  std::string length;     ///< "error", "cut" or "hold"
  double source_s = 0.0;  ///< duration of the source
  int channels = 0;
  int held_frames = 0;                   ///< by which the film's last picture is shown longer
  double cut_s = 0.0;                    ///< by which the sound was cut at its end
  double silence_s = 0.0;                ///< silence after the sound until the film ends
  std::optional<double> loudness_lufs;   ///< integrated; not set if it cannot be measured
  std::optional<double> true_peak_dbtp;  ///< not set for silence

  friend bool operator==(const SoundRecord&, const SoundRecord&) = default;
};

/// One video of a film and the result of its check.
struct VideoRecord {
  std::string file;    ///< "videos/walk.webm"
  std::string format;  ///< "webm"
  int frames = 0;      ///< number of frames of the whole video
  double fps = 0.0;
  double duration_s = 0.0;
  /// Every decoded frame equals the encoded one. The members below are then not set.
  bool identical = false;
  double worst_psnr_db = 0.0;
  int worst_psnr_frame = 0;
  double worst_ssim = 0.0;
  int worst_ssim_frame = 0;
  std::optional<VideoSoundRecord> sound = {};
  /// Of all frames that were encoded, with those around the film. Empty in records of versions up
  /// to 0.3, which do not have it.
  std::string frames_hash = {};

  friend bool operator==(const VideoRecord&, const VideoRecord&) = default;
};

/// The facts recorded once a film has been rendered.
struct FilmRecord {
  /// Measured on all frames of the film, without the presentation; if neither frames nor videos are
  /// written, only on those of the contact sheet.
  render::ClipLuminance luminance;
  double exposure_stops = 0.0;  ///< exposure added by equalization, in stops
  double figure_px = 0.0;       ///< height of the standing figure in pixels (figure_pixels)
  std::optional<std::array<double, 2>> figure_place;  ///< position in the picture (figure_place)
  std::optional<double> visual_degrees;  ///< visual angle of the figure's height on the screen that
                                         ///< the camera names, in degrees
  int film_frames = 0;
  int first_film_frame = 0;  ///< index of the film's first frame in the videos
  std::vector<VideoRecord> videos;
  std::optional<SoundRecord> sound;
  /// Warnings about the figures, such as parts of a character that are not shown.
  std::vector<std::string> warnings;
};

VideoRecord video_record(const std::string& file, render::VideoKind kind, double fps,
                         const render::VideoCheck& check);

VideoSoundRecord video_sound_record(const render::SoundCheck& check);

/// Returns the video's entry in the record of a film.
nlohmann::ordered_json video_json(const VideoRecord& video);

/// Reads such an entry. Throws nlohmann::json::exception if it is malformed.
VideoRecord video_record_of(const nlohmann::json& json);

std::string film_record_text(const FilmRecord& record);

/// Reads a film's record. Throws std::runtime_error if the text is malformed.
FilmRecord parse_film_record(const std::string& json);

}  // namespace mien::pipeline
