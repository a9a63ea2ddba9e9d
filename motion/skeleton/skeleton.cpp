#include "motion/skeleton/skeleton.h"

namespace mien::motion {

int find_joint(const Skeleton& skeleton, std::string_view name) {
  for (int j = 0; j < skeleton.size(); ++j) {
    if (skeleton.joints[static_cast<size_t>(j)].name == name) return j;
  }
  return -1;
}

std::vector<std::vector<int>> children_of(const Skeleton& skeleton) {
  std::vector<std::vector<int>> children(skeleton.joints.size());
  for (int j = 1; j < skeleton.size(); ++j) {
    children[static_cast<size_t>(skeleton.joints[static_cast<size_t>(j)].parent)].push_back(j);
  }
  return children;
}

bool is_well_formed(const Skeleton& skeleton) {
  if (skeleton.joints.empty() || skeleton.joints.front().parent != -1) return false;
  for (int j = 1; j < skeleton.size(); ++j) {
    const int parent = skeleton.joints[static_cast<size_t>(j)].parent;
    if (parent < 0 || parent >= j) return false;
  }
  return true;
}

}  // namespace mien::motion
