#pragma once

#include "motion/procedural/walk_style.h"
#include "motion/skeleton/body.h"

namespace mien::motion {

/// The points about which a foot rolls, in the ankle's frame (sole flat, toes along +Z), and the
/// joint heights of a flat foot. Metres.
struct FootShape {
  double ankle_height;  ///< above the floor, sole flat
  Vec3 heel;            ///< the edge on which the foot rolls after heel strike
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
  double toe_extension = 0.0;  ///< of the toes relative to the foot, up
};

/// The foot's rotation in the world.
Quat foot_rotation(const FootPose& foot);

/// Pitch of the sole during stance, radians: toes up at heel strike, then flat, then heel up until
/// toe off. `phase` is measured from heel strike, 0 to stance_share. The pitch is continuously
/// differentiable.
double stance_pitch(const WalkStyle& style, double phase);

/// Offsets from the ankle to the pivot of a rolling foot, in world axes.
struct FootRoll {
  Vec3 flat_pivot;  ///< while the sole is flat
  Vec3 pivot;       ///< at the present pitch
};

/// The pivot of a foot at a pitch of its sole: the heel's edge (toes up) or the ball (heel up).
FootRoll foot_roll(const FootShape& shape, double yaw, double pitch);

/// Position of the ankle of a foot with this roll over a footprint (see `rolled_foot`).
Vec3 rolled_ankle(const FootShape& shape, const Vec3& print, const FootRoll& roll);

/// The foot on the floor at a given pitch of its sole, rolled about the heel's edge (toes up) or
/// the ball (heel up, toes flat). `print` is the footprint: the vertical projection of the ankle on
/// the floor while the sole is flat. The pivot does not move with the pitch.
FootPose rolled_foot(const FootShape& shape, const Vec3& print, double yaw, double pitch);

/// The foot while it is on the floor, rolling without slipping: on the heel's edge, then flat, then
/// on the ball with the toes flat. `phase` ∈ [0, stance_share] is measured from heel strike;
/// `print` is as in `rolled_foot`.
FootPose stance_foot(const FootShape& shape, const WalkStyle& style, const Vec3& print, double yaw,
                     double phase);

/// Height of the toes (the lower of toe joint and tip) above their height in a flat foot on the
/// floor, metres.
double toe_clearance(const FootShape& shape, const FootPose& foot);

/// Height of the heel's edge above the floor, metres.
double heel_clearance(const FootShape& shape, const FootPose& foot);

}  // namespace mien::motion
