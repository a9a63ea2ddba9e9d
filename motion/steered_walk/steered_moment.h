#pragma once

#include <array>
#include <vector>

#include "motion/steered_walk/steered_walk.h"

namespace mien::motion {

/// The gait of a walker under control at one moment, and its legs as they would walk on straight.
struct SteeredMoment {
  FittedGait gait;
  WalkStyle upper;  ///< of trunk, head and arms, which follow the mood sooner
  std::array<LegCycle, 2> legs;
};

SteeredMoment moment_at(const WalkerGaits& gaits, const SteeredWalk& walker);

/// Shares of the moods that sum to 1: of what was asked for, and as they are now.
std::vector<double> mood_goals(const std::vector<double>& asked, std::size_t moods);
std::vector<double> shares_of(const std::vector<Followed>& moods);

/// Lifts the heels of standing feet as far as their legs need it to reach them, and lets the pelvis
/// sink, smoothly, by what they lately could not.
void follow_reach(const SteeredMoment& moment, double seconds, SteeredWalk& walker);

}  // namespace mien::motion
