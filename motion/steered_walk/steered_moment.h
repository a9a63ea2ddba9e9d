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

/// Shares of the moods, which sum to 1: those requested (`asked` as in Steering::moods), and those
/// to which the walker has come so far.
std::vector<double> mood_goals(const std::vector<double>& asked, std::size_t moods);
std::vector<double> shares_of(const std::vector<DampedSpring>& moods);

/// Lifts the heels of standing feet as far as the legs need to reach them, and lowers the pelvis
/// smoothly by the remaining distance.
void follow_reach(const SteeredMoment& moment, double seconds, SteeredWalk& walker);

}  // namespace mien::motion
