#include "motion/stream/stream_error.h"

#include <cassert>
#include <cmath>

namespace mien::motion {

StreamError stream_error(const Clip& streamed, const Clip& offline) {
  assert(streamed.frame_count() == offline.frame_count());
  StreamError error;
  double squares = 0.0;
  for (size_t f = 0; f < streamed.poses.size(); ++f) {
    const std::vector<Vec3> here = world_positions(streamed.body, streamed.poses[f]);
    const std::vector<Vec3> there = world_positions(offline.body, offline.poses[f]);
    for (size_t j = 0; j < here.size(); ++j) {
      const double away = (here[j] - there[j]).norm();
      squares += away * away;
      if (away <= error.largest_metres) continue;
      error.largest_metres = away;
      error.joint = static_cast<BodyJoint>(j);
      error.frame = static_cast<int>(f);
    }
  }
  const double count = static_cast<double>(body_joint_count) * streamed.frame_count();
  if (count > 0.0) error.rms_metres = std::sqrt(squares / count);
  return error;
}

}  // namespace mien::motion
