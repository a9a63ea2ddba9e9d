#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Options for showing a clip in a video or writing it to a clip file.
struct Playback {
  int cycles = 3;  ///< repetitions of a loop
  bool in_place = false;
};

/// The clip as played back: a loop repeated, any other clip once; in place if requested.
Clip playback_clip(const Clip& clip, const Playback& playback);

/// Horizontal unit vector of the overall direction of travel: from the first to the last root
/// position (for a loop, its displacement) or, if the mean speed is below 0.1 m/s, the mean facing
/// direction of the pelvis.
Vec3 mean_direction(const Clip& clip);

/// The clip rotated about the vertical and translated so that it walks along +Z and begins at z =
/// 0. The mean x of a loop's path is 0; any other clip starts at x = 0. Heights are unchanged.
Clip straightened(const Clip& clip);

/// A loop with its displacement subtracted evenly over the cycle; sway and surge within the cycle
/// are kept.
Clip in_place(const Clip& loop);

/// Any clip converted to in-place motion. If its path is straight and its speed even, the motion at
/// the mean velocity is subtracted, which keeps the surge of the steps. Otherwise (starts, stops,
/// turns), a copy of the path, low-pass filtered at 1 Hz, is subtracted. Headings are kept: the
/// figure turns in place.
Clip kept_in_place(const Clip& clip);

/// An in-place loop with a uniform horizontal `displacement` per cycle added, metres: the inverse
/// of `in_place`.
Clip travelling(const Clip& loop, const Vec3& displacement);

}  // namespace mien::motion
