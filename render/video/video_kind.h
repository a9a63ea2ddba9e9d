#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

namespace mien::render {

/// Containers and codecs that a film can be written as.
enum class VideoKind { mp4, mp4_lossless, webm, webm_av1, mkv, webp, gif, apng };

/// Properties of a kind. Least similarities apply to the worst decoded frame, compared with the
/// frame that was written.
struct VideoTraits {
  VideoKind kind;
  std::string_view name;         ///< name in manifests: "mp4-lossless"
  std::string_view ending;       ///< ending of file names: ".lossless.mp4"; differs for each kind
  std::string_view description;  ///< "H.264 in MP4, lossless RGB"
  std::string_view codec;        ///< as FFmpeg names it: "h264"
  bool even_size = false;        ///< width and height must be even
  bool lossless = false;         ///< decodes to exactly the frames written
  bool picture = false;          ///< an animated image, which stores a number of repetitions
  /// Highest frame rate that players show at true speed, frames per second. (In animated images,
  /// browsers show pictures with a stored duration of 10 ms or less for 100 ms.)
  double most_fps = 240.0;
  double least_psnr_db = 0.0;  ///< least value of the worst frame to pass the check; lossy kinds
  double least_ssim = 0.0;     ///< least value of the worst frame to pass the check; lossy kinds
};

/// All kinds, in the order of the enumeration.
std::span<const VideoTraits> video_kinds();

const VideoTraits& traits_of(VideoKind kind);

/// The codec of the sound in videos of a kind, as FFmpeg names it: "aac" in MP4, "opus" in WebM and
/// Matroska; empty for animated pictures, which have no sound.
std::string_view sound_codec_of(VideoKind kind);

/// The kind of a file by the longest matching ending of its name: "x.lossless.mp4" is mp4_lossless,
/// "x.mp4" is mp4; "x.png" is none.
std::optional<VideoKind> video_kind_of(const std::filesystem::path& file);

/// The path `stem` with the ending of a kind appended.
std::filesystem::path with_ending(std::filesystem::path stem, VideoKind kind);

}  // namespace mien::render
