#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The ankle, knee and toe joints of one leg.
struct LegJoints {
  BodyJoint hip, knee, ankle, toe;
};

LegJoints leg_joints(bool left);

/// The trajectory of a foot through a clip: one entry for each frame, world space.
struct FootPath {
  Vec3 ball_in_foot;  ///< toe joint, in the ankle's frame
  Vec3 heel_in_foot;  ///< back of the sole at the ball's height, in the ankle's frame
  std::vector<Vec3> ankle;
  std::vector<Quat> rotation;
  double sole_depth = 0.0;  ///< of the sole below ball_in_foot and heel_in_foot, metres
  bool loops = false;
  Vec3 cycle_displacement = Vec3::Zero();

  int frame_count() const { return static_cast<int>(ankle.size()); }
  /// Frame of the loop for any frame number of the unrolled loop: `frame` mod count.
  int wrapped(int frame) const;
  Vec3 displacement(int frame) const;
  Vec3 ankle_at(int frame) const;
  Quat rotation_at(int frame) const;
  Vec3 ball_at(int frame) const;
  Vec3 heel_at(int frame) const;
};

FootPath foot_path(const Clip& clip, bool left);

/// The phases of a plant: heel contact, flat foot, heel off (on the ball).
struct Stance {
  int first = 0;       ///< heel on the floor from here …
  int flat_first = 0;  ///< … the whole sole from here …
  int flat_last = 0;   ///< … to here, …
  int last = 0;        ///< … and the ball to here. Frames, all included
};

/// The plant's stance. Its ends lie within the plant: heel and ball count as on the floor while
/// they are less than `lifted_metres` above their height under the flat sole, the sole as flat
/// while both are less than `flat_metres` above their lowest. A foot that never comes down flat
/// (running on the toes, or never level in a noisy capture) counts as flat where the
/// higher of both is least.
Stance stance_of(const FootPath& path, const FootPlant& plant, double flat_metres,
                 double lifted_metres);

}  // namespace mien::motion
