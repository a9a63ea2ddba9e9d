#pragma once

#include <array>
#include <optional>
#include <vector>

#include "motion/skeleton/pose.h"
#include "motion/steered_walk/stepping_leg.h"
#include "motion/steered_walk/walker_gaits.h"

namespace mien::motion {

/// What a walker is asked to do from now on.
struct Steering {
  double pace = 0.0;              ///< share of the mood's own speed; 0 stops; at most 1.2
  std::optional<double> heading;  ///< to face, radians about +Y from +Z; turns the shorter way
  double turning = 0.0;           ///< radians/s to the left, where no heading is asked for
  std::vector<double> moods;      ///< one a mood, ≥ 0; divided by their sum; none: the first mood
};

/// A walker at one moment. It walks without a plan: where each foot comes down is found, step by
/// step, from where its carriage will be if the steering stays (after the foot placement of Raibert
/// 1986), so it answers at once to any change. Nothing in it but numbers; a copy goes on by itself.
struct SteeredWalk {
  Carriage carriage;
  std::array<SteppingLeg, 2> legs;   ///< left, right
  std::vector<Followed> moods;       ///< shares, smoothed: of posture and arms
  std::vector<Followed> gaits;       ///< the same, slower: of legs and tempo
  bool stepping = false;             ///< else it stands, or comes to stand
  bool started = false;              ///< a foot has left the floor since it began to step
  double phase = 0.0;                ///< of the gait cycle, unwrapped; 0: left heel strike
  double phase_rate = 0.0;           ///< 1/s
  double rest_phase = 0.0;           ///< at which the phase comes to rest in standing
  double rest_stiffness = 3.0;       ///< 1/s
  Followed activity;                 ///< 0 stands … 1 walks
  Followed crouch;                   ///< of the pelvis, for legs that would not reach, metres
  Followed gaze;                     ///< of head and chest into the turn, radians
  std::array<Followed, 3> centring;  ///< x, z and heading as it comes to stand over its feet
  double seconds = 0.0;              ///< since it began: breath and sway
};

/// A walker that stands at a place on the floor (y = 0), facing a heading. Mood weights as in
/// Steering.
SteeredWalk standing_walker(const WalkerGaits& gaits, const Vec3& place = Vec3::Zero(),
                            double heading = 0.0, const std::vector<double>& moods = {});

/// `seconds` (≥ 0) later. Feet that stand never move; speed, turning, mood and every joint go on
/// without a jump however the steering jumps.
void advance(const WalkerGaits& gaits, const Steering& steering, double seconds,
             SteeredWalk& walker);

/// How it stands or walks now.
Pose pose_of(const WalkerGaits& gaits, const SteeredWalk& walker);

/// Whether it has come to stand: nothing but breath and sway moves.
bool at_rest(const SteeredWalk& walker);

}  // namespace mien::motion
