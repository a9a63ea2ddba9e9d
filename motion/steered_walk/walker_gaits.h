#pragma once

#include <span>
#include <vector>

#include "motion/steered_walk/fitted_gait.h"

namespace mien::motion {

/// A way of walking from standing to fast, all on one body: what is blended while it is played.
struct MoodGaits {
  double speed_m_s = 0.0;  ///< at pace 1
  FittedGait standing;
  std::vector<FittedGait> paced;  ///< at the paces of `gait_paces`
};

/// Shares of a style's own speed at which it is fitted; between them gaits are blended.
inline constexpr std::array<double, 6> gait_paces = {0.0, 0.25, 0.5, 0.75, 1.0, 1.2};

/// Everything that a walker under control can do: several moods in correspondence, which differ in
/// their styles alone, on one body.
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
