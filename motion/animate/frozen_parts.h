#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "motion/animate/animation_report.h"
#include "motion/animate/moment.h"

namespace mien::motion {

/// Parts of the body that can be frozen.
enum class FrozenPart { legs, trunk, head, left_arm, right_arm };

/// Parts that do not move, in the pose of one moment.
struct Freezing {
  std::vector<FrozenPart> parts;  ///< without duplicates; empty: nothing is frozen
  /// The moment; empty: for each part that of its most typical pose, with both feet on the floor
  /// if it is the legs and there is such a frame.
  std::optional<Moment> at;

  friend bool operator==(const Freezing&, const Freezing&) = default;
};

/// Whether a joint belongs to a frozen part.
bool is_frozen(const Freezing& freezing, BodyJoint joint);

/// The motion with parts that do not move. Legs are frozen together with the pelvis, its place and
/// its direction, so that the body stands where it is at that moment; a loop that travels then
/// stays on the spot. Other parts keep the rotations of their joints: the trunk those of spine and
/// chest, the head of neck and head, an arm of clavicle, shoulder, elbow, wrist and fingers. All
/// other joints keep their own rotations relative to their parents.
///
/// The most typical pose is that of the frame whose joints of the part are nearest to their mean
/// rotations, by the sum of squared angles; the direction of the pelvis about the vertical does not
/// count. This is our decision. The remarks say which moments were taken.
///
/// Throws mien::Error for a moment outside the motion, and for a skeleton other than the canonical
/// body.
AnimatedClip with_frozen(const Clip& clip, const Freezing& freezing);

}  // namespace mien::motion
