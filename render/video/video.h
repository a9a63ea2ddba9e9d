#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "render/sound/sound.h"
#include "render/video/video_kind.h"
#include "render/video/video_receipt.h"

namespace mien::render {

/// A frame rate, frames per second, as a fraction: 30/1, 30000/1001.
struct FrameRate {
  int numerator = 30;
  int denominator = 1;

  double per_second() const { return static_cast<double>(numerator) / denominator; }
  bool operator==(const FrameRate&) const = default;
};

/// The fraction nearest to `per_second` that a video can have: with denominator 1 or 1001 if one of
/// these fits, otherwise with a denominator up to 1000. Throws std::invalid_argument when
/// `per_second` is not positive or not finite.
FrameRate frame_rate(double per_second);

/// The encoder's effort to make files small: `fast` is for drafts.
enum class VideoEffort { fast, thorough };

struct VideoFormat {
  int width = 0;
  int height = 0;
  FrameRate rate;
  VideoKind kind = VideoKind::mp4;
  VideoEffort effort = VideoEffort::thorough;
  bool loops = true;  ///< animated pictures: repeat for ever, else play once
};

/// Writes a video of any kind (video_kind.h): exactly the given frames, at a constant rate. The
/// file contains nothing that depends on the time or the machine, so the same frames and versions
/// of FFmpeg's libraries give the same bytes everywhere.
///
///   VideoWriter video(path, {.width = 960, .height = 540, .rate = {30, 1}});
///   for (…) video.write(to_srgb8(tracer.trace(scene, camera, quality)));
///   video.finish();
///
/// H.264 (except lossless), VP9 and AV1 are yuv420p, BT.709, limited range; lossless kinds are RGB.
/// They are tagged accordingly where their container permits. MP4 has its index at the front. It
/// has no B frames, so that players which ignore edit lists show the right times. Matroska, WebM
/// and WebP store times in milliseconds, GIF in hundredths of a second; each frame is shown at the
/// nearest time that can be stored (WebP: the nearest before it). A GIF has one palette, computed
/// from all frames, and ordered dither; its frames are kept in a temporary file "<path>.frames.mkv"
/// until the writer is destroyed.
///
/// With a sound, which begins with the first frame, MP4 has a stream of AAC and WebM and Matroska
/// one of Opus, interleaved with the frames. Its first sample is heard at 0 s: the encoder's delay
/// is stored in the file, so that players skip it.
///
/// A writer destroyed before finish() may leave an unusable file behind.
class VideoWriter {
 public:
  /// `sound`, if not null, must outlive the object and should be as long as the frames. Throws
  /// Error when the kind does not support the size or a sound, this FFmpeg lacks an encoder, or the
  /// file cannot be created.
  VideoWriter(const std::filesystem::path& path, const VideoFormat& format,
              const Sound* sound = nullptr);
  ~VideoWriter();
  VideoWriter(VideoWriter&&) noexcept;
  VideoWriter& operator=(VideoWriter&&) noexcept;

  /// Appends a frame of the format's size. Throws Error when the size is wrong, or the encoder or
  /// the disk fails.
  void write(const Image8& frame);

  /// Completes the file. Throws Error when no frame was written, or the encoder or the disk fails.
  void finish();

  /// The receipt of the frames written to the file; complete after finish().
  const VideoReceipt& receipt() const;

 private:
  std::unique_ptr<class VideoEncoder> encoder_;
};

/// The properties of a video, found by decoding all of it. Those of a WebP have no pixel format,
/// packet hashes or colour tags.
struct VideoSummary {
  std::string container;     ///< "mov,mp4,m4a,3gp,3g2,mj2"
  std::string codec;         ///< "h264"
  std::string pixel_format;  ///< "yuv420p"
  int width = 0;
  int height = 0;
  FrameRate rate;
  int frames = 0;                            ///< number of decoded frames
  std::vector<std::uint64_t> packet_hashes;  ///< packet_hash of each packet, in the file's order
  std::vector<double> times;                 ///< when each frame is shown, seconds
  double tick_seconds = 0.0;                 ///< the container's unit of time
  double duration_seconds = 0.0;   ///< from the start of the file to the last frame's end, seconds
  std::string primaries;           ///< "bt709"
  std::string transfer;            ///< "bt709"
  std::string matrix;              ///< "bt709"
  std::string range;               ///< "tv"
  bool steady_timestamps = false;  ///< frame n is shown at the tick nearest to n / rate; not
                                   ///< determined for WebP
  bool starts_with_key_frame = false;  ///< the first frame is marked as a key frame; true for WebP
  bool index_at_front = false;         ///< MP4: "moov" before "mdat"
};

/// A decoded picture, sRGB, and when it is shown.
struct TimedPicture {
  int index = 0;
  double seconds = 0.0;   ///< from the start of the file
  double duration = 0.0;  ///< as stored in the container, seconds
  const Image8& picture;
};

/// Decodes every frame and passes each to `on_frame`, if given. Throws Error when the file cannot
/// be opened or a frame does not decode. A WebP does not store frames that repeat the previous one,
/// which is shown longer instead.
VideoSummary probe(const std::filesystem::path& path,
                   const std::function<void(int index, const Image8& frame)>& on_frame = {});

/// As `probe`, with the times of the pictures. With a `row_step` above 1, pictures consist of the
/// rows 0, row_step, 2 · row_step … only; not for WebP.
VideoSummary probe_timed(const std::filesystem::path& path,
                         const std::function<void(const TimedPicture&)>& on_picture,
                         int row_step = 1);

/// As probe_timed with several threads, which decode from key frame to key frame in parallel:
/// `on_picture` is called concurrently, and of several errors, including those of `on_picture`,
/// that of the earliest frame is thrown. The video must have a packet per frame
/// (has_packet_per_frame); throws Error if a packet is not a frame. A WebP is decoded as by
/// probe_timed.
VideoSummary probe_in_parallel(const std::filesystem::path& path,
                               const std::function<void(const TimedPicture&)>& on_picture,
                               int row_step, int threads);

/// Decodes the first picture from its own bytes alone, which proves that it is a key frame. Throws
/// Error when that fails.
Image8 decode_first_picture(const std::filesystem::path& path);

/// Library versions for provenance records: "libavcodec 59.37.100, libavformat 59.27.100,
/// libswscale 6.7.100".
std::string video_libraries();

}  // namespace mien::render
