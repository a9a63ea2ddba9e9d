#include "motion/lint/against_original.h"

#include <algorithm>
#include <cmath>

namespace mien::motion {

std::vector<Vec3> limb_way(const LintSubject& subject, int end) {
  const int base = end == LeftAnkle || end == RightAnkle ? Pelvis : Chest;
  std::vector<Vec3> way;
  for (const JointTransforms& world : subject.world) {
    const Vec3 from_base = world.positions[end] - world.positions[base];
    way.push_back(world.rotations[base].conjugate() * from_base);
  }
  return way;
}

std::vector<Vec3> at_moments_of(const LintSubject& subject, const LintSubject& other,
                                const std::vector<Vec3>& way) {
  std::vector<Vec3> result;
  for (int t = 0; t < subject.frame_count(); ++t) {
    const double frame = corresponding_frame(subject, t, other);
    const auto whole = static_cast<size_t>(frame);
    const double part = frame - std::floor(frame);
    const size_t next = std::min(whole + 1, way.size() - 1);
    result.push_back((1.0 - part) * way[whole] + part * way[next]);
  }
  return result;
}

}  // namespace mien::motion
