#include "motion/steered_walk/carriage.h"

#include <cmath>

namespace mien::motion {

namespace {

// Angular frequencies, 1/s. Ours: from standing to 90 % of a walk's speed in about a second, as
// people do within two steps (Jian et al. 1993).
constexpr double wish_stiffness = 14.0;
constexpr double speed_stiffness = 5.0;
constexpr double turning_stiffness = 7.0;

Quat facing(const Carriage& carriage) {
  return Quat(Eigen::AngleAxisd(carriage.heading, Vec3::UnitY()));
}

/// Area under a spring that is pulled to 0 from here.
double rest_of(const Followed& number, double stiffness) {
  return 2.0 * number.value / stiffness + number.rate / (stiffness * stiffness);
}

}  // namespace

Followed followed(const Followed& number, double goal, double stiffness, double seconds) {
  const double away = number.value - goal;
  const double slope = number.rate + stiffness * away;
  const double left = std::exp(-stiffness * seconds);
  return {goal + (away + slope * seconds) * left,
          (number.rate - slope * stiffness * seconds) * left};
}

Carriage advanced(Carriage carriage, double speed, double turning, double seconds) {
  const Carriage before = carriage;
  carriage.wanted_speed = followed(before.wanted_speed, speed, wish_stiffness, seconds);
  carriage.wanted_turning = followed(before.wanted_turning, turning, wish_stiffness, seconds);
  carriage.speed = followed(before.speed, carriage.wanted_speed.value, speed_stiffness, seconds);
  carriage.turning =
      followed(before.turning, carriage.wanted_turning.value, turning_stiffness, seconds);
  carriage.heading += 0.5 * (before.turning.value + carriage.turning.value) * seconds;
  const double way = 0.5 * (before.speed.value + carriage.speed.value) * seconds;
  carriage.place += 0.5 * way * (forward_of(before) + forward_of(carriage));
  return carriage;
}

Vec3 forward_of(const Carriage& carriage) {
  return {std::sin(carriage.heading), 0.0, std::cos(carriage.heading)};
}

Vec3 to_world(const Carriage& carriage, const Vec3& local) {
  return carriage.place + facing(carriage) * local;
}

Vec3 to_local(const Carriage& carriage, const Vec3& world) {
  return facing(carriage).conjugate() * (world - carriage.place);
}

double coasting_turn(const Carriage& carriage) {
  return rest_of(carriage.turning, turning_stiffness) +
         rest_of(carriage.wanted_turning, wish_stiffness);
}

double coasting_way(const Carriage& carriage) {
  return rest_of(carriage.speed, speed_stiffness) + rest_of(carriage.wanted_speed, wish_stiffness);
}

}  // namespace mien::motion
