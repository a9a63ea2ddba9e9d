#pragma once

#include <optional>
#include <span>
#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/modify/posture.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A change of a joint angle by a share of its free range: from the actor's own mean to the end of
/// the range (share > 0), or back to its other end (share < 0).
struct RangeShare {
  PostureUnit unit = PostureUnit::head_flexion;
  double share = 0.0;  ///< −1 to 1
};

/// A change in the actor's own terms. Factors multiply what the actor does, below 6 Hz: the noise
/// of a capture stays as it is. 1 changes nothing.
struct RelativeChange {
  double step_width = 1.0;   ///< of the lateral distance between the feet, 0–3; never below the
                             ///< width of a foot, unless the actor's own steps are narrower
  double step_length = 1.0;  ///< of the swing of the legs, 0–2
  double sway = 1.0;         ///< of the lateral sway of the pelvis over the feet, 0–3
  double arm_swing = 1.0;    ///< of the swing of the arms, 0–3
  double trunk_swing = 1.0;  ///< of the movement of pelvis, trunk and head about their means, 0–3
  std::vector<RangeShare> range;
};

/// The range of the angle that a unit of posture changes, degrees, in the unit's direction.
struct UnitRange {
  double least = 0.0;
  double most = 0.0;
};

/// The ranges of joint_angles.h; upper arms are not adducted beyond the vertical, where they touch
/// the body. Empty for units whose range is not known: sideways bends, turns, and shoulders drawn
/// up or forward.
std::optional<UnitRange> range_of(PostureUnit unit);

/// The mean over the clip, and over both sides, of the angle that a unit changes, degrees. The unit
/// must have a range.
double own_angle(const Clip& clip, PostureUnit unit);

/// Whether the change changes nothing.
bool is_identity(const RelativeChange& change);

/// Whether it changes the swing of limbs, trunk or pelvis (with_swing).
bool changes_swing(const RelativeChange& change);

/// The change without that of the swing.
RelativeChange without_swing(RelativeChange change);

/// The change at a strength, as `scaled` of a modification: factors to that power, shares times it,
/// both within their limits.
RelativeChange scaled(RelativeChange change, double strength);

/// Throws mien::Error for a number outside its range, or a share of an unknown range.
void check(const RelativeChange& change);

/// The posture that `change` asks of the actor of `clip`, in degrees: shares of the free ranges (of
/// arms a third of them if one makes a gesture and the other rests, acting_hand.h), and the
/// abduction of the hips that changes the width of the steps (of the stance, if the clip has no
/// steps) as asked. Without steps and stances the width is not changed.
std::vector<PostureChange> posture_of(const RelativeChange& change, const Clip& clip,
                                      std::span<const FootPlant> plants);

/// The clip with the swing of its limbs and trunk multiplied: each rotation's deviation from its
/// mean over a loop, or from its course below 0.3 Hz in another clip (continued beyond the ends by
/// the motion backwards), in which arms keep their swing unless it is locomotion (acting_hand.h);
/// of the knees of a loop the deviation from where they are straightest. The legs keep their
/// orientation when the pelvis rotates less or more; for more sway they lean, so that the pelvis
/// moves when the feet are held. The root's path does not change, so feet may slide (see
/// foot_repair.h).
Clip with_swing(const Clip& clip, const RelativeChange& change);

}  // namespace mien::motion
