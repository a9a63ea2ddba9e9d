#include "pipeline/production/archive/frame_comparison.h"

#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "pipeline/tasks/hash.h"
#include "render/video/video.h"
#include "render/video/video_sketch.h"

namespace mien::pipeline {

namespace {

constexpr double psnr_tolerance_db = 0.1;
constexpr double ssim_tolerance = 0.001;

Comparison compare(const render::Image8& drawn, const render::Image8& decoded,
                   const VideoRecord& video) {
  if (drawn.width != decoded.width || drawn.height != decoded.height)
    return {false, "the video has a different size"};
  if (video.identical) {
    const bool same = drawn.channels == decoded.channels;
    return {same, same ? "identical pixels" : "different pixels, although this format is lossless"};
  }
  const render::FrameSketcher sketcher(drawn.width, drawn.height);
  const render::FrameSimilarity like =
      sketcher.similarity(sketcher.sketch(drawn), sketcher.sketch(decoded));
  const bool agrees = like.identical || (like.psnr_db >= video.worst_psnr_db - psnr_tolerance_db &&
                                         like.ssim >= video.worst_ssim - ssim_tolerance);
  return {agrees,
          fmt::format("PSNR {:.2f} dB and SSIM {:.4f}; worst frame of the film {:.2f} and {:.4f}",
                      like.psnr_db, like.ssim, video.worst_psnr_db, video.worst_ssim)};
}

/// Calls `visit` with each frame of a video and its picture; a picture that stands for several
/// frames comes several times.
void visit_frames(const std::filesystem::path& file, const VideoRecord& video,
                  const std::function<void(int, const render::Image8&)>& visit) {
  int next = 0;
  render::probe_timed(file, [&](const render::TimedPicture& shot) {
    int last = next;
    if (video.format == "webp")
      last = shot.duration > 0.0
                 ? static_cast<int>(std::lround((shot.seconds + shot.duration) * video.fps)) - 1
                 : video.frames - 1;
    for (; next <= last; ++next) visit(next, shot.picture);
  });
}

}  // namespace

Comparison compare_files(const std::filesystem::path& drawn, const std::filesystem::path& kept) {
  const bool same = hash_of_file(drawn) == hash_of_file(kept);
  return {same, same ? "identical" : "different content"};
}

VideoFrames::VideoFrames(const Output& output, int film_frames, int eyes, int first_film_frame)
    : output_(output), first_film_frame_(first_film_frame), presenter_(output, film_frames, eyes) {}

void VideoFrames::take(int frame, const render::Image8& picture) {
  // What is shown goes by how many frames came before.
  for (; next_ < frame; ++next_) presenter_.take(picture, [](const render::Image8&) {});
  int shown = next_ == 0 ? 0 : first_film_frame_ + next_;
  presenter_.take(picture, [&](const render::Image8& one) {
    if (shown++ == first_film_frame_ + frame) shown_[frame] = one;
  });
  ++next_;
}

std::map<int, Comparison> VideoFrames::compare_with(const std::filesystem::path& folder,
                                                    const VideoRecord& video) const {
  std::map<int, Comparison> result;
  for (const auto& [frame, picture] : shown_)
    result[frame] = {false, "the video does not show this frame"};
  visit_frames(folder / video.file, video, [&](int frame, const render::Image8& decoded) {
    const auto drawn = shown_.find(frame - first_film_frame_);
    if (drawn != shown_.end()) result[drawn->first] = compare(drawn->second, decoded, video);
  });
  return result;
}

}  // namespace mien::pipeline
