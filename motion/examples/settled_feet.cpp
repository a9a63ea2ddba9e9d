#include "motion/examples/settled_feet.h"

#include "motion/gait/gait_plants.h"
#include "motion/measures/distance/distance.h"

namespace mien::motion {

namespace {

constexpr int most_locks = 40;
constexpr double settled_metres = 1e-6;

}  // namespace

Clip with_settled_feet(const Clip& clip, const FootLockOptions& options) {
  Clip settled = clip;
  const std::vector<double> keytimes = {0.0, clip.duration_seconds()};
  for (int lock = 0; lock < most_locks; ++lock) {
    Clip locked = foot_locked(settled, gait_plants(settled), options);
    const double moved = distance({"", settled, keytimes}, {"", locked, keytimes}).mean;
    settled = std::move(locked);
    if (moved < settled_metres) break;
  }
  return settled;
}

ExampleSet with_settled_feet(const ExampleSet& set, const FootLockOptions& options) {
  ExampleSet settled = set;
  for (Example& example : settled.examples) {
    example.clip = with_settled_feet(example.clip, options);
  }
  return settled;
}

}  // namespace mien::motion
