#include "motion/rig/retarget.h"

#include <cassert>

#include "motion/skeleton/floor.h"

namespace mien::motion {

Clip retarget(const Clip& clip, const Skeleton& body) {
  assert(is_body(body));
  Clip result = clip;
  result.body = body;
  if (clip.poses.empty()) return result;
  const double ratio = leg_length(body) / leg_length(clip.body);
  for (Pose& pose : result.poses) pose.root_position *= ratio;
  result.cycle_displacement *= ratio;
  const double raised = floor_height(result) - floor_height(clip);
  for (Pose& pose : result.poses) pose.root_position.y() -= raised;
  return result;
}

}  // namespace mien::motion
