#pragma once

#include "motion/procedural/walk_style.h"
#include "motion/skeleton/body.h"

namespace mien::motion {

/// The points of a foot that touch the floor, in the ankle's frame (sole flat, toes along +Z), and
/// how high the joints stand when it does. Metres.
struct FootShape {
  double ankle_height;  ///< above the floor, sole flat
  Vec3 heel;            ///< the edge the foot rolls on after heel strike
  Vec3 ball;            ///< the toe joint, about which the heel rises
  double ball_height;   ///< above the floor, sole flat
  double toe_length;    ///< from the toe joint to the tip
};

/// The shape of the foot below `ankle`, with the sole of sole.h.
FootShape foot_shape(const Skeleton& body, BodyJoint ankle);

/// A foot at one moment. Angles in radians.
struct FootPose {
  Vec3 ankle = Vec3::Zero();   ///< position
  double yaw = 0.0;            ///< about +Y from +Z
  double pitch = 0.0;          ///< of the sole, toes up
  double toe_extension = 0.0;  ///< of the toes on the foot, up
};

/// The foot's rotation in the world.
Quat foot_rotation(const FootPose& foot);

/// Pitch of the sole through the stance, radians: from toes up at heel strike to flat, then heel up
/// to toe off. Continuous with its first derivative; at phase 0 and at the end of stance it has the
/// slopes that the swing must meet.
double stance_pitch(const WalkStyle& style, double phase);

/// Offsets from the ankle to the pivot of a rolling foot, in world axes.
struct FootRoll {
  Vec3 flat_pivot;  ///< while the sole is flat
  Vec3 pivot;       ///< at the present pitch
};

/// The pivot of a foot at a pitch of its sole: the heel's edge (toes up) or the ball (heel up).
FootRoll foot_roll(const FootShape& shape, double yaw, double pitch);

/// The ankle of a foot rolled so over a print (see `rolled_foot`).
Vec3 rolled_ankle(const FootShape& shape, const Vec3& print, const FootRoll& roll);

/// The foot on the floor at a pitch of its sole, rolled there about the heel's edge (toes up) or
/// the ball (heel up, toes left flat). `print` is where the ankle's plumb line meets the floor
/// while the sole is flat: what the foot stands on stays there at every pitch.
FootPose rolled_foot(const FootShape& shape, const Vec3& print, double yaw, double pitch);

/// The foot while it is on the floor, rolling without slipping: on the heel's edge, then flat, then
/// on the ball with the toes left flat. `phase` ∈ [0, stance_share] counts from the heel strike;
/// `print` is where the ankle's plumb line meets the floor while the sole is flat.
FootPose stance_foot(const FootShape& shape, const WalkStyle& style, const Vec3& print, double yaw,
                     double phase);

/// Height of the toes (the lower of toe joint and tip) above their height when the foot stands
/// flat, metres.
double toe_clearance(const FootShape& shape, const FootPose& foot);

/// Height of the heel's edge above the floor, metres.
double heel_clearance(const FootShape& shape, const FootPose& foot);

}  // namespace mien::motion
