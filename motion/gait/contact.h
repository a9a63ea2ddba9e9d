#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

struct ContactOptions {
  double height_metres = 0.04;         ///< above the point's own stance level
  double on_speed = 0.15;              ///< m/s below which contact begins
  double off_speed = 0.3;              ///< m/s above which it ends
  double shortest_gap = 0.07;          ///< seconds; shorter gaps are closed
  double shortest_plant = 0.1;         ///< seconds; shorter contacts are dropped
  Vec3 floor_velocity = Vec3::Zero();  ///< m/s; of the floor under a clip in place
};

/// Contact of the parts of one foot with the floor, frame by frame (points of sole.h).
struct FootContact {
  std::vector<bool> heel;
  std::vector<bool> toes;  ///< ball or tip
  std::vector<bool> foot;  ///< either, short gaps closed and short contacts dropped
};

/// A point of the foot touches while it is within `height_metres` of its stance level (third
/// percentile of its height) and slow, with hysteresis of speed: below `on_speed` it begins, above
/// `off_speed` it ends. Contacts of a looping clip run on over its seam.
FootContact foot_contact(const Clip& clip, bool left, const ContactOptions& options = {});

/// The stretches of contact of both feet by time, as `foot_locked` takes them.
std::vector<FootPlant> foot_plants(const Clip& clip, const ContactOptions& options = {});

/// Velocity of the floor under a looping clip that walks in place: the common velocity of the
/// planted feet. Zero for clips that travel or have no planted foot.
Vec3 floor_velocity(const Clip& loop);

}  // namespace mien::motion
