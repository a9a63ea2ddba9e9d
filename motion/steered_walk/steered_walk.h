#pragma once

#include <array>
#include <optional>
#include <vector>

#include "motion/skeleton/pose.h"
#include "motion/steered_walk/stepping_leg.h"
#include "motion/steered_walk/walker_gaits.h"

namespace mien::motion {

/// Control input of a walker.
struct Steering {
  double pace = 0.0;              ///< relative to the mood's own speed; 0 stops; at most 1.2
  std::optional<double> heading;  ///< radians about +Y from +Z; turns through the smaller angle
  double turning = 0.0;           ///< radians/s to the left, if no heading is requested
  std::vector<double> moods;  ///< weights ≥ 0, one per mood, of any sum; empty: the first mood
};

/// State of a walker. It plans no more than the next step: each foot placement is computed from the
/// predicted root motion under constant steering (after Raibert 1986), so it reacts to changes
/// immediately. A plain value; copies are independent.
struct SteeredWalk {
  RootMotion root;
  std::array<SteppingLeg, 2> legs;  ///< left, right
  std::vector<DampedSpring> moods;  ///< smoothed mood shares for posture and arms
  std::vector<DampedSpring> gaits;  ///< the same for legs and tempo, with more smoothing
  bool stepping = false;            ///< false while standing or coming to rest
  bool started = false;             ///< a foot has left the floor since stepping began
  double phase = 0.0;               ///< of the gait cycle, unwrapped; 0: left heel strike
  double phase_rate = 0.0;          ///< 1/s
  double rest_phase = 0.0;          ///< phase at which the gait cycle comes to rest in standing
  double rest_stiffness = 3.0;      ///< 1/s
  DampedSpring activity;            ///< 0 stands … 1 walks
  DampedSpring crouch;  ///< lowering of the pelvis where the legs would not reach the floor, metres
  DampedSpring gaze;    ///< rotation of head and chest into a turn, radians
  std::array<DampedSpring, 3> centring;  ///< x, z and heading while the body centres over its feet
  double seconds = 0.0;                  ///< time since the start, for breathing and sway
};

/// A walker that stands at a position on the floor (y = 0, metres), with a heading in radians. Mood
/// weights are as in Steering.
SteeredWalk standing_walker(const WalkerGaits& gaits, const Vec3& place = Vec3::Zero(),
                            double heading = 0.0, const std::vector<double>& moods = {});

/// Advances the walker by `seconds` (≥ 0). Planted feet never move; speed, turning, mood and all
/// joints are continuous however the steering changes.
void advance(const WalkerGaits& gaits, const Steering& steering, double seconds,
             SteeredWalk& walker);

/// The walker's present pose.
Pose pose_of(const WalkerGaits& gaits, const SteeredWalk& walker);

/// Whether the walker has come to rest, so that only breathing and sway remain.
bool at_rest(const SteeredWalk& walker);

}  // namespace mien::motion
