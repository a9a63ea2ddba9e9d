#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Whether a motion has flight phases (gait_events.h), as in running. The clip does not walk in
/// place.
bool has_flights(const Clip& clip);

/// The plants of `foot_plants` (contact.h) with its defaults or, if the motion has flight phases,
/// with `event_contact`: a running foot touches the floor for
/// hardly a tenth of a second and never stands still. The clip does not walk in place.
std::vector<FootPlant> gait_plants(const Clip& clip);

}  // namespace mien::motion
