#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/video/libav.h"
#include "render/video/sound_stream.h"
#include "render/video/video.h"
#include "render/video/video_receipt.h"

namespace mien::render {

/// Returns the pixel format that a kind's encoder expects.
AVPixelFormat pixel_format_of(VideoKind kind);

/// An encoder with its container: encodes pictures into a file. Its settings are those of the kind
/// and effort. The file depends neither on the machine nor on the time; the number of threads is
/// fixed, because encoders partition their work by it.
class StreamEncoder {
 public:
  /// `sound`, if not null, must outlive the object; the kind must have sound. Throws Error when
  /// this FFmpeg lacks an encoder or the file cannot be created.
  StreamEncoder(const std::filesystem::path& path, const VideoFormat& format, const Sound* sound);

  /// The picture to be filled for the next `send`.
  AVFrame& picture();

  /// Encodes the picture as the next frame. For kinds with a packet per frame, throws Error when
  /// the encoder returns packets in another order than that of the frames.
  void send();

  /// Completes the file. Throws Error when no frame was sent or, for kinds with a packet per frame,
  /// the encoder returned fewer frames than were sent.
  void finish();

  /// The packet_hash of each frame that the encoder has returned so far; empty for kinds without a
  /// packet per frame.
  const std::vector<std::uint64_t>& packet_hashes() const { return packet_hashes_; }

  /// What the sound was encoded to; nothing without a sound.
  std::optional<SoundReceipt> sound_receipt() const;

 private:
  void open_codec();
  void open_streams(const Sound* sound);
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
  std::optional<SoundStream> sound_;
  std::int64_t frames_ = 0;
  std::vector<std::uint64_t> packet_hashes_;
};

}  // namespace mien::render
