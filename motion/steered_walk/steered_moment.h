#pragma once

#include <array>
#include <vector>

#include "motion/steered_walk/steered_walk.h"

namespace mien::motion {

/// The gait of a steered walker at one time, and its leg cycles for straight walking.
struct SteeredMoment {
  FittedGait gait;
  WalkStyle upper;  ///< style of trunk, head and arms, which follow the mood faster
  std::array<LegCycle, 2> legs;
};

SteeredMoment moment_at(const WalkerGaits& gaits, const SteeredWalk& walker);

/// Shares of the moods, which sum to 1: those requested (`asked` as in Steering::moods), and the
/// present values of a walker's springs.
std::vector<double> mood_goals(const std::vector<double>& asked, std::size_t moods);
std::vector<double> shares_of(const std::vector<DampedSpring>& moods);

/// Lifts the heels of standing feet until the legs reach the feet, and lowers the pelvis by the
/// remaining distance, both smoothly over time; `seconds` have passed since the last call.
void follow_reach(const SteeredMoment& moment, double seconds, SteeredWalk& walker);

}  // namespace mien::motion
