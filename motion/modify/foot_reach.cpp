#include "motion/modify/foot_reach.h"

#include <algorithm>
#include <cmath>

#include "motion/gait/foot_path.h"
#include "motion/math/filter.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

constexpr double farthest = 0.9;          // of the length of the leg
constexpr double moving_seconds = 0.125;  // in which the root begins and ends to move
constexpr int most_moves = 5;
constexpr double near_enough = 1e-3;  // metres

double leg_length(const Skeleton& body, const LegJoints& leg) {
  return body.joints[leg.knee].offset.norm() + body.joints[leg.ankle].offset.norm();
}

/// How far the root has to move in each frame, horizontally.
std::vector<Vec3> missing(const Clip& clip, const std::vector<FootTrajectory>& stretches) {
  std::vector<Vec3> sums(clip.poses.size(), Vec3::Zero());
  std::vector<int> feet(clip.poses.size(), 0);
  for (const bool left : {true, false}) {
    const LegJoints leg = leg_joints(left);
    const double longest = farthest * leg_length(clip.body, leg);
    const FootPath path = foot_path(clip, left);
    for (const FootTrajectory& stretch : stretches) {
      if (stretch.left != left) continue;
      for (size_t k = 0; k < stretch.places.size(); ++k) {
        const int frame = stretch.first + static_cast<int>(k);
        const auto at = static_cast<size_t>(path.wrapped(frame));
        const Vec3 hip = world_transform(clip.body, clip.poses[at], leg.hip).position;
        const Vec3 way = horizontal(stretch.places[k].ankle - path.displacement(frame) - hip);
        if (way.norm() <= longest) continue;
        sums[at] += (1.0 - longest / way.norm()) * way;
        ++feet[at];
      }
    }
  }
  for (size_t f = 0; f < sums.size(); ++f) {
    if (feet[f] > 1) sums[f] /= feet[f];
  }
  return sums;
}

/// The part of the moves in one direction, each as great as needed or greater, and smooth.
std::vector<double> smooth_moves(const std::vector<Vec3>& moves, const Vec3& direction,
                                 const Clip& clip) {
  std::vector<double> needed;
  for (const Vec3& move : moves) needed.push_back(std::max(0.0, move.dot(direction)));
  const int half_width = static_cast<int>(std::lround(moving_seconds * clip.frames_per_second));
  return smooth_envelope(needed, std::max(1, half_width), clip.loops);
}

}  // namespace

Clip with_feet_in_reach(const Clip& clip, const std::vector<FootTrajectory>& stretches) {
  Clip moved = clip;
  for (int moves = 0; moves < most_moves; ++moves) {
    const std::vector<Vec3> needed = missing(moved, stretches);
    const bool are_near = std::all_of(needed.begin(), needed.end(),
                                      [](const Vec3& move) { return move.norm() < near_enough; });
    if (are_near) break;
    for (const Vec3& direction :
         {Vec3::UnitX().eval(), Vec3(-Vec3::UnitX()), Vec3::UnitZ().eval(), Vec3(-Vec3::UnitZ())}) {
      const std::vector<double> lengths = smooth_moves(needed, direction, clip);
      for (size_t f = 0; f < lengths.size(); ++f) {
        moved.poses[f].root_position += lengths[f] * direction;
      }
    }
  }
  return moved;
}

}  // namespace mien::motion
