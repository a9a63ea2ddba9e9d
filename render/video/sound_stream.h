#pragma once

#include <cstdint>
#include <string>

#include "render/sound/sound.h"
#include "render/video/libav.h"
#include "render/video/video_kind.h"
#include "render/video/video_receipt.h"

namespace mien::render {

/// While it exists, FFmpeg's libraries use no vector instructions in what they set up, so that
/// sounds are the same on all processors: vector code adds in another order. What other threads set
/// up meanwhile is slower, and gives the same pictures (video decoders are specified exactly, and
/// conversions are asked for exactly). Only one exists at a time.
class PlainProcessor {
 public:
  PlainProcessor();
  ~PlainProcessor();
  PlainProcessor(const PlainProcessor&) = delete;
  PlainProcessor& operator=(const PlainProcessor&) = delete;

 private:
  int flags_;
};

/// The stream of a film's sound in a container: encodes the sound while frames are written. AAC has
/// 128 kbit/s and Opus 96 kbit/s per channel.
class SoundStream {
 public:
  /// Adds a stream to `file`, whose header has not been written. Both arguments must outlive the
  /// object. Throws Error when this FFmpeg lacks the encoder.
  SoundStream(AVFormatContext& file, std::string path, VideoKind kind, const Sound& sound);

  /// Encodes all that begins before a time, in sample frames. Throws Error when the encoder or the
  /// disk fails.
  void write_until(std::int64_t frame);

  /// Encodes the rest. To be called before the container's trailer is written.
  void finish();

  const SoundReceipt& receipt() const { return receipt_; }

 private:
  void send(std::int64_t count);
  void drain();

  AVFormatContext& file_;
  std::string path_;
  VideoKind kind_;
  const Sound& sound_;
  CodecContext codec_;
  Packet packet_;
  AVStream* stream_ = nullptr;
  std::int64_t sent_ = 0;
  std::int64_t time_shift_ = 0;  // added to the packets' times
  SoundReceipt receipt_;
};

}  // namespace mien::render
