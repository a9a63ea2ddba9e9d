#pragma once

#include "motion/gait/foot_lock.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// The clip with its feet locked repeatedly until the lock converges. Captured feet slide a little
/// even while they stand, and blends are locked afterwards: an example that a blend is to reproduce
/// has to be locked before.
///
/// Contacts are detected anew each time. Ends when the joints move by less than 1 µm on average
/// (distance.h), after 40 locks at most: walks take 3 to 15, captured limps up to 36. The clip must
/// travel.
Clip with_settled_feet(const Clip& clip, const FootLockOptions& options = {});

/// Settles the feet of all examples of a set.
ExampleSet with_settled_feet(const ExampleSet& set, const FootLockOptions& options = {});

}  // namespace mien::motion
