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
/// Keytimes are in seconds after the left heel strike: left heel strike (0), right toe off, left
/// mid-stance, right heel strike, left toe off, right mid-stance, next left heel strike (the
/// period). At left mid-stance the right ankle passes the left one; in a limp in which it does not
/// pass, it is halfway between its positions (relative to the left ankle) at the start and at the
/// end of the step. In running, each toe off precedes the strike of the other foot; its keytime is
/// then set to one frame after the strike, so that keytimes always ascend.
struct GaitCycle {
  int start_frame = 0;  ///< frame nearest to the heel strike or similar pose at the start
  int end_frame = 0;    ///< frame nearest to the next strike of this foot (`is_half`: of the other)
  bool starts_left = true;   ///< cut at left heel strikes; false: at right ones or at similar poses
  double left_strike = 0.0;  ///< frame of the left heel strike; < end_frame unless `is_half`
  std::array<double, gait_keytime_count> keytimes{};
  double speed_m_s = 0.0;   ///< pelvis displacement over the cycle divided by the period
  bool is_half = false;     ///< one step only; the other is its mirror image (`mirrored_loop`)
  bool has_flight = false;  ///< running: both feet off the floor between toe off and strike
  double steadiness = 0.0;  ///< 0–1; 1: constant speed, straight, typical period, no visible seam
  std::vector<std::string> warnings;  ///< sentences
};

/// All complete cycles in order of time: from left heel strike to left heel strike or, if there are
/// none of these, from right to right; of a loop, the result of `cycle_of_loop`. Feet that stay in
/// place take no steps, so a standing motion has no cycles.
std::vector<GaitCycle> gait_cycles(const Clip& clip);

/// The steadiest cycle; empty if no cycle is a walk or run (steadiness ≥ 0.1). In a take without
/// cycles that lasts up to 4 s, the cycle extends between the two most similar poses, 0.5–2 s
/// apart, if they are similar enough and enclose a left and a right step. Otherwise, one step and
/// its mirror image are used (`is_half`): of runs the steadiest one (steadiest_step.h), else the
/// last.
std::optional<GaitCycle> steadiest_cycle(const Clip& clip);

/// The cycle of a looping clip that contains exactly one gait cycle: `start_frame` is 0,
/// `end_frame` the frame count. Empty if the loop does not have exactly one heel strike of each
/// foot.
std::optional<GaitCycle> cycle_of_loop(const Clip& loop);

}  // namespace mien::motion
