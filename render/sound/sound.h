#pragma once

#include <cstdint>
#include <vector>

namespace mien::render {

/// The rate of all sounds, sample frames per second. (A sample frame is one sample per channel.)
inline constexpr int sound_rate = 48'000;

/// Longest sound that is read, seconds.
inline constexpr double longest_sound_seconds = 600.0;

/// A sound of one or two channels at sound_rate; full scale is −1 … 1.
struct Sound {
  int channels = 1;
  std::vector<float> samples;  ///< interleaved: left, right, left …

  std::int64_t frames() const { return static_cast<std::int64_t>(samples.size()) / channels; }
  double seconds() const { return static_cast<double>(frames()) / sound_rate; }

  friend bool operator==(const Sound&, const Sound&) = default;
};

/// Hash of the number of channels and of all samples.
std::uint64_t hash_of(const Sound& sound);

/// The largest magnitude of a sample; 0 of an empty sound.
double sample_peak(const Sound& sound);

/// The factor of a gain in decibels.
double factor_of_decibels(double gain_db);

/// The level of a magnitude in decibels below full scale (dBFS); minus infinity for 0.
double decibels_of(double magnitude);

/// Where a sound is heard in a film, in sample frames of the film.
struct SoundPlacing {
  std::int64_t offset = 0;  ///< frame of the source that is heard at `begin`; negative: silence
  std::int64_t begin = 0;   ///< when the source begins to be heard
  std::int64_t length = 0;  ///< of the result
  double gain_db = 0.0;
};

/// Returns a sound of `placing.length` with frame offset + i of the source, multiplied by the gain,
/// at begin + i for each i ≥ 0, and silence elsewhere. Nothing is faded or limited.
Sound placed(const Sound& source, const SoundPlacing& placing);

/// The smallest and the largest sample of a stretch of a sound, of all channels.
struct SampleRange {
  float least = 0.0f;
  float most = 0.0f;
};

/// Divides a sound into `count` stretches of equal length, as a picture of its waveform shows them;
/// a stretch without a frame has the range of the frame before it.
std::vector<SampleRange> waveform(const Sound& sound, int count);

}  // namespace mien::render
