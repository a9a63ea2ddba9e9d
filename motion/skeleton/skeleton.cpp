#include "motion/skeleton/skeleton.h"

#include <algorithm>

namespace mien::motion {

bool same_rig(const Skeleton& a, const Skeleton& b) {
  if (a.size() != b.size()) return false;
  for (int j = 0; j < a.size(); ++j) {
    const Joint& p = a.joints[j];
    const Joint& q = b.joints[j];
    const double length = std::max(p.offset.norm(), q.offset.norm());
    if (p.name != q.name || p.parent != q.parent) return false;
    if ((p.offset - q.offset).norm() > 1e-3 * length) return false;
  }
  return true;
}

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
