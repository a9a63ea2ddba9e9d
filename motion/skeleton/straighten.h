#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// How a clip is shown in a video and written to a clip file.
struct Playback {
  int cycles = 3;  ///< repetitions of a loop
  bool in_place = false;
};

/// The clip as shown: a loop repeated, another clip once; in place if requested.
Clip playback_clip(const Clip& clip, const Playback& playback);

/// Horizontal unit vector along which the clip walks as a whole: the way from its first to its last
/// frame (a loop: its displacement) or, when that is slower than 0.1 m/s, where the pelvis faces on
/// the average.
Vec3 mean_direction(const Clip& clip);

/// The clip turned about the vertical and moved so that it walks along +Z and begins at z = 0. A
/// loop's path lies on the line x = 0 on the average; another clip starts at x = 0. Heights stay.
Clip straightened(const Clip& clip);

/// A loop without its displacement, which is subtracted evenly over the cycle, so that sway and
/// surge within it stay.
Clip in_place(const Clip& loop);

/// Any clip converted to in-place motion. From a straight, even path the mean velocity is
/// subtracted, so that the surge of the steps stays; from others (starts, stops, turns) the path
/// below 1 Hz. Headings stay: the figure turns in place.
Clip kept_in_place(const Clip& clip);

/// A loop in place with an even horizontal `displacement` a cycle, metres: the inverse of
/// `in_place`.
Clip travelling(const Clip& loop, const Vec3& displacement);

}  // namespace mien::motion
