#pragma once

#include <array>

#include "motion/procedural/leg_cycle.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// The style with its lengths and its speed scaled by the body's leg length.
WalkStyle scaled_to(const Skeleton& body, WalkStyle style);

/// The leg of a body for a trajectory of the pelvis; its swing is not fitted yet.
LegCycle make_leg(const Skeleton& body, const PelvisPath& pelvis, bool left);

/// Sets hip, knee, ankle and toe joint of the pose so that the foot has the given pose, by two-bone
/// inverse kinematics. The pelvis must already be set; knees point between the directions of the
/// pelvis and of the foot.
void set_leg(const LegCycle& leg, const FootPose& foot, const Skeleton& body, Pose& pose);

/// Places the pelvis over the feet: at the forward offset from them that permits the greatest
/// height, and as high as possible without either knee being straighter in stance than the style's
/// `stance_knee_deg`. (People keep their legs about as straight as the step allows, which costs the
/// least energy.)
///
/// Sets `pelvis.mean_height_m` and `ahead_m` of both legs. Throws mien::Error when the steps are
/// too long for the legs.
void fit_stance(std::array<LegCycle, 2>& legs);

}  // namespace mien::motion
