#include "render/video/video_kind.h"

#include <string>

namespace mien::render {

namespace {

// The thresholds lie well below what rendered frames reach (about 42 dB and 0.98) and well above
// what wrong colours, frames of another moment or broken blocks leave. A GIF has 255 colours for a
// whole film, and its dither counts as noise.
constexpr VideoTraits kinds[] = {{.kind = VideoKind::mp4,
                                  .name = "mp4",
                                  .ending = ".mp4",
                                  .description = "H.264 in MP4",
                                  .codec = "h264",
                                  .even_size = true,
                                  .least_psnr_db = 30.0,
                                  .least_ssim = 0.88},
                                 {.kind = VideoKind::mp4_lossless,
                                  .name = "mp4-lossless",
                                  .ending = ".lossless.mp4",
                                  .description = "H.264 in MP4, lossless RGB",
                                  .codec = "h264",
                                  .lossless = true},
                                 {.kind = VideoKind::webm,
                                  .name = "webm",
                                  .ending = ".webm",
                                  .description = "VP9 in WebM",
                                  .codec = "vp9",
                                  .even_size = true,
                                  .least_psnr_db = 30.0,
                                  .least_ssim = 0.88},
                                 {.kind = VideoKind::webm_av1,
                                  .name = "webm-av1",
                                  .ending = ".av1.webm",
                                  .description = "AV1 in WebM",
                                  .codec = "av1",
                                  .even_size = true,
                                  .least_psnr_db = 30.0,
                                  .least_ssim = 0.88},
                                 {.kind = VideoKind::mkv,
                                  .name = "mkv",
                                  .ending = ".mkv",
                                  .description = "FFV1 in Matroska, lossless RGB",
                                  .codec = "ffv1",
                                  .lossless = true},
                                 {.kind = VideoKind::webp,
                                  .name = "webp",
                                  .ending = ".webp",
                                  .description = "animated WebP",
                                  .codec = "webp",
                                  .picture = true,
                                  .most_fps = 90.0,
                                  .least_psnr_db = 29.0,
                                  .least_ssim = 0.85},
                                 {.kind = VideoKind::gif,
                                  .name = "gif",
                                  .ending = ".gif",
                                  .description = "animated GIF",
                                  .codec = "gif",
                                  .picture = true,
                                  .most_fps = 50.0,
                                  .least_psnr_db = 22.0,
                                  .least_ssim = 0.5},
                                 {.kind = VideoKind::apng,
                                  .name = "apng",
                                  .ending = ".apng",
                                  .description = "animated PNG, lossless",
                                  .codec = "apng",
                                  .lossless = true,
                                  .picture = true,
                                  .most_fps = 90.0}};

}  // namespace

std::span<const VideoTraits> video_kinds() { return kinds; }

const VideoTraits& traits_of(VideoKind kind) { return kinds[static_cast<std::size_t>(kind)]; }

std::optional<VideoKind> video_kind_of(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  const VideoTraits* best = nullptr;
  for (const VideoTraits& traits : kinds) {
    if (!name.ends_with(traits.ending)) continue;
    if (!best || traits.ending.size() > best->ending.size()) best = &traits;
  }
  return best ? std::optional(best->kind) : std::nullopt;
}

std::filesystem::path with_ending(std::filesystem::path stem, VideoKind kind) {
  stem += traits_of(kind).ending;
  return stem;
}

}  // namespace mien::render
