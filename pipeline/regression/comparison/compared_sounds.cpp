#include "pipeline/regression/comparison/compared_sounds.h"

#include <cmath>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include "render/sound/sound_match.h"
#include "render/video/sound_file.h"

namespace mien::pipeline {

namespace {

constexpr std::int64_t packet_frames = 1024;
constexpr double least_same_correlation = 0.8;
constexpr double audible_lu = 0.5;

/// Animated images have no sound.
std::optional<render::VideoSound> sound_in(const std::filesystem::path& file) {
  const auto kind = render::video_kind_of(file);
  if (kind && render::sound_codec_of(*kind).empty()) return std::nullopt;
  return render::sound_of_video(file);
}

void compare_loudness(const render::Sound& before, const render::Sound& now,
                      std::vector<std::string>& remarks) {
  const double was = render::loudness_of(before).integrated_lufs;
  const double is = render::loudness_of(now).integrated_lufs;
  if (!std::isfinite(was) || !std::isfinite(is) || std::abs(is - was) <= audible_lu) return;
  remarks.push_back(fmt::format("the sound has {:.1f} LUFS, and had {:.1f}", is, was));
}

}  // namespace

void compare_sounds(const std::filesystem::path& before, const std::filesystem::path& now,
                    std::vector<std::string>& remarks, std::vector<std::string>& notes) {
  const std::optional<render::VideoSound> was = sound_in(before);
  const std::optional<render::VideoSound> is = sound_in(now);
  if (!was && !is) return;
  if (was.has_value() != is.has_value()) {
    remarks.emplace_back(is ? "has a sound now" : "no longer has a sound");
    return;
  }
  if (was->codec != is->codec)
    notes.push_back(fmt::format("sound in {} instead of {}", is->codec, was->codec));
  if (was->sound.channels != is->sound.channels) {
    remarks.push_back(fmt::format("the sound has {} channels, and had {}", is->sound.channels,
                                  was->sound.channels));
    return;
  }
  if (std::abs(is->sound.frames() - was->sound.frames()) > packet_frames) {
    remarks.push_back(fmt::format("the sound lasts {:.3f} s, and lasted {:.3f} s",
                                  is->sound.seconds(), was->sound.seconds()));
  }
  const render::SoundMatch match = render::match_sounds(was->sound, is->sound);
  if (match.correlation < least_same_correlation) {
    remarks.push_back(
        fmt::format("another sound (correlation {:.2f} with the former)", match.correlation));
    return;
  }
  if (match.offset_frames.value_or(0) != 0) {
    remarks.push_back(fmt::format(
        "the sound is heard {:.2f} ms {}",
        1000.0 * static_cast<double>(std::abs(*match.offset_frames)) / render::sound_rate,
        *match.offset_frames > 0 ? "later" : "earlier"));
  }
  const std::size_t differences = remarks.size();
  compare_loudness(was->sound, is->sound, remarks);
  if (differences == remarks.size() && was->codec == is->codec && !(was->sound == is->sound) &&
      match.offset_frames.value_or(0) == 0)
    notes.emplace_back("the samples of the sound");
}

}  // namespace mien::pipeline
