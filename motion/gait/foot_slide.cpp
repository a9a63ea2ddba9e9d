#include "motion/gait/foot_slide.h"

#include <algorithm>
#include <array>
#include <limits>

#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

constexpr double touching_m = 0.005;

/// What can touch the floor, and about what a foot turns there: the heel's edge, the floor under
/// the toe joint when it is at its lowest, and the tip of the toes.
using Supports = std::array<Vec3, 3>;

std::vector<Supports> supports_of(const Clip& clip, bool left) {
  const auto toe = static_cast<std::size_t>(left ? LeftToe : RightToe);
  const Vec3 down(0.0, -sole_depth(clip.body), 0.0);
  const std::vector<SolePoints> soles = sole_paths(clip, left);
  std::vector<Supports> supports;
  for (std::size_t f = 0; f < soles.size(); ++f) {
    const Vec3 ball = world_positions(clip.body, clip.poses[f])[toe] + down;
    supports.push_back({soles[f].heel, ball, soles[f].tip});
  }
  return supports;
}

/// The least that a part moves which touches in both frames; nothing where none does.
Vec3 slid(const Supports& from, const Supports& to, double floor) {
  Vec3 least = Vec3::Zero();
  double length = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < from.size(); ++p) {
    if (std::max(from[p].y(), to[p].y()) > floor + touching_m) continue;
    const Vec3 step = horizontal(to[p] - from[p]);
    if (step.norm() >= length) continue;
    least = step;
    length = step.norm();
  }
  return least;
}

double slide_of(const std::vector<Supports>& supports, const FootPlant& plant) {
  const auto at = [&](int f) { return supports[static_cast<std::size_t>(f)]; };
  const int last = std::min(plant.last, static_cast<int>(supports.size()) - 1);
  double floor = std::numeric_limits<double>::infinity();
  for (int f = plant.first; f <= last; ++f) {
    for (const Vec3& part : at(f)) floor = std::min(floor, part.y());
  }
  Vec3 way = Vec3::Zero();
  double farthest = 0.0;
  for (int f = plant.first; f < last; ++f) {
    way += slid(at(f), at(f + 1), floor);
    farthest = std::max(farthest, way.norm());
  }
  return farthest;
}

}  // namespace

double planted_slide(const Clip& clip, const std::vector<FootPlant>& plants) {
  double largest = 0.0;
  if (plants.empty()) return largest;
  if (clip.loops) return planted_slide(repeated(clip, 2), plants);
  const std::vector<Supports> left = supports_of(clip, true);
  const std::vector<Supports> right = supports_of(clip, false);
  for (const FootPlant& plant : plants) {
    largest = std::max(largest, slide_of(plant.left ? left : right, plant));
  }
  return largest;
}

}  // namespace mien::motion
