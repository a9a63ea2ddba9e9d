#pragma once

#include "motion/gait/foot_lock.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// The clip with its feet locked so often that another lock changes next to nothing. Captured feet
/// glide a little even where they stand; a blend is locked anyway, and so an example that is to
/// come out of a blend as it went in has to be locked before.
///
/// Contacts are found anew each time. Ends when the joints move by less than 1 µm on average
/// (distance.h), after 40 locks at the latest: walks take 3 to 15, limps of captures up to 36. The
/// clip must travel.
Clip with_settled_feet(const Clip& clip, const FootLockOptions& options = {});

/// The same of all examples of a set.
ExampleSet with_settled_feet(const ExampleSet& set, const FootLockOptions& options = {});

}  // namespace mien::motion
