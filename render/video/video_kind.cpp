#include "render/video/video_kind.h"

#include <cstddef>
#include <iterator>
#include <string>

namespace mien::render {

namespace {

// The least PSNR and SSIM are well below what rendered frames reach (about 42 dB and 0.98) and well
// above what wrong colours, frames of another moment or broken blocks leave. A GIF has 255 colours
// for the whole video, and its dither counts as noise.
//
// In the order of VideoKind. Columns: kind, name, ending, description, codec, even_size, lossless,
// picture, most_fps, least_psnr_db, least_ssim; those omitted have the defaults of VideoTraits.
constexpr VideoTraits kinds[] = {
    {VideoKind::mp4, "mp4", ".mp4", "H.264 in MP4", "h264", true, false, false, 240.0, 30.0, 0.88},
    {VideoKind::mp4_lossless, "mp4-lossless", ".lossless.mp4", "H.264 in MP4, lossless RGB", "h264",
     false, true},
    {VideoKind::webm, "webm", ".webm", "VP9 in WebM", "vp9", true, false, false, 240.0, 30.0, 0.88},
    {VideoKind::webm_av1, "webm-av1", ".av1.webm", "AV1 in WebM", "av1", true, false, false, 240.0,
     30.0, 0.88},
    {VideoKind::mkv, "mkv", ".mkv", "FFV1 in Matroska, lossless RGB", "ffv1", false, true},
    {VideoKind::webp, "webp", ".webp", "animated WebP", "webp", false, false, true, 90.0, 29.0,
     0.85},
    {VideoKind::gif, "gif", ".gif", "animated GIF", "gif", false, false, true, 50.0, 22.0, 0.5},
    {VideoKind::apng, "apng", ".apng", "animated PNG, lossless", "apng", false, true, true, 90.0},
};
static_assert(std::size(kinds) == static_cast<std::size_t>(VideoKind::apng) + 1);

}  // namespace

std::span<const VideoTraits> video_kinds() { return kinds; }

const VideoTraits& traits_of(VideoKind kind) { return kinds[static_cast<std::size_t>(kind)]; }

std::string_view sound_codec_of(VideoKind kind) {
  switch (kind) {
    case VideoKind::mp4:
    case VideoKind::mp4_lossless:
      return "aac";
    case VideoKind::webm:
    case VideoKind::webm_av1:
    case VideoKind::mkv:
      return "opus";
    case VideoKind::webp:
    case VideoKind::gif:
    case VideoKind::apng:
      break;
  }
  return "";
}

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
