#include "render/sound/sound.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <xxhash.h>

namespace mien::render {

std::uint64_t hash_of(const Sound& sound) {
  return XXH3_64bits_withSeed(sound.samples.data(), sound.samples.size() * sizeof(float),
                              static_cast<XXH64_hash_t>(sound.channels));
}

double sample_peak(const Sound& sound) {
  float most = 0.0f;
  for (const float sample : sound.samples) most = std::max(most, std::abs(sample));
  return static_cast<double>(most);
}

double factor_of_decibels(double gain_db) { return std::pow(10.0, gain_db / 20.0); }

double decibels_of(double magnitude) { return 20.0 * std::log10(magnitude); }

Sound placed(const Sound& source, const SoundPlacing& placing) {
  Sound result{source.channels, {}};
  const auto channels = static_cast<std::int64_t>(source.channels);
  result.samples.resize(static_cast<std::size_t>(placing.length * channels));
  const std::int64_t shift = placing.begin - placing.offset;  // from the source to the result
  const std::int64_t first = std::max({std::int64_t{0}, placing.begin, shift});
  const std::int64_t end = std::min(placing.length, source.frames() + shift);
  const double factor = factor_of_decibels(placing.gain_db);
  for (std::int64_t i = first * channels; i < end * channels; ++i) {
    const float sample = source.samples[static_cast<std::size_t>(i - shift * channels)];
    result.samples[static_cast<std::size_t>(i)] = static_cast<float>(factor * sample);
  }
  return result;
}

std::vector<SampleRange> waveform(const Sound& sound, int count) {
  std::vector<SampleRange> ranges(static_cast<std::size_t>(count));
  const std::int64_t frames = sound.frames();
  if (frames == 0) return ranges;
  for (int i = 0; i < count; ++i) {
    const std::int64_t first = std::min(frames - 1, frames * i / count);
    const std::int64_t end = std::max(first + 1, frames * (i + 1) / count);
    const auto begin = sound.samples.begin() + first * sound.channels;
    const auto [least, most] =
        std::minmax_element(begin, sound.samples.begin() + end * sound.channels);
    ranges[static_cast<std::size_t>(i)] = {*least, *most};
  }
  return ranges;
}

}  // namespace mien::render
