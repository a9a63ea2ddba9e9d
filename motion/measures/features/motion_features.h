#pragma once

#include <array>
#include <string_view>

#include "motion/biomechanics/body_mass.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// The four groups of walking features in the adjective paper (its tables 4 and 5): the primary
/// feature parameters.
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

/// A feature of a walk, usable as a parameter for synthesizing motions.
struct MotionFeature {
  std::string_view id;  ///< "sigma-head-lr": statistic, segment, direction
  std::string_view name;
  std::string_view japanese;  ///< UTF-8, our translation
  FeatureUnit unit;
  FeatureGroup group;
  /// True for three features that are not printed in the published tables as such. The tables have
  /// 51 rows, but the rows step length FB and σ left foot LR are printed twice, and the row σ com
  /// LR does not state whether it means position or velocity. sigma-left-foot-fb replaces the
  /// second row σ left foot LR; sigma-com-pos-lr and sigma-com-vel-lr replace the row σ com LR and
  /// the second row step length FB.
  bool reconstructed = false;
};

inline constexpr int motion_feature_count = 51;

/// All features in their fixed order: group by group as published.
const std::array<MotionFeature, motion_feature_count>& motion_features();

/// Index of the feature of that id, or −1.
int find_motion_feature(std::string_view id);

struct FeatureOptions {
  MassModel masses = MassModel::de_leva_male;
  /// True: lateral angles of arms, legs and feet are positive outwards from the body; false:
  /// positive to the left.
  bool outward = true;
};

using FeatureValues = std::array<double, motion_feature_count>;

/// Measures one cycle of a loop, or the whole of any other motion, sampled at 30 Hz.
///
/// Let f be the direction of travel (straighten.h), l the direction to its left, u up, and d the
/// direction of a segment. Segments that point up (torso: pelvis to neck; head: neck to vertex)
/// have the angles atan2(d·f, d·u) forward and atan2(d·l, d·u) to the left; those that point down
/// (upper arm, forearm, thigh, shin) have the same angles with −d·u. A foot is represented by the
/// direction s of its sole towards the toes (from ankle to toe joint, levelled as in standing),
/// with a pitch of atan2(s·u, s·f) and a yaw of atan2(s·l, s·f). Angles are unwrapped beyond ±180°.
/// Frames in which a segment points within 10° of the rotation axis of an angle (for the foot's
/// yaw: in which the angle between s and f is more than 80°) are excluded from that angle.
///
/// "mu" is the mean and "sigma" the (population) standard deviation over the cycle. "com" is the
/// centre of mass: its height above the floor and its lateral deviation from the line of travel;
/// velocities are central differences of the travelling motion. Steps are the mean distances
/// between the ankles along f and l at the heel strikes of both feet; they are slightly shorter
/// than the distances between footprints because the rear heel has risen.
///
/// Units are those in `motion_features`. Features that a motion lacks are NaN: a motion without a
/// gait cycle has no steps, an arm held out sideways has no forward angle. The values are invariant
/// to rotation about the vertical and translation on the floor. Needs at least two frames.
FeatureValues measure_features(const Example& example, const FeatureOptions& options = {});

}  // namespace mien::motion
