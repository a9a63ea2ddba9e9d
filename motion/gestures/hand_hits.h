#pragma once

#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A moment at which a hand hits something and stops or turns back: a door, a table, the other
/// hand.
struct HandHit {
  bool left = true;
  int frame = 0;
  double speed = 0.0;         ///< m/s: the highest, relative to the hips, before the hit
  double deceleration = 0.0;  ///< m/s²: the highest between that moment and the hit
  /// Frames from the last turn of the hand to the hit, and from the hit to the next turn, where it
  /// is drawn back between hits and nearly stands; 0 if it is not within a quarter of a second.
  int since_turn = 0;
  int until_turn = 0;
};

/// What counts as a hit: a movement that stops within a tenth of a second, repeatedly at the same
/// place. All values are our own choice.
struct HandHitOptions {
  double least_speed = 0.4;         ///< m/s
  double longest_stop = 0.1;        ///< seconds, from the highest speed to the hit
  double least_deceleration = 8.0;  ///< m/s²
  /// Least deceleration in medians of the acceleration. At 30 frames per second hits of synthesized
  /// hands are at 4.2 or more, and a wave is at 1.4.
  double least_share = 3.5;
  double single_deceleration = 40.0;  ///< m/s²: of a hit that no other repeats
  double repeat_metres = 0.03;        ///< repeated hits are at most this far apart
  double hands_together = 0.3;        ///< metres between the wrists when the hands meet
};

/// The hits of both hands, in the order of their frames, after the wrists' paths relative to the
/// hips, low-pass filtered at 12.5 Hz. A hand that turns back hits something if it moved away from
/// its shoulder, downwards, or towards the other hand: at the ends of a wave, which are as sudden,
/// it moves sideways. Of the canonical body.
std::vector<HandHit> hand_hits(const Clip& clip, const HandHitOptions& options = {});

}  // namespace mien::motion
