#pragma once

#include <vector>

#include "motion/modify/modification.h"

namespace mien::motion {

/// Gains of the longest (2), the shortest (0) and the thesis' moderately short paths (0.6 in the
/// middle band). High frequencies, which hold noise and nothing of an emotion, are damped in each.
inline constexpr double longest_middle_gain = 1.8;
inline constexpr double shortest_middle_gain = 0.3;
inline constexpr double high_gain = 0.3;

PathGains longest_path_gains();
PathGains shortest_path_gains();

/// How often a clip of that rate must be sampled so that its finest band holds nothing of the
/// middle group: 4 at 30 frames a second, 1 from 50 on.
int oversampling(double frames_per_second);

/// Gains of single bands from those of the groups, finest first: each band belongs to the group of
/// its peak frequency (1 and 12.5 Hz between them), smooth over half an octave. `rate_hz` is that
/// of the signal which is filtered. Ends where only bands of the low group follow.
std::vector<double> band_gains(const PathGains& gains, double rate_hz);

/// Band gains for the signal of a clip.
struct BandWeights {
  std::vector<double> gains;  ///< of single bands, finest first
  double rest_gain = 1.0;     ///< of all that is slower
  int factor = 1;             ///< samples of the signal for each frame (`oversampling`)
};

BandWeights band_weights(const PathGains& gains, double frames_per_second);

/// The clip with the bands of all its joint rotations weighted (Bruderlin and Williams 1995). The
/// root's path is unchanged, so feet slide: see foot_repair.h. With direction vectors only the
/// ratios of gains count.
Clip with_path_gains(const Clip& clip, const PathGains& gains, RotationSignal signal);

}  // namespace mien::motion
