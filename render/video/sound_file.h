#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/sound/sound.h"
#include "render/sound/sound_match.h"
#include "render/video/video_kind.h"
#include "render/video/video_receipt.h"

namespace mien::render {

/// Endings of the names of sound files that are read, lower case: ".wav", ".flac", ".opus", ".ogg",
/// ".mp3".
std::vector<std::string> sound_endings();

/// Reads a sound file (WAV, FLAC, Opus or Vorbis in Ogg, MP3), recognized by its content. Other
/// rates are converted to sound_rate; the delays of encoders, as the file states them, are removed,
/// so that frame 0 is the first sample that was encoded. The result is the same on all processors.
/// Throws Error when the file cannot be opened or decoded, has more than two channels, no sample,
/// or lasts longer than longest_sound_seconds.
Sound read_sound(const std::filesystem::path& file);

/// The sound of a video, decoded.
struct VideoSound {
  std::string codec;  ///< "aac"
  Sound sound;
  double start_seconds = 0.0;                ///< when its first sample frame is heard
  std::vector<std::uint64_t> packet_hashes;  ///< hashes of its packets, in the file's order
};

/// Decodes the sound of a video; nothing if it has none. Throws Error when it does not decode.
std::optional<VideoSound> sound_of_video(const std::filesystem::path& file);

/// The result of checking the sound of a written video.
struct SoundCheck {
  std::string codec;
  int channels = 0;
  std::int64_t frames = 0;  ///< sample frames of the film's sound
  std::uint64_t hash = 0;   ///< of the sound that was encoded
  SoundMatch match;
};

/// Decodes the sound of a video and throws Error unless it matches what was written: the codec is
/// that of the kind; the file contains exactly the bytes that the encoder produced; as many sample
/// frames as were written (in MP4, the rest of a packet of AAC may follow), the first at the film's
/// beginning (to the container's time resolution); no shift by a single sample frame
/// (match_sounds); and a correlation of at least 0.5.
SoundCheck check_sound(const std::filesystem::path& file, VideoKind kind, const Sound& written,
                       const SoundReceipt& receipt);

/// Versions of the libraries that only sound needs: "libswresample 4.7.100, libebur128 1.2.6".
std::string sound_libraries();

/// Loudness by EBU R 128 (ITU-R BS.1770-4).
struct Loudness {
  /// Integrated loudness of the programme, LUFS; minus infinity where nothing is above the gates.
  double integrated_lufs = 0.0;
  double true_peak_dbtp = 0.0;  ///< largest peak between samples too, dB re full scale
};

/// Measures a sound with libebur128. Throws Error when it fails.
Loudness loudness_of(const Sound& sound);

}  // namespace mien::render
