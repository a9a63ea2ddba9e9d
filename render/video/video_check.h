#pragma once

#include <filesystem>
#include <string>

#include "render/video/video.h"
#include "render/video/video_sketch.h"

namespace mien::render {

/// The result of checking a written video.
struct VideoCheck {
  VideoSummary summary;
  int frames = 0;         ///< number of frames that are shown
  bool identical = true;  ///< every decoded frame equals the frame written, in the sampled rows
  double worst_psnr_db = 0.0;  ///< smallest of all frames; infinite when identical (video_sketch.h)
  int worst_psnr_frame = 0;
  double worst_ssim = 1.0;
  int worst_ssim_frame = 0;
};

/// Decodes a video and throws Error unless it matches what was written:
///
/// - the size is that of the format; codec and, except for Matroska and animated pictures, colour
///   tags are those of the kind; MP4 has its index at the front;
/// - as many frames as were written, each shown at its time and the last until the film's end, to
///   the container's time resolution; a WebP may show a picture for several frames, or for all of a
///   film without movement;
/// - the first frame decodes from its own bytes alone;
/// - no tile of a frame (video_sketch.h) is lighter or darker by more than 12 of 255;
/// - lossless kinds: each frame is the frame written; others: the worst frame's PSNR and SSIM reach
///   the kind's least values (video_kind.h), which for pictures below 100,000 pixels are 6 dB and
///   0.15 less (except for GIF), and still less if there are few tiles to estimate them from;
/// - no decoded frame's tiles are twice as close to those of the previous or next written frame as
///   to those of its own, unless all its tiles are within 1 of 255 of those of its own;
/// - with a receipt: the encoder was given exactly the frames of the film, each once and in order,
///   and, for kinds with a packet per frame, the file contains exactly the bytes that the encoder
///   produced for each.
///
/// With a packet per frame, the receipt reveals every frame that is lost, duplicated, swapped or
/// damaged, however little frames differ; similarity only has to show that the encoder worked, for
/// which a sketch of some rows suffices. Throws std::invalid_argument for a sketch of some rows
/// without a receipt. The result does not depend on the number of threads.
VideoCheck check_video(const std::filesystem::path& path, const VideoFormat& format,
                       const VideoSketch& written, const VideoReceipt* receipt = nullptr,
                       int threads = 2);

/// Returns the `row_step` for the check of a video: 4, every fourth row, for drafts of at least
/// 100,000 pixels that are coded in blocks of four rows or more (lossy, no animated picture); 1,
/// every row, for all others.
int checked_row_step(const VideoFormat& format);

/// "identical to the frames", or "worst PSNR 44.1 dB (frame 3), worst SSIM 0.995 (frame 7)".
std::string similarity_text(const VideoCheck& check);

}  // namespace mien::render
