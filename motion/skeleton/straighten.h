#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// What a video shows, and a clip file holds: a loop repeated, or in place.
struct Showing {
  int cycles = 3;  ///< of a loop
  bool in_place = false;
};

/// A loop is repeated; another clip is shown once. In place, both stay where they begin.
Clip shown_clip(const Clip& clip, const Showing& showing);

/// Horizontal unit vector along which the clip walks as a whole: the way from its first to its last
/// frame (a loop: its displacement) or, when that is slower than 0.1 m/s, where the pelvis faces on
/// the average.
Vec3 mean_direction(const Clip& clip);

/// The clip turned about the vertical and moved so that it walks along +Z and begins at z = 0. A
/// loop's path lies on the line x = 0 on the average; another clip starts at x = 0. Heights stay.
Clip straightened(const Clip& clip);

/// A loop without its way forward: the displacement is taken off evenly over the cycle, so that the
/// sway and surge within it stay.
Clip in_place(const Clip& loop);

/// Any clip kept where it begins. What goes straight and evenly loses its mean way, so that the
/// surge of its steps stays; of what starts, stops, turns or comes back the path below 1 Hz is
/// taken off. Headings stay: it turns on the spot.
Clip kept_in_place(const Clip& clip);

/// A loop in place sent on its way: `displacement` a cycle, metres, horizontal, evenly. The inverse
/// of `in_place`.
Clip travelling(const Clip& loop, const Vec3& displacement);

}  // namespace mien::motion
