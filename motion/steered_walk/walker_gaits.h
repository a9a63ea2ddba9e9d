#pragma once

#include <array>
#include <span>
#include <vector>

#include "motion/procedural/leg_cycle.h"

namespace mien::motion {

/// Results of the search of `fit_swing` (leg_cycle.h) for a leg.
struct FittedSwing {
  double knee_peak = 0.0;
  double lift = 0.0;
  double landing = 0.0;
};

/// A style fitted to a body: the expensive part of a gait as plain numbers, so that gaits can be
/// blended at run time.
struct FittedGait {
  WalkStyle style;              ///< lengths of the body, not of 1.75 m
  double mean_height_m = 0.0;   ///< of the pelvis joint
  double passing_phase = 0.25;  ///< of the cycle after heel strike: the pelvis passes the print
  double ahead_m = 0.0;         ///< of the print before the pelvis as it is passed
  std::array<FittedSwing, 2> swings;  ///< left, right
};

/// The style on the body, as high and as well placed over its feet as the walker walks
/// (walker_legs.h). Throws mien::Error when its steps are too long for the legs.
FittedGait fit_gait(const WalkStyle& style, const Skeleton& body);

/// Standing in the posture of the style: the weight lies over the middle of the feet.
FittedGait fit_standing(const WalkStyle& style, const Skeleton& body);

/// The mean of gaits by weights that sum to 1.
FittedGait blended(std::span<const FittedGait> gaits, std::span<const double> weights);

/// Both legs of the gait as they walk straight on at a speed: the swings continue the stances. The
/// pelvis is at z = stride · phase (surge aside), the left foot strikes at phase 0.
std::array<LegCycle, 2> legs_of(const FittedGait& gait, const Skeleton& body, double speed_m_s);

/// Gaits of one mood from standing to fast, on one body, to be blended at run time.
struct MoodGaits {
  double speed_m_s = 0.0;  ///< at pace 1
  FittedGait standing;
  std::vector<FittedGait> paced;  ///< at the paces of `gait_paces`
};

/// Shares of a style's own speed at which it is fitted; between them gaits are blended.
inline constexpr std::array<double, 6> gait_paces = {0.0, 0.25, 0.5, 0.75, 1.0, 1.2};

/// Gaits of a steered walker: several moods in correspondence, which differ in style only, on one
/// body.
struct WalkerGaits {
  Skeleton body;
  std::vector<MoodGaits> moods;
};

/// Fits the styles to the body (some 10 ms each). Throws mien::Error without a style, and when
/// steps are too long for the legs (walker.h).
WalkerGaits fit_walker(std::span<const WalkStyle> moods, const Skeleton& body);

/// The mean speed of the moods at pace 1, m/s. Weights sum to 1, here and below.
double own_speed(const WalkerGaits& gaits, std::span<const double> moods);

/// The gait at a speed, between standing (activity 0) and walking (1).
FittedGait gait_at(const WalkerGaits& gaits, std::span<const double> moods, double speed_m_s,
                   double activity);

}  // namespace mien::motion
