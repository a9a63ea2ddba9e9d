#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "motion/gait/gait_events.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

inline constexpr int gait_keytime_count = 7;

/// One gait cycle of a clip.
///
/// Keytimes are seconds after the left heel strike: left heel strike (0), right toe off, left
/// mid-stance (the right ankle passes the left; where, limping, it only comes up to it, half of its
/// way), right heel strike, left toe off, right mid-stance,
/// next left heel strike (the period). In running the toe offs come before the other foot's strike;
/// they then stand one frame after it, so that the keytimes always ascend.
struct GaitCycle {
  int start_frame = 0;       ///< nearest frame to the first heel strike
  int end_frame = 0;         ///< nearest frame to the same foot's next heel strike
  bool starts_left = true;   ///< cut at left heel strikes; else at right ones, as short takes need
  double left_strike = 0.0;  ///< frame of the left heel strike in [start_frame, end_frame)
  std::array<double, gait_keytime_count> keytimes{};
  double speed_m_s = 0.0;   ///< pelvis displacement over the cycle by the period
  bool is_half = false;     ///< one step only; the other is its mirror image (`mirrored_loop`)
  bool has_flight = false;  ///< running: both feet off the floor between toe off and strike
  double steadiness = 0.0;  ///< 0–1; 1: constant speed, straight, of typical period, seamless
  std::vector<std::string> warnings;  ///< plain sentences
};

/// All complete cycles by time: from left heel strike to left heel strike or, when there is no such
/// pair, from right to right. Feet that stay where they are take no steps: there is none in
/// standing.
std::vector<GaitCycle> gait_cycles(const Clip& clip);

/// The steadiest cycle; empty when the clip holds none that is a walk or run (steadiness ≥ 0.1). A
/// take too short for two strikes of one foot gives the two moments, 0.5–2 s apart, at which the
/// pose is most alike, when a left and a right step lie between.
std::optional<GaitCycle> steadiest_cycle(const Clip& clip);

/// The cycle of a looping clip that contains exactly one: start 0, end its frame count. Empty when
/// the loop has not exactly one heel strike of either foot.
std::optional<GaitCycle> cycle_of_loop(const Clip& loop);

}  // namespace mien::motion
