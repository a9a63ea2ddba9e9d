#pragma once

#include <vector>

#include "motion/foot_lock.h"

namespace mien::motion {

/// The ankle, knee and toe joints of one leg.
struct LegJoints {
  BodyJoint hip, knee, ankle, toe;
};

LegJoints leg_joints(bool left);

/// The way of a foot through a clip: one entry a frame, world space.
struct FootPath {
  Vec3 ball_in_foot;  ///< toe joint, in the ankle's frame
  Vec3 heel_in_foot;  ///< back of the sole at the ball's height, in the ankle's frame
  std::vector<Vec3> ankle;
  std::vector<Quat> rotation;
  bool loops = false;
  Vec3 cycle_displacement = Vec3::Zero();

  int frame_count() const { return static_cast<int>(ankle.size()); }
  /// Any frame of a loop, in unrolled numbering: `frame` mod count, and displaced.
  int wrapped(int frame) const;
  Vec3 displacement(int frame) const;
  Vec3 ankle_at(int frame) const;
  Quat rotation_at(int frame) const;
  Vec3 ball_at(int frame) const;
  Vec3 heel_at(int frame) const;
};

FootPath foot_path(const Clip& clip, bool left);

/// Frames of a plant with the sole flat on the floor (`first` > `last` when it never is).
struct FlatSole {
  int first = 0;
  int last = -1;
};

FlatSole flat_sole(const FootPath& path, const FootPlant& plant, double tolerance_metres);

}  // namespace mien::motion
