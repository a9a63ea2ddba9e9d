#include "motion/skeleton/settled_offsets.h"

#include <algorithm>
#include <vector>

namespace mien::motion {

bool has_offsets_of(const Pose& first, const Pose& pose) {
  double longest = 0.0;
  double change = 0.0;
  for (size_t j = 1; j < first.offsets.size(); ++j) {
    longest = std::max(longest, first.offsets[j].squaredNorm());
    change = std::max(change, (pose.offsets[j] - first.offsets[j]).squaredNorm());
  }
  return change <= 1e-14 * longest;
}

void settle_offsets(Recording& recording) {
  std::vector<Joint>& joints = recording.skeleton.joints;
  const std::vector<Vec3> first = recording.poses.front().offsets;
  double longest = 0.0;
  std::vector<double> changes(joints.size(), 0.0);
  for (const Pose& pose : recording.poses) {
    for (size_t j = 1; j < pose.offsets.size(); ++j) {
      longest = std::max(longest, pose.offsets[j].norm());
      changes[j] = std::max(changes[j], (pose.offsets[j] - first[j]).norm());
    }
  }
  const double least = 1e-6 * longest;
  for (size_t j = 1; j < joints.size(); ++j) {
    if (changes[j] <= least) joints[j].offset = first[j];
  }
  const bool any_moves = *std::max_element(changes.begin(), changes.end()) > least;
  for (Pose& pose : recording.poses) {
    if (!any_moves) {
      pose.offsets = {};
    } else if (pose.offsets.empty()) {
      pose.offsets = first;
    }
    for (size_t j = 0; j < pose.offsets.size(); ++j) {
      if (changes[j] <= least) pose.offsets[j] = joints[j].offset;
    }
  }
}

}  // namespace mien::motion
