#pragma once

#include <array>

#include "motion/procedural/leg_cycle.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// The style with its lengths, and with them its speed, in proportion to the legs of the body.
WalkStyle scaled_to(const Skeleton& body, WalkStyle style);

/// The leg of a body under a pelvis, its swing not yet fitted.
LegCycle make_leg(const Skeleton& body, const PelvisPath& pelvis, bool left);

/// Sets hip, knee, ankle and toe joint of the pose so that the foot is where it is to be, by
/// two-bone inverse kinematics. The pelvis of the pose is set already; knees point between where
/// the pelvis faces and where the foot does.
void set_leg(const LegCycle& leg, const FootPose& foot, const Skeleton& body, Pose& pose);

/// Places the pelvis over the feet: as high as it can walk without either knee being straighter in
/// stance than the style's `stance_knee_deg`, and as far before or behind the feet as lets it be
/// highest. (People keep their legs about as straight as the step allows: it costs least.)
///
/// Sets `pelvis.mean_height_m` and `ahead_m` of both legs. Throws mien::Error when the steps are
/// too long for the legs.
void fit_stance(std::array<LegCycle, 2>& legs);

}  // namespace mien::motion
