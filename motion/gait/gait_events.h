#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A flight phase of running: an interval without ground contact between two plants.
struct Flight {
  int first = 0;
  int last = 0;                ///< inclusive
  bool takes_off_left = true;  ///< whether the left foot takes off, otherwise the right one
  bool lands_left = true;      ///< whether the left foot lands, otherwise the right one
};

/// The flight phases of a clip that does not loop: gaps of at least 0.06 s between plants. The mean
/// height of the pelvis in the gap must be above its mean over the gap and 0.4 s on either side
/// and, if the gap lasts 0.25 s or more, the pelvis must accelerate downwards by more than 4 m/s².
/// In walking, by contrast, the pelvis is lowest between two single supports, where a strict
/// contact threshold may also leave a gap.
std::vector<Flight> flights(const Clip& clip, const std::vector<FootPlant>& plants);

/// The changes from one foot to the other in running: the flights, followed by changes that last
/// less than 0.06 s or in which contacts overlap by less than 0.03 s, where the pelvis is high
/// (slow runs hardly fly). The latter may be empty or end before they begin.
std::vector<Flight> foot_changes(const Clip& clip, const std::vector<FootPlant>& plants);

struct GaitEvent {
  enum class Kind { heel_strike, toe_off };
  Kind kind = Kind::heel_strike;
  bool left = true;
  double frame = 0.0;  ///< fractional; by a parabola through the three nearest frames, or at the
                       ///< edge of a flight
  /// Contact of the foot begins (heel strike) or ends (toe off) within 0.1 s, or at a flight.
  bool confirmed = false;
};

/// Position of each foot relative to the pelvis along the walking direction, metres, one entry per
/// frame, low-pass filtered (`gait_cutoff_hz`). Heels are ankle joints, toes are toe joints.
struct FootProgress {
  std::vector<double> left_heel;
  std::vector<double> right_heel;
  std::vector<double> left_toe;
  std::vector<double> right_toe;
};

/// The walking direction in each frame, as horizontal unit vectors: the direction of the pelvis
/// velocity (low-pass filtered at 1 Hz) if its speed is more than 0.2 m/s, otherwise the facing
/// direction.
std::vector<Vec3> walking_directions(const Clip& clip);

FootProgress foot_progress(const Clip& clip);

/// Heel strikes and toe offs in order of time (Zeni et al. 2008): a heel strike is when the heel is
/// farthest in front of the pelvis, a toe off when the toe is farthest behind it. The toe off
/// before a flight is moved to the end of contact, and the heel strike after a flight to the
/// beginning of contact. The clip may walk in place. Events of a looping clip lie in [0, frames).
std::vector<GaitEvent> gait_events(const Clip& clip);

}  // namespace mien::motion
