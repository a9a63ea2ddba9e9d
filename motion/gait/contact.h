#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

struct ContactOptions {
  double height_metres = 0.04;         ///< maximum height of a point above its stance level
  double on_speed = 0.15;              ///< m/s; contact begins below this speed
  double off_speed = 0.3;              ///< m/s; contact ends above this speed
  double shortest_gap = 0.07;          ///< seconds; shorter gaps in a contact are closed
  double shortest_plant = 0.1;         ///< seconds; shorter contacts are dropped
  Vec3 floor_velocity = Vec3::Zero();  ///< m/s; velocity of the floor under a clip in place
};

/// Contact of the parts of one foot with the floor, one entry per frame (points of sole.h).
struct FootContact {
  std::vector<bool> heel;
  std::vector<bool> toes;  ///< the ball of the foot or the tip of the toes
  std::vector<bool> foot;  ///< heel or toes, with short gaps closed and short contacts dropped
};

/// Detects contact of one foot. A point of the foot is in contact while it is within
/// `height_metres` of its stance level (the 3rd percentile of its height) and slow; with
/// hysteresis, contact begins below `on_speed` and ends above `off_speed`. In looping clips,
/// contacts continue across the seam.
FootContact foot_contact(const Clip& clip, bool left, const ContactOptions& options = {});

/// The intervals of contact of both feet in order of time: the plants for `foot_locked`.
std::vector<FootPlant> foot_plants(const Clip& clip, const ContactOptions& options = {});

/// Velocity of the floor under a looping clip that walks in place, m/s, world space: the common
/// velocity of the planted feet. Zero for clips that are not in place or do not loop. Cycles cut
/// from a capture on a treadmill do not end exactly where they began: a loop is in place if it
/// moves by less than 0.1 m/s, and if it moves at all, only on a floor of 0.15 m/s or more.
Vec3 floor_velocity(const Clip& loop);

/// Whether a loop stays where it is: without displacement, or walking on a floor that moves.
bool stays_in_place(const Clip& clip);

}  // namespace mien::motion
