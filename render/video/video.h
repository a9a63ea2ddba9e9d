#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "render/video/video_kind.h"
#include "render/video/video_receipt.h"

namespace mien::render {

/// Frames a second as a fraction: 30/1, 30000/1001.
struct FrameRate {
  int numerator = 30;
  int denominator = 1;

  double per_second() const { return static_cast<double>(numerator) / denominator; }
  bool operator==(const FrameRate&) const = default;
};

/// The fraction nearest to `per_second` that a video can have (denominator 1 or 1001, else up to
/// 1000). Throws std::invalid_argument when it is not positive.
FrameRate frame_rate(double per_second);

/// How hard an encoder tries to make files small: `fast` keeps up with drafts.
enum class VideoEffort { fast, thorough };

struct VideoFormat {
  int width = 0;
  int height = 0;
  FrameRate rate;
  VideoKind kind = VideoKind::mp4;
  VideoEffort effort = VideoEffort::thorough;
  bool loops = true;  ///< animated pictures: repeat for ever, else play once
};

/// Writes a video of any kind (video_kind.h): exactly the frames given, at a constant rate, with
/// nothing of the time or the machine in it, so the same frames give the same bytes everywhere.
///
///   VideoWriter video(path, {.width = 960, .height = 540, .rate = {30, 1}});
///   for (…) video.write(to_srgb8(tracer.trace(scene, camera, quality)));
///   video.finish();
///
/// Lossy kinds are yuv420p, BT.709, limited range; lossless ones RGB; all are tagged so where their
/// container can. MP4 has its index at the front and no B frames, so that players which ignore edit
/// lists show the right times. Matroska and WebM know times in milliseconds, WebP likewise, GIF in
/// hundredths of a second: each frame is shown at the nearest. A GIF has one table of colours for
/// all frames, found from all of them, and ordered dither; its frames wait in a file
/// "<path>.frames.mkv" until finish().
///
/// A writer destroyed before finish() leaves an unusable file behind.
class VideoWriter {
 public:
  /// Throws Error: a size that the kind cannot have, an encoder that this FFmpeg lacks, the file
  /// cannot be made.
  VideoWriter(const std::filesystem::path& path, const VideoFormat& format);
  ~VideoWriter();
  VideoWriter(VideoWriter&&) noexcept;
  VideoWriter& operator=(VideoWriter&&) noexcept;

  /// Appends a frame of the format's size. Throws Error: wrong size, encoder or disk failed.
  void write(const Image8& frame);

  /// Completes the file. Throws Error: no frame was written, encoder or disk failed.
  void finish();

  /// The receipt of what went into the file; complete after finish().
  const VideoReceipt& receipt() const;

 private:
  std::unique_ptr<class VideoEncoder> encoder_;
};

/// What a video holds, found by decoding all of it.
struct VideoSummary {
  std::string container;     ///< "mov,mp4,m4a,3gp,3g2,mj2"
  std::string codec;         ///< "h264"
  std::string pixel_format;  ///< "yuv420p"
  int width = 0;
  int height = 0;
  FrameRate rate;
  int frames = 0;                            ///< that decode
  std::vector<std::uint64_t> packet_hashes;  ///< packet_hash each packet, in the file's order
  std::vector<double> times;                 ///< when each frame is shown, seconds
  double tick_seconds = 0.0;                 ///< the container's unit of time
  double duration_seconds = 0.0;       ///< from the first frame's time to the last frame's end
  std::string primaries;               ///< "bt709"
  std::string transfer;                ///< "bt709"
  std::string matrix;                  ///< "bt709"
  std::string range;                   ///< "tv"
  bool steady_timestamps = false;      ///< frame n is shown at the tick nearest to n / rate
  bool starts_with_key_frame = false;  ///< the first frame decodes alone
  bool index_at_front = false;         ///< MP4: "moov" before "mdat"
};

/// A decoded picture, sRGB, and when it is shown.
struct TimedPicture {
  int index = 0;
  double seconds = 0.0;   ///< from the start of the file
  double duration = 0.0;  ///< as the container has it, seconds
  const Image8& picture;
};

/// Decodes every frame, handing each one on when asked to. Throws Error when the file cannot be
/// opened or a frame does not decode. Pictures that repeat the one before have no frame of their
/// own in a WebP: the one before is shown longer.
VideoSummary probe(const std::filesystem::path& path,
                   const std::function<void(int index, const Image8& frame)>& on_frame = {});

/// As `probe`, with the times of the pictures. With a step, pictures consist of the rows 0, step, 2
/// · step … only; not for WebP.
VideoSummary probe_timed(const std::filesystem::path& path,
                         const std::function<void(const TimedPicture&)>& on_picture,
                         int row_step = 1);

/// As probe_timed with several threads, which decode from key frame to key frame in parallel:
/// `on_picture` is called concurrently, and of several errors, also of `on_picture`, that of the
/// earliest frame is thrown. The video has a packet per frame (has_packet_per_frame); throws Error
/// where a packet is not a frame. A WebP is decoded as by probe_timed.
VideoSummary probe_in_parallel(const std::filesystem::path& path,
                               const std::function<void(const TimedPicture&)>& on_picture,
                               int row_step, int threads);

/// Decodes the first picture from its own bytes alone, which proves that it is a key frame. Throws
/// Error when that fails.
Image8 decode_first_picture(const std::filesystem::path& path);

/// For the provenance: "libavcodec 59.37.100, libavformat 59.27.100, libswscale 6.7.100".
std::string video_libraries();

}  // namespace mien::render
