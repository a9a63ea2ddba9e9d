#pragma once

#include <vector>

#include "motion/dynamics/body_height.h"
#include "motion/dynamics/retiming.h"
#include "motion/gait/gait_events.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// How a motion is carried by the floor, in its own time, before its tempo is changed.
struct Carriage {
  std::vector<FootPlant> plants;
  std::vector<Airborne> flights;  ///< take-offs of a loop lie in [0, frames)
  bool travels = false;
  double speed = 0.0;           ///< m/s over the floor
  double leg = 0.9;             ///< length of the legs, metres
  double double_support = 0.0;  ///< share of the time in which both feet stand

  bool walks() const { return travels && flights.empty(); }
};

/// The flights in another time: from the last frame on the floor to the next one on it.
std::vector<Airborne> retimed(const std::vector<Airborne>& flights, const Retiming& retiming);

/// How the clip is carried: it must not walk in place; `plants` are its foot plants (gait_plants.h)
/// and `way` the distance that it travels, metres, 0 if it stays.
Carriage carriage_of(const Clip& clip, const std::vector<FootPlant>& plants, double way);

/// Factor on the length of steps at a tempo: people who are free to choose make longer steps at a
/// higher cadence. With steps as long as speed to the power of 0.42 (Grieve 1968), they are as long
/// as cadence to the power of 0.72. Walks remain walks: they become no faster than at a Froude
/// number v²/(g·leg) of 0.5, where people begin to run (Alexander 1989).
double step_factor(double tempo, const Carriage& carriage);

/// Factors on the durations of the intervals between frames of the original, for `retiming`. In
/// walks whose speed changes, both feet stand for a smaller or larger share of the time, as in
/// people (0.18 less at 1.35 m/s more; walk_style.h), but not for less than 0.12. Flights become no
/// longer than 0.8 s, the highest jumps of people, or than they are.
std::vector<double> stretched_contacts(int frame_count, double frames_per_second, bool loops,
                                       const Tempo& tempo, const Carriage& carriage);

/// The clip of a motion that travels with steps of another length: the ankles' distances from the
/// pelvis along the line of travel, less their mean, are multiplied by the step factor of the tempo
/// in each frame. Feet slide until they are repaired (foot_repair.h). Unchanged if it does not
/// travel.
Clip with_steps_at_tempo(const Clip& clip, const Tempo& tempo, const Retiming& retiming,
                         const Carriage& carriage);

/// The clip, already in its new time and with feet in place, with the heights of its centre of mass
/// as gravity has them. `played`: the heights that they have without it and with steps of the
/// original's length, metres, one per frame. In walks, whose legs are pendulums, deviations of
/// these from their slow path (below 0.5 Hz in the original) grow with the square of the steps, as
/// far as the body accelerates downwards by less than 0.7 g. In all other motions they grow with
/// the square of the duration, so that vertical accelerations, and with them the forces on the
/// floor, are those of the original. Flights are ballistic.
Clip with_gravity_kept(const Clip& clip, const std::vector<double>& played, const Tempo& tempo,
                       const Retiming& retiming, const Carriage& carriage);

}  // namespace mien::motion
