#pragma once

#include <array>
#include <string_view>

#include "motion/biomechanics/body_mass.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// The four groups that the features of walking fall into in the adjective paper (its tables 4 and
/// 5): the primary feature parameters.
enum class FeatureGroup { lateral_swing, front_back_swing, upper_body_bend, step_length };

inline constexpr int feature_group_count = 4;

/// "lateral-swing", "front-back-swing", "upper-body-bend", "step-length".
std::string_view id_of(FeatureGroup group);
/// "lateral swing of the upper body", …
std::string_view name_of(FeatureGroup group);
std::string_view japanese_name_of(FeatureGroup group);

enum class FeatureUnit { degrees, metres, metres_per_second, seconds };

/// "deg", "m", "m/s", "s".
std::string_view symbol_of(FeatureUnit unit);

/// One of the measures of a walk that motions can be made from.
struct MotionFeature {
  std::string_view id;  ///< "sigma-head-lr": statistic, segment, direction
  std::string_view name;
  std::string_view japanese;  ///< UTF-8, our translation
  FeatureUnit unit;
  FeatureGroup group;
  /// Replaces a duplicate: the published tables have 51 lines, of which two occur twice.
  bool reconstructed = false;
};

inline constexpr int motion_feature_count = 51;

/// All features in their fixed order: group by group as published.
const std::array<MotionFeature, motion_feature_count>& motion_features();

/// Index of the feature of that id, or −1.
int find_motion_feature(std::string_view id);

struct FeatureOptions {
  MassModel masses = MassModel::de_leva_male;
  /// Sideways angles of arms, legs and feet count from the body outwards; otherwise to the left.
  bool outward = true;
};

using FeatureValues = std::array<double, motion_feature_count>;

/// Measures one cycle of a loop, or a whole performance, at 30 moments a second.
///
/// With f the way walked (straighten.h), l to its left and u up: segments that point up (torso:
/// pelvis to neck; head: neck to vertex) have the angles atan2(d·f, d·u) forward and atan2(d·l,
/// d·u) to the left, those that point down (upper arm, forearm, thigh, shin) the same with −d·u.
/// The foot is the direction s of its sole towards the toes (from ankle to toe joint, levelled as
/// in standing) and has its pitch, atan2(s·u, s·f), and its turn, atan2(s·l, s·f). Angles run on
/// over ±180°; moments at which a segment points within 10° of the axis of an angle (the foot's
/// turn: at which the sole is steeper than 80°) do not count for it.
///
/// "mu" is a mean and "sigma" a standard deviation (n) over the cycle; "com" is the centre of mass,
/// its height above the floor and its way beside the straight line walked; velocities are central
/// differences of the travelling motion. Steps are the distances between the ankles along f and l
/// at the heel strikes of both feet, on the average; a little less than between footprints, because
/// the rear heel has risen.
///
/// Units as `motion_features` says. What a motion does not have is NaN: a performance has no
/// steps, an arm held out straight no angle forward.
/// The values change neither with a turn about the vertical nor with a shift on the floor.
/// Needs two frames or more.
FeatureValues measure_features(const Example& example, const FeatureOptions& options = {});

}  // namespace mien::motion
