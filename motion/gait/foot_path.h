#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The joints of one leg.
struct LegJoints {
  BodyJoint hip, knee, ankle, toe;
};

LegJoints leg_joints(bool left);

/// The trajectory of a foot through a clip, one entry per frame, world space, metres.
struct FootPath {
  Vec3 ball_in_foot;           ///< toe joint, in the ankle's frame
  Vec3 heel_in_foot;           ///< back of the sole at the height of the ball, in the ankle's frame
  std::vector<Vec3> ankle;     ///< positions of the ankle joint
  std::vector<Quat> rotation;  ///< rotations of the ankle joint
  double sole_depth = 0.0;     ///< depth of the sole below ball_in_foot and heel_in_foot
  bool loops = false;
  Vec3 cycle_displacement = Vec3::Zero();

  int frame_count() const { return static_cast<int>(ankle.size()); }
  /// The frame of the clip for a frame of the unrolled loop: `frame` mod frame count. Clamped if
  /// the clip does not loop.
  int wrapped(int frame) const;
  Vec3 displacement(int frame) const;  ///< displacement by complete laps of the loop
  Vec3 ankle_at(int frame) const;
  Quat rotation_at(int frame) const;
  Vec3 ball_at(int frame) const;
  Vec3 heel_at(int frame) const;
};

FootPath foot_path(const Clip& clip, bool left);

/// The phases of a plant: heel contact, flat foot, heel off (on the ball). Frame numbers,
/// inclusive.
struct Stance {
  int first = 0;       ///< first frame with the heel on the floor
  int flat_first = 0;  ///< first frame with the whole sole on the floor
  int flat_last = 0;   ///< last frame with the whole sole on the floor
  int last = 0;        ///< last frame with the ball on the floor
};

/// The phases of a plant, within the frames of the plant. The sole is flat while heel and ball are
/// both less than `flat_metres` above their lowest positions. The heel or ball is on the floor
/// while it is less than `lifted_metres` above its height at flat foot. A foot that never becomes
/// flat (running on the toes, or never level in a noisy capture) is treated as flat in the frame in
/// which the greater of the heights of heel and ball, each above its lowest position, is least.
Stance stance_of(const FootPath& path, const FootPlant& plant, double flat_metres,
                 double lifted_metres);

}  // namespace mien::motion
