#pragma once

#include "motion/fitting/body_tracks.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// The canonical body with the subject's bone lengths: medians over the frames in which both ends
/// are known. A bone that is known on one side only is as long on the other; bones that are known
/// on neither are those of `standard_body`, scaled with the legs.
///
/// The toe joint lies below the ankle by their difference in height while the foot stands flat.
Skeleton fitted_proportions(const BodyTracks& tracks);

}  // namespace mien::motion
