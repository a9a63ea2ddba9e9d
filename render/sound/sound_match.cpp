#include "render/sound/sound_match.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace mien::render {

namespace {

constexpr std::int64_t stretch_frames = 16'384;
constexpr double clearly_better = 0.9;
/// Sounds that differ by less than this share of their energy are not shifted: so little may be a
/// codec's phase, which moves a low tone by half a sample frame.
constexpr double same_share = 4e-4;
/// Sounds that differ by more than this share of their energy are compared at all shifts, others
/// only at small ones: a periodic sound is like itself at many.
constexpr double different_share = 0.1;
constexpr std::int64_t small_shift = 100;
constexpr double silent_peak = 1e-3;  // −60 dBFS

std::vector<double> added_channels(const Sound& sound) {
  std::vector<double> sums(static_cast<std::size_t>(sound.frames()));
  for (std::size_t i = 0; i < sound.samples.size(); ++i)
    sums[i / static_cast<std::size_t>(sound.channels)] += static_cast<double>(sound.samples[i]);
  return sums;
}

double energy_of(const double* samples, std::int64_t count) {
  double sum = 0.0;
  for (std::int64_t i = 0; i < count; ++i) sum += samples[i] * samples[i];
  return sum;
}

/// Where the loudest stretch begins, of those that begin at multiples of half its length.
std::int64_t loudest_stretch(const std::vector<double>& sums, std::int64_t length) {
  const auto frames = static_cast<std::int64_t>(sums.size());
  std::int64_t loudest = 0;
  double most = -1.0;
  for (std::int64_t at = 0; at < frames; at += stretch_frames / 2) {
    const std::int64_t begin = std::max(std::int64_t{0}, std::min(at, frames - length));
    const double energy = energy_of(sums.data() + begin, length);
    if (energy > most) {
      most = energy;
      loudest = begin;
    }
  }
  return loudest;
}

/// A stretch of the written sound at its place in the decoded one, which is silent on both sides.
struct Stretch {
  const double* written;
  std::int64_t length;
  std::vector<double> decoded;  // with most_sound_shift frames before and after

  double squared_difference(std::int64_t shift) const {
    const double* found = decoded.data() + most_sound_shift + shift;
    double sum = 0.0;
    for (std::int64_t i = 0; i < length; ++i) {
      const double difference = found[i] - written[i];
      sum += difference * difference;
    }
    return sum;
  }

  double correlation(std::int64_t shift) const {
    const double* found = decoded.data() + most_sound_shift + shift;
    double sum = 0.0;
    for (std::int64_t i = 0; i < length; ++i) sum += found[i] * written[i];
    const double energies = energy_of(written, length) * energy_of(found, length);
    return energies > 0.0 ? sum / std::sqrt(energies) : 0.0;
  }
};

/// The shift with the least squared difference from `first` to `last`, if that is less than
/// `least`; otherwise 0.
std::int64_t best_between(const Stretch& stretch, std::int64_t first, std::int64_t last,
                          double least) {
  std::int64_t best = 0;
  for (std::int64_t shift = first; shift <= last; ++shift) {
    const double difference = stretch.squared_difference(shift);
    if (difference >= least) continue;
    least = difference;
    best = shift;
  }
  return best;
}

std::int64_t best_shift(const Stretch& stretch) {
  const double unshifted = stretch.squared_difference(0);
  const double energy = energy_of(stretch.written, stretch.length);
  if (unshifted < same_share * energy) return 0;
  if (unshifted > different_share * energy)
    return best_between(stretch, -most_sound_shift, most_sound_shift, clearly_better * unshifted);
  return best_between(stretch, -small_shift, small_shift, clearly_better * unshifted);
}

}  // namespace

SoundMatch match_sounds(const Sound& written, const Sound& decoded) {
  if (sample_peak(written) < silent_peak)
    return {{}, sample_peak(decoded) < 2.0 * silent_peak ? 1.0 : 0.0};
  const std::vector<double> sums = added_channels(written);
  const std::vector<double> found = added_channels(decoded);
  const std::int64_t length = std::min(stretch_frames, static_cast<std::int64_t>(sums.size()));
  const std::int64_t begin = loudest_stretch(sums, length);
  Stretch stretch{sums.data() + begin, length, {}};
  for (std::int64_t i = -most_sound_shift; i < length + most_sound_shift; ++i) {
    const std::int64_t at = begin + i;
    const bool exists = at >= 0 && at < static_cast<std::int64_t>(found.size());
    stretch.decoded.push_back(exists ? found[static_cast<std::size_t>(at)] : 0.0);
  }
  const std::int64_t shift = best_shift(stretch);
  return {shift, stretch.correlation(shift)};
}

}  // namespace mien::render
