#include "motion/rig/same_rig.h"

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

}  // namespace mien::motion
