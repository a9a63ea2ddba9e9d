#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "render/video/libav.h"
#include "render/video/video.h"
#include "render/video/video_receipt.h"

namespace mien::render {

/// The pixel format in which a kind's encoder takes its pictures.
AVPixelFormat pixel_format_of(VideoKind kind);

/// One encoder with its container: pictures in, a file out. Its settings are those of the kind;
/// nothing of the machine or the time goes into the file, and the number of threads is fixed,
/// because encoders cut their work by it.
class StreamEncoder {
 public:
  /// Throws Error: no such encoder in this FFmpeg, the file cannot be made.
  StreamEncoder(const std::filesystem::path& path, const VideoFormat& format);

  /// The picture to be filled for the next `send`.
  AVFrame& picture();

  /// Encodes the picture as the next frame. Throws Error when the encoder returns another packet
  /// than that of the next frame, for kinds with a packet per frame.
  void send();

  /// Completes the file. Throws Error when no frame was sent, or one did not come out.
  void finish();

  /// The packet_hash of each frame so far; empty for kinds without a packet per frame.
  const std::vector<std::uint64_t>& packet_hashes() const { return packet_hashes_; }

 private:
  void open_codec();
  void open_file();
  void drain();
  void record_packet();

  /// Sets the duration of a GIF's last frame, which would otherwise be the rounded one of the frame
  /// before.
  void set_last_duration();

  std::string path_;
  VideoFormat format_;
  Output file_;
  CodecContext codec_;
  Frame picture_;
  Packet packet_;
  AVStream* stream_ = nullptr;
  std::int64_t frames_ = 0;
  std::vector<std::uint64_t> packet_hashes_;
};

}  // namespace mien::render
