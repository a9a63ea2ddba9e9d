#pragma once

#include <array>
#include <span>
#include <vector>

#include "motion/procedural/leg_cycle.h"

namespace mien::motion {

/// Results of the search of `fit_swing` for a leg; members as in LegCycle (leg_cycle.h).
struct FittedSwing {
  double knee_peak = 0.0;
  double lift = 0.0;
  double landing = 0.0;
};

/// A style fitted to a body: the expensive part of a gait as plain numbers, so that gaits can be
/// blended at run time.
struct FittedGait {
  WalkStyle style;              ///< its lengths are those of the body, not for a stature of 1.75 m
  double mean_height_m = 0.0;   ///< of the pelvis joint
  double passing_phase = 0.25;  ///< phase after heel strike when the pelvis passes the footprint
  double ahead_m = 0.0;  ///< forward distance from the pelvis to the footprint at `passing_phase`
  std::array<FittedSwing, 2> swings;  ///< left, right
};

/// Fits the style to the body, with the pelvis at the same height and offset from the feet as in
/// the parametric walker (walker_legs.h). Throws mien::Error if its steps are too long for the
/// legs.
FittedGait fit_gait(const WalkStyle& style, const Skeleton& body);

/// Standing in the posture of the style, with the body over the middle of the feet.
FittedGait fit_standing(const WalkStyle& style, const Skeleton& body);

/// The weighted mean of gaits; the weights sum to 1.
FittedGait blended(std::span<const FittedGait> gaits, std::span<const double> weights);

/// The cycles of both legs for straight walking at a speed, with fitted swings. The pelvis is at z
/// = stride · phase (apart from surge); left heel strike is at phase 0.
std::array<LegCycle, 2> legs_of(const FittedGait& gait, const Skeleton& body, double speed_m_s);

/// Gaits of one mood on one body, from standing to fast, to be blended at run time.
struct MoodGaits {
  double speed_m_s = 0.0;  ///< at pace 1
  FittedGait standing;
  std::vector<FittedGait> paced;  ///< one gait per pace in `gait_paces`
};

/// Paces (relative to a style's own speed) at which the style is fitted; gaits are blended in
/// between.
inline constexpr std::array<double, 6> gait_paces = {0.0, 0.25, 0.5, 0.75, 1.0, 1.2};

/// Gaits of a steered walker on one body, for one or more moods.
struct WalkerGaits {
  Skeleton body;
  std::vector<MoodGaits> moods;
};

/// Fits the styles to the body (about 10 ms per gait). Throws mien::Error if no style is given, or
/// if steps are too long for the legs (walker.h).
WalkerGaits fit_walker(std::span<const WalkStyle> moods, const Skeleton& body);

/// The mean speed of the moods at pace 1, m/s. Weights sum to 1, as in `gait_at`.
double own_speed(const WalkerGaits& gaits, std::span<const double> moods);

/// The gait at a speed, between standing (activity 0) and walking (1).
FittedGait gait_at(const WalkerGaits& gaits, std::span<const double> moods, double speed_m_s,
                   double activity);

}  // namespace mien::motion
