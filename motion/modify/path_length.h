#pragma once

#include <vector>

#include "motion/modify/modification.h"

namespace mien::motion {

/// Gains of the middle group for the longest paths (`paths` = 2) and for the shortest (0), and the
/// gain of high frequencies in both. High frequencies are attenuated because they contain noise and
/// no emotional content.
inline constexpr double longest_middle_gain = 1.8;
inline constexpr double shortest_middle_gain = 0.3;
inline constexpr double high_gain = 0.3;

PathGains longest_path_gains();
PathGains shortest_path_gains();

/// Oversampling factor at which the finest band of a clip contains no frequencies of the middle
/// group: 4 at 30 frames per second, 1 from 50 on.
int oversampling(double frames_per_second);

/// Gains of single bands, finest first, from those of the groups. A band gets the gain of the group
/// that contains its peak frequency (the groups meet at 1 and 12.5 Hz, with smooth transitions of
/// half an octave). `rate_hz` is the sampling rate of the filtered signal. The list ends where all
/// further bands belong to the low group.
std::vector<double> band_gains(const PathGains& gains, double rate_hz);

/// Band gains for the signal of a clip.
struct BandWeights {
  std::vector<double> gains;  ///< per band, finest first
  double rest_gain = 1.0;     ///< gain of all lower frequencies
  int factor = 1;             ///< samples of the signal per frame (`oversampling`)
};

BandWeights band_weights(const PathGains& gains, double frames_per_second);

/// The clip with the bands of all its joint rotations weighted (Bruderlin and Williams 1995). The
/// root's path is unchanged, so feet may slide (see foot_repair.h). With direction vectors only the
/// ratios of the gains matter. Fingers, if there are any, keep their rotations or are weighted too.
Clip with_path_gains(const Clip& clip, const PathGains& gains, RotationSignal signal,
                     FingerPaths hands = FingerPaths::kept);

}  // namespace mien::motion
