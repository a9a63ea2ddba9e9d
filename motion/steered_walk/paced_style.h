#pragma once

#include "motion/procedural/walk_style.h"

namespace mien::motion {

/// The style at a share of its own speed, from 0 (stepping on the spot) to 1.3: cadence falls to
/// 0.72 of its own at 0, the rest is step length. With shorter steps the feet strike, leave the
/// floor and swing less, the body bounces and turns less, arms hang; postures stay. Feet are set
/// wider apart and stand for longer (after Murray et al. 1984; Winter 1991). 1 is the style itself.
///
/// `at_pace` (affective_walk.h) changes step and cadence alike, as people do who walk slowly for
/// long; this is how they walk for a step or two, before they stop or when they have just started.
WalkStyle paced_style(const WalkStyle& style, double pace);

/// The posture of the style without its movements: for standing. The feet are as wide apart as at
/// pace 0.
WalkStyle standing_style(const WalkStyle& style);

}  // namespace mien::motion
