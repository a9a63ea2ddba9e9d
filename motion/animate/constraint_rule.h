#pragma once

#include <optional>
#include <string>

#include "motion/animate/constraint.h"
#include "motion/math/cubic_spline.h"

namespace mien::motion {

/// A frame of a motion on which a constraint acts.
struct ConstrainedFrame {
  double strength = 0.0;    ///< 1 between the constraint's ends, 0 out of reach
  double seconds = 0.0;     ///< in the lap of a loop in which the constraint is stated
  Vec3 lap = Vec3::Zero();  ///< from the frame to that lap, metres
};

/// A constraint on a certain motion.
class ConstraintRule {
 public:
  /// Throws mien::Error as with_constraints does.
  ConstraintRule(const Clip& clip, const MotionConstraint& constraint);

  const MotionConstraint& constraint() const { return constraint_; }
  ConstrainedFrame frame(int index) const;

  /// Whether it places its part by itself, rather than relative to another part.
  bool is_of_place() const;
  /// Where a part that is at `place` is to be.
  Vec3 place_for(const Vec3& place, const BodyFrame& body, const ConstrainedFrame& frame) const;
  /// The distance at which two parts are to be that are at `metres`.
  double distance_for(double metres) const;
  /// The radians of an angle that is `radians`.
  double angle_for(double radians) const;
  /// The place to look at.
  Vec3 looked_at(const BodyFrame& body, const ConstrainedFrame& frame) const;
  /// How the part is turned where it keeps its orientation, in the room.
  Quat orientation(const BodyFrame& body) const;

  /// By how much it is missed: metres, or degrees of an angle, a look or an orientation.
  double miss(const JointTransforms& world, const Pose& pose, const ConstrainedFrame& frame,
              const Skeleton& skeleton) const;
  bool is_of_angle() const;

 private:
  bool is_in_room() const;
  double limited(double value, double margin) const;

  const MotionConstraint& constraint_;
  const Clip& clip_;
  double from_ = 0.0;
  double to_ = 0.0;
  double reach_ = 0.0;
  bool is_whole_ = false;
  Vec3 start_place_ = Vec3::Zero();  ///< of what stays, in its frame
  Quat start_turn_ = Quat::Identity();
  std::optional<CubicSpline> path_;
};

}  // namespace mien::motion
