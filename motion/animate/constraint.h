#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "motion/animate/body_end.h"
#include "motion/animate/moment.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// What of a part stays as it is at the beginning of a constraint.
enum class Stays { position, orientation };

/// An angle whose range can be set, of the joints of a pair together: forward, to the left side, or
/// turned to the left; of elbows: bent.
enum class RangeAngle {
  head_flexion,
  head_lateral,
  head_turn,
  spine_flexion,
  spine_lateral,
  spine_turn,
  left_elbow_flexion,
  right_elbow_flexion,
};

/// A place of a path.
struct PathPlace {
  Moment at;
  std::optional<Vec3> place;  ///< metres
};

/// The limits of a region along one axis, metres; an axis without limits is free.
using RegionLimits = std::optional<std::array<double, 2>>;

/// A condition on a motion (the seven of Gleicher 1998): a part is at a place, stays, follows a
/// path, is in a region, at a distance from another, or keeps its orientation; or an angle is in a
/// range. Exactly one is given.
struct MotionConstraint {
  std::optional<Moment> from;  ///< the beginning of the motion if there is none
  std::optional<Moment> to;    ///< the end of the motion if there is none
  double reach = 0.5;          ///< seconds before and after, in which the motion changes
  std::optional<BodyEnd> part;
  std::optional<PlaceFrame> frame;  ///< body, or room (the default for what stays)

  std::optional<Stays> stays;
  std::optional<Vec3> place;       ///< metres
  std::vector<PathPlace> follows;  ///< at least two, in order of time; between them a cubic spline
  std::array<RegionLimits, 3> within;  ///< x, y, z
  std::optional<BodyEnd> distance_to;  ///< between at_least and at_most metres
  std::optional<RangeAngle> angle;     ///< between at_least and at_most degrees
  std::optional<Vec3> look_at;         ///< the head's only one besides distance_to
  std::optional<double> at_least;
  std::optional<double> at_most;

  bool has_region() const { return within[0] || within[1] || within[2]; }
};

/// The radians of an angle in a pose.
double angle_of(const Pose& pose, RangeAngle angle);

/// The pose with an angle of so many radians; both joints of a pair turn by the same amount.
Pose with_angle(const Pose& pose, RangeAngle angle, double radians);

}  // namespace mien::motion
