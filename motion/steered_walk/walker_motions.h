#pragma once

#include <vector>

#include "motion/procedural/walk_style.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// What a walker does besides walking on, as takes that do not loop, each beginning and ending in
/// standing or in a steady walk, along +Z from the origin: "stand" (4 s), "start", "walk", "stop",
/// "curve-left" and "curve-right" (at 45°/s), "wide-left" and "wide-right" (at 20°/s), "turn-left",
/// "turn-right" (90° on the spot) and "about-turn". For a motion graph. Throws as `fit_walker`
/// (walker_gaits.h), and for frame rates that are not positive.
std::vector<Clip> walker_motions(const WalkStyle& style, double frames_per_second,
                                 const Skeleton& body);

}  // namespace mien::motion
