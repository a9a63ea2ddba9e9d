#pragma once

#include <string_view>
#include <vector>

#include "motion/procedural/walk_style.h"

namespace mien::motion {

/// Coordinates of an emotion: valence (pleasure) and arousal (activation), each in [−1, 1].
struct Emotion {
  std::string_view name;
  double valence;
  double arousal;
};

/// Nine emotions at their angles on the circumplex of affect (Russell 1980, circular scaling):
/// happy 7.8°, excited 48.6°, tense 92.8°, afraid 116.0°, frustrated 141.1°, sad 207.5°, bored
/// 241.9°, tired 267.7°, calm 316.2°; all at distance 1 from the origin.
std::vector<Emotion> circumplex_emotions();

/// The walk style of an emotional state.
///
/// Arousal raises speed and cadence, widens the arm swing and flexes the elbows. Valence lifts
/// chest and head, and adds bounce, arm swing and trunk rotation. Two interaction terms increase
/// with unpleasantness: tension = max(arousal, 0)·(1 − valence)/2 raises the shoulders, flexes
/// elbows and knees, and makes arms and trunk swing more abruptly (WalkStyle::sharpness); weariness
/// = max(−arousal, 0)·(1 − valence)/2 slumps the trunk, lowers foot clearance and adds sway. (0, 0)
/// is an ordinary walk. Signs after Montepare et al. 1987, Roether et al. 2009, Michalak et al.
/// 2009, Barliya et al. 2013.
WalkStyle affective_walk(double valence, double arousal);

/// The same style `factor` times as fast: step length and cadence are each multiplied by the square
/// root of `factor`, and dependent parameters change as in `ordinary_walk`.
WalkStyle at_pace(const WalkStyle& style, double factor);

}  // namespace mien::motion
