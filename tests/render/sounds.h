#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "render/sound/sound.h"

namespace mien::render::test {

inline Sound silence(std::int64_t frames, int channels = 1) {
  return {channels, std::vector<float>(static_cast<std::size_t>(frames * channels))};
}

/// A sine, of the same level on all channels.
inline Sound tone(double hertz, double amplitude, std::int64_t frames, int channels = 1) {
  Sound sound = silence(frames, channels);
  for (std::size_t i = 0; i < sound.samples.size(); ++i) {
    const double seconds = static_cast<double>(i / static_cast<std::size_t>(channels)) / sound_rate;
    sound.samples[i] =
        static_cast<float>(amplitude * std::sin(2.0 * std::numbers::pi * hertz * seconds));
  }
  return sound;
}

/// A click of one sample frame of half the full scale.
inline void add_click(Sound& sound, std::int64_t frame) {
  for (int channel = 0; channel < sound.channels; ++channel)
    sound.samples[static_cast<std::size_t>(frame * sound.channels + channel)] += 0.5f;
}

/// Deterministic noise of the given amplitude, different on each channel.
inline Sound noise(double amplitude, std::int64_t frames, int channels = 1) {
  Sound sound = silence(frames, channels);
  std::uint32_t state = 1;
  for (float& sample : sound.samples) {
    state = state * 1664525u + 1013904223u;
    sample = static_cast<float>(amplitude * (state / 2147483648.0 - 1.0));
  }
  return sound;
}

/// The frame with the largest magnitude, of those between two frames.
inline std::int64_t loudest_frame(const Sound& sound, std::int64_t first, std::int64_t end) {
  std::int64_t loudest = first;
  float most = -1.0f;
  for (std::int64_t i = first; i < end; ++i) {
    const float magnitude = std::abs(sound.samples[static_cast<std::size_t>(i * sound.channels)]);
    if (magnitude <= most) continue;
    most = magnitude;
    loudest = i;
  }
  return loudest;
}

/// Writes a WAV of 16 bits; `rate` is that which the file states.
inline void write_wav(const std::filesystem::path& file, const Sound& sound,
                      std::uint32_t rate = sound_rate) {
  std::ofstream out(file, std::ios::binary);
  const auto put = [&](std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out.put(static_cast<char>(value >> (8 * i) & 0xff));
  };
  const auto channels = static_cast<std::uint32_t>(sound.channels);
  const auto bytes = static_cast<std::uint32_t>(2 * sound.samples.size());
  out << "RIFF";
  put(36 + bytes, 4);
  out << "WAVEfmt ";
  put(16, 4);
  put(1, 2);  // PCM
  put(channels, 2);
  put(rate, 4);
  put(2 * channels * rate, 4);
  put(2 * channels, 2);
  put(16, 2);
  out << "data";
  put(bytes, 4);
  for (const float sample : sound.samples)
    put(static_cast<std::uint32_t>(std::lround(32767.0 * static_cast<double>(sample))), 2);
}

/// Encodes a sound with an encoder of FFmpeg ("flac", "libopus", "libmp3lame") into a file whose
/// format follows from its name. `rate` is that which the file states.
void write_encoded(const std::filesystem::path& file, const Sound& sound,
                   const std::string& encoder, int rate = sound_rate);

}  // namespace mien::render::test
