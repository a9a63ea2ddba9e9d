#pragma once

#include <array>
#include <optional>

#include "motion/gait/gait.h"

namespace mien::motion {

/// The keytimes of a run with its flight phases, seconds after the left heel strike: left heel
/// strike (0), left mid-stance, left toe off, right heel strike, right mid-stance, right toe off,
/// next left heel strike (the period); at least one frame apart. Between a toe off and the next
/// strike the body flies. The keytimes of gait.h have the order of walking, in which each toe off
/// follows the other foot's strike, and cannot say when a flight begins.
///
/// `loop` contains exactly one gait cycle and begins at its left heel strike. Empty if it does not
/// contain one, or if a toe off follows the other foot's strike by more than 0.02 s, as in walking.
std::optional<std::array<double, gait_keytime_count>> flight_keytimes(const Clip& loop);

}  // namespace mien::motion
