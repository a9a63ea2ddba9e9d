#pragma once

#include "motion/gait/foot_lock.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// The clip with its feet locked repeatedly until the foot locking converges. Captured feet slide a
/// little even while standing, and blends are foot-locked; so an example must be foot-locked
/// beforehand if a blend is to reproduce it.
///
/// Foot contacts are detected anew in each iteration. The iteration ends when the joints move by
/// less than 1 µm on average (distance.h), or after 40 iterations: walks need 3 to 15, captured
/// limps up to 36. The clip must not walk in place.
Clip with_settled_feet(const Clip& clip, const FootLockOptions& options = {});

/// Applies `with_settled_feet` to all examples of a set.
ExampleSet with_settled_feet(const ExampleSet& set, const FootLockOptions& options = {});

}  // namespace mien::motion
