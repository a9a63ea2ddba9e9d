#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A flight phase of running: an interval between two plants without ground contact.
struct Flight {
  int first = 0;
  int last = 0;                ///< included
  bool takes_off_left = true;  ///< the foot that left the floor
  bool lands_left = true;
};

/// Gaps of at least 0.06 s between the plants of a clip that does not loop, in which the pelvis is
/// higher than over 0.4 s on either side and, where they last 0.25 s, falls. (In walking it is
/// lowest between two single supports, where a strict judgement of contact may also leave a gap.)
std::vector<Flight> flights(const Clip& clip, const std::vector<FootPlant>& plants);

struct GaitEvent {
  enum class Kind { heel_strike, toe_off };
  Kind kind = Kind::heel_strike;
  bool left = true;
  double frame = 0.0;      ///< between frames, by a parabola through the three nearest
  bool confirmed = false;  ///< the foot's contact begins (heel strike) or ends within 0.1 s of it
};

/// Position of each foot relative to the pelvis along the direction of walking, metres, frame by
/// frame, low-pass filtered (`gait_cutoff_hz`).
struct FootProgress {
  std::vector<double> left_heel;  ///< ankle joint
  std::vector<double> right_heel;
  std::vector<double> left_toe;
  std::vector<double> right_toe;
};

/// Direction of walking, frame by frame, as horizontal unit vectors: the pelvis' velocity below 1
/// Hz if that is more than 0.2 m/s, else its facing direction.
std::vector<Vec3> walking_directions(const Clip& clip);

FootProgress foot_progress(const Clip& clip);

/// Heel strikes and toe offs by time (Zeni et al. 2008): a heel strike is where the heel is
/// farthest before the pelvis, a toe off where the toe is farthest behind it. Works in place and
/// travelling. Events of a looping clip lie in [0, frames).
std::vector<GaitEvent> gait_events(const Clip& clip);

}  // namespace mien::motion
