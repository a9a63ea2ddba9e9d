#include "motion/steered_walk/root_motion.h"

#include <cmath>

namespace mien::motion {

namespace {

// Angular frequencies, 1/s. Ours: from standing to 90 % of a walk's speed in about a second, as
// people do within two steps (Jian et al. 1993).
constexpr double goal_stiffness = 14.0;
constexpr double speed_stiffness = 5.0;
constexpr double turning_stiffness = 7.0;

Quat facing(const RootMotion& root) { return Quat(Eigen::AngleAxisd(root.heading, Vec3::UnitY())); }

/// Area under a spring that is pulled to 0 from here.
double rest_of(const DampedSpring& number, double stiffness) {
  return 2.0 * number.value / stiffness + number.rate / (stiffness * stiffness);
}

}  // namespace

DampedSpring spring_step(const DampedSpring& number, double goal, double stiffness,
                         double seconds) {
  const double away = number.value - goal;
  const double slope = number.rate + stiffness * away;
  const double left = std::exp(-stiffness * seconds);
  return {goal + (away + slope * seconds) * left,
          (number.rate - slope * stiffness * seconds) * left};
}

RootMotion advanced(RootMotion root, double speed, double turning, double seconds) {
  const RootMotion before = root;
  root.wanted_speed = spring_step(before.wanted_speed, speed, goal_stiffness, seconds);
  root.wanted_turning = spring_step(before.wanted_turning, turning, goal_stiffness, seconds);
  root.speed = spring_step(before.speed, root.wanted_speed.value, speed_stiffness, seconds);
  root.turning = spring_step(before.turning, root.wanted_turning.value, turning_stiffness, seconds);
  root.heading += 0.5 * (before.turning.value + root.turning.value) * seconds;
  const double way = 0.5 * (before.speed.value + root.speed.value) * seconds;
  root.place += 0.5 * way * (forward_of(before) + forward_of(root));
  return root;
}

Vec3 forward_of(const RootMotion& root) {
  return {std::sin(root.heading), 0.0, std::cos(root.heading)};
}

Vec3 to_world(const RootMotion& root, const Vec3& local) {
  return root.place + facing(root) * local;
}

Vec3 to_local(const RootMotion& root, const Vec3& world) {
  return facing(root).conjugate() * (world - root.place);
}

double coasting_turn(const RootMotion& root) {
  return rest_of(root.turning, turning_stiffness) + rest_of(root.wanted_turning, goal_stiffness);
}

double coasting_distance(const RootMotion& root) {
  return rest_of(root.speed, speed_stiffness) + rest_of(root.wanted_speed, goal_stiffness);
}

}  // namespace mien::motion
