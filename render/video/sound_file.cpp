#include "render/video/sound_file.h"

#include <cmath>

#include "render/error.h"
#include "render/video/video_files.h"

namespace mien::render {

namespace {

constexpr double least_correlation = 0.5;
/// Sample frames that may follow the sound in its last packet: FFmpeg decodes them, although MP4
/// stores the length of the sound.
constexpr std::int64_t most_aac_padding = 1023;

std::string plural(std::int64_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

void require_sound(bool holds, const std::filesystem::path& file, const std::string& wrong) {
  if (!holds) throw Error(file.string() + ": " + wrong);
}

}  // namespace

std::vector<std::string> sound_endings() { return {".wav", ".flac", ".opus", ".ogg", ".mp3"}; }

Sound read_sound(const std::filesystem::path& file) { return video_files().read_sound(file); }

std::optional<VideoSound> sound_of_video(const std::filesystem::path& file) {
  return video_files().sound_of_video(file);
}

SoundCheck check_sound(const std::filesystem::path& file, VideoKind kind, const Sound& written,
                       const SoundReceipt& receipt) {
  const std::optional<VideoSound> found = sound_of_video(file);
  require_sound(found.has_value(), file, "has no sound");
  const std::string codec(sound_codec_of(kind));
  require_sound(found->codec == codec, file,
                "the sound's codec is \"" + found->codec + "\" instead of \"" + codec + "\"");
  require_sound(receipt.hash == hash_of(written), file,
                "the sound that was encoded is not the film's");
  require_sound(found->packet_hashes == receipt.packet_hashes, file,
                "the sound is not in the bytes that it was encoded in");
  require_sound(found->sound.channels == written.channels, file,
                "the sound has " + plural(found->sound.channels, "channel") + " instead of " +
                    std::to_string(written.channels));
  const std::int64_t more = found->sound.frames() - written.frames();
  require_sound(more >= 0 && more <= (codec == "aac" ? most_aac_padding : 0), file,
                "the sound has " + plural(found->sound.frames(), "sample frame") + " instead of " +
                    std::to_string(written.frames()));
  // Matroska and WebM store times in milliseconds.
  const double tolerance = codec == "aac" ? 0.1 / sound_rate : 0.00101;
  require_sound(std::abs(found->start_seconds) <= tolerance, file,
                "the sound begins at " + std::to_string(found->start_seconds) + " s");
  const SoundMatch match = match_sounds(written, found->sound);
  require_sound(
      match.offset_frames.value_or(0) == 0, file,
      "the sound is shifted by " + plural(match.offset_frames.value_or(0), "sample frame"));
  require_sound(match.correlation >= least_correlation, file,
                "the sound differs from what was encoded");
  return {codec, written.channels, written.frames(), receipt.hash, match};
}

Loudness loudness_of(const Sound& sound) { return video_files().loudness(sound); }

std::string sound_libraries() { return video_files().sound_libraries(); }

}  // namespace mien::render
