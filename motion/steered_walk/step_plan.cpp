#include "motion/steered_walk/step_plan.h"

#include <algorithm>
#include <cmath>

namespace mien::motion {

namespace {

constexpr double prediction_step = 1.0 / 30.0;  // seconds
constexpr double heading_gain = 3.5;            // 1/s

double wrapped_angle(double radians) { return std::remainder(radians, 2.0 * pi); }

/// How far before the hip a foot can come down while the pelvis sinks by no more than a little.
double longest_reach(const LegCycle& steady) {
  constexpr double sinking = 0.02;
  const double length = leg_length_at(steady, radians_per_degree * 3.0);
  const double height = steady.pelvis.mean_height_m - 0.5 * steady.pelvis.style.bounce_m +
                        steady.hip_offset.y() - steady.foot.ankle_height - sinking;
  return std::sqrt(std::max(0.01, length * length - height * height));
}

}  // namespace

double remaining_turn(const RootMotion& root, const Steering& steering) {
  if (!steering.heading) return 0.0;
  return wrapped_angle(*steering.heading - root.heading - coasting_turn(root));
}

RootGoal goal_of(const RootMotion& root, const Steering& steering, double own) {
  const double pace = std::clamp(steering.pace, 0.0, gait_paces.back());
  const double left = remaining_turn(root, steering);
  const double turning = steering.heading ? heading_gain * left : steering.turning;
  const double speed = std::max(root.speed.value, 0.1);
  const double most = std::min(fastest_turning, most_sideways_acceleration / speed);
  // Sharp turns are walked slowly.
  const double sharp = std::clamp((std::abs(left) - 0.6) / 1.4, 0.0, 1.0);
  return {pace * own * (1.0 - 0.75 * sharp), std::clamp(turning, -most, most)};
}

RootMotion predicted(RootMotion root, const Steering& steering, double own, double seconds) {
  while (seconds > 0.0) {
    const double step = std::min(seconds, prediction_step);
    const RootGoal goal = goal_of(root, steering, own);
    root = advanced(root, goal.speed, goal.turning, step);
    seconds -= step;
  }
  return root;
}

double cycle_rate(const LegCycle& steady) { return steady.pelvis.style.cadence_steps_min / 120.0; }

Landing landing_of(const SteeredWalk& walker, const SteeredMoment& moment, std::size_t side,
                   const Steering& steering, double own) {
  const SteppingLeg& leg = walker.legs[side];
  const LegCycle& steady = moment.legs[side];
  const double rate = std::max(walker.phase_rate, 0.5 * cycle_rate(steady));
  Landing landing;
  landing.root =
      predicted(walker.root, steering, own, std::max(0.0, leg.lands_at - walker.phase) / rate);
  const RootMotion passing =
      predicted(landing.root, steering, own, moment.gait.passing_phase / cycle_rate(steady));
  const double width = steady.side * steady.pelvis.style.step_width_m;
  landing.print =
      to_local(landing.root, to_world(passing, Vec3(0.5 * width, 0.0, moment.gait.ahead_m)));
  landing.yaw = passing.heading - landing.root.heading +
                steady.side * radians_per_degree * steady.pelvis.style.foot_progression_deg;
  // Not across the other foot.
  constexpr double narrowest = 0.75;
  const SteppingLeg& other = walker.legs[1 - side];
  const double beside = to_local(landing.root, other.print).x();
  const double nearest = beside + narrowest * width;
  if (steady.side * (landing.print.x() - nearest) < 0.0) landing.print.x() = nearest;
  // Not farther before or behind the body than the leg reaches.
  const double reach = longest_reach(steady);
  landing.print.z() = std::clamp(landing.print.z(), -reach, reach);
  return landing;
}

bool stands_well(const SteeredWalk& walker, const SteeredMoment& moment, const RootMotion& rest) {
  for (std::size_t side = 0; side < 2; ++side) {
    const LegCycle& steady = moment.legs[side];
    const double width = steady.side * steady.pelvis.style.step_width_m;
    const Vec3 away =
        to_local(rest, walker.legs[side].print) - Vec3(0.5 * width, 0.0, moment.gait.ahead_m);
    const double turned =
        wrapped_angle(walker.legs[side].yaw - rest.heading -
                      steady.side * radians_per_degree * steady.pelvis.style.foot_progression_deg);
    if (std::abs(away.x()) > 0.06 || std::abs(away.z()) > 0.07 ||
        std::abs(turned) > radians_per_degree * 14.0) {
      return false;
    }
  }
  return true;
}

}  // namespace mien::motion
