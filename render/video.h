#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "render/image.h"

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

struct VideoFormat {
  int width = 0;   ///< even
  int height = 0;  ///< even
  FrameRate rate;
  int crf = 16;  ///< constant rate factor of x264: 0 lossless … 51
};

/// Writes H.264 in MP4: yuv420p, BT.709 limited range and tagged so, index at the front, constant
/// frame rate, exactly the frames given, in the order shown (no B frames, so players that ignore
/// edit lists show the right times). The same frames give the same bytes on every machine.
///
///   VideoWriter video(path, {.width = 960, .height = 540, .rate = {30, 1}});
///   for (…) video.write(to_srgb8(tracer.trace(scene, camera, quality)));
///   video.finish();
///
/// A writer destroyed before finish() leaves an unusable file behind. The path must end in ".mp4".
class VideoWriter {
 public:
  /// Throws Error: odd or empty size, no libx264, the file cannot be made.
  VideoWriter(const std::filesystem::path& path, const VideoFormat& format);
  ~VideoWriter();
  VideoWriter(VideoWriter&&) noexcept;
  VideoWriter& operator=(VideoWriter&&) noexcept;

  /// Appends a frame of the format's size. Throws Error: wrong size, encoder or disk failed.
  void write(const Image8& frame);

  /// Completes the file. Throws Error: no frame was written, encoder or disk failed.
  void finish();

 private:
  struct Encoder;
  std::unique_ptr<Encoder> encoder_;
};

/// What a video holds, found by decoding all of it.
struct VideoSummary {
  std::string container;     ///< "mov,mp4,m4a,3gp,3g2,mj2"
  std::string codec;         ///< "h264"
  std::string pixel_format;  ///< "yuv420p"
  int width = 0;
  int height = 0;
  FrameRate rate;
  int frames = 0;                      ///< that decode
  double duration_seconds = 0.0;       ///< from the first frame's time to the last frame's end
  std::string primaries;               ///< "bt709"
  std::string transfer;                ///< "bt709"
  std::string matrix;                  ///< "bt709"
  std::string range;                   ///< "tv"
  bool steady_timestamps = false;      ///< frame n is shown at n / rate, exactly
  bool starts_with_key_frame = false;  ///< the first frame decodes alone
  bool index_at_front = false;         ///< MP4: "moov" before "mdat"
};

/// Decodes every frame, handing each one as sRGB when `on_frame` is given. Throws Error when the
/// file cannot be opened or a frame does not decode.
VideoSummary probe(const std::filesystem::path& path,
                   const std::function<void(int index, const Image8& frame)>& on_frame = {});

/// For the provenance: "libavcodec 59.37.100, libavformat 59.27.100, x264 core 164 r3095 baee400".
std::string video_libraries();

}  // namespace mien::render
