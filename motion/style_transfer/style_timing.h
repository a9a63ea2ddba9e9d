#pragma once

#include <vector>

#include "motion/skeleton/example.h"

namespace mien::motion {

/// The keytimes, seconds, of a motion of `duration` seconds to which a style was transferred with
/// its timing: each keytime's share of the cycle changes by `amount` times the difference between
/// its shares in the styled and the neutral motion. Keytimes keep their order, at least a quarter
/// of their distance in `motion` apart. If the motions do not have equally many keytimes, shares
/// stay as they are.
std::vector<double> styled_keytimes(const Example& motion, const Example& neutral,
                                    const Example& styled, double amount, double duration);

/// The (fractional) frame of `motion` that corresponds to each of `frames` frames of a motion with
/// the given keytimes; exact at keytimes, monotone between them (time_warp.h).
std::vector<double> corresponding_frames(const Example& motion, const std::vector<double>& keytimes,
                                         int frames);

}  // namespace mien::motion
