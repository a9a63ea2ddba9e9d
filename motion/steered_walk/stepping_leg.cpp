#include "motion/steered_walk/stepping_leg.h"

#include <algorithm>
#include <cmath>

namespace mien::motion {

namespace {

constexpr double pitch_stiffness = 12.0;    // 1/s; a heel that is put down again
constexpr double heel_stiffness = 25.0;     // 1/s; a heel that is pulled up
constexpr double landing_stiffness = 18.0;  // 1/s; how fast a swing follows a change of its aim
constexpr double moment_seconds = 1e-3;     // over which rates are taken

FootNumbers numbers_of(const FootPose& foot) {
  FootNumbers numbers;
  numbers << foot.ankle, foot.yaw, foot.pitch, foot.toe_extension;
  return numbers;
}

FootPose foot_pose(const FootNumbers& numbers) {
  return {numbers.head<3>(), numbers[3], numbers[4], numbers[5]};
}

/// The foot of the steady walk in the root's frame, at an own phase that may leave [0, 1] a
/// little.
FootNumbers steady_stance(const LegCycle& steady, double own) {
  FootNumbers numbers = numbers_of(planted_foot(steady, own));
  numbers[2] -= steady.pelvis.stride_m * (own + steady.phase_offset);
  return numbers;
}

FootNumbers steady_swing(const LegCycle& steady, double own) {
  FootNumbers numbers = numbers_of(swinging_foot(steady, own));
  numbers[2] -= steady.pelvis.stride_m * (own + steady.phase_offset);
  return numbers;
}

/// A planted foot, in the root's frame.
FootNumbers local_stance(const LegCycle& steady, const RootMotion& root, const Vec3& print,
                         double yaw, double pitch) {
  FootPose foot = rolled_foot(steady.foot, print, yaw, pitch);
  foot.ankle = to_local(root, foot.ankle);
  foot.yaw -= root.heading;
  return numbers_of(foot);
}

/// The root continued at its present velocity.
RootMotion moved_on(RootMotion root, double seconds) {
  root.place += root.speed.value * seconds * forward_of(root);
  root.heading += root.turning.value * seconds;
  return root;
}

/// Within its stance, also where rounding has taken it just before its heel strike.
double stance_phase(const LegMoment& moment) {
  const double own = own_phase(moment.steady, moment.phase);
  return own > 0.99 ? 0.0 : std::min(own, moment.steady.pelvis.style.stance_share);
}

double rolling_pitch(const SteppingLeg& leg, const LegMoment& moment) {
  return leg.held ? 0.0 : stance_pitch(moment.steady.pelvis.style, stance_phase(moment));
}

/// Value and rate of the pitch that the stance gives.
DampedSpring stance_roll(const LegMoment& moment) {
  const double own = stance_phase(moment);
  const double later = moment_seconds * moment.phase_rate;
  const WalkStyle& style = moment.steady.pelvis.style;
  const double now = stance_pitch(style, own);
  return {now, (now - stance_pitch(style, std::max(0.0, own - later))) / moment_seconds};
}

FootNumbers standing_numbers(const SteppingLeg& leg, const LegMoment& moment) {
  return local_stance(moment.steady, moment.root, leg.print, leg.yaw,
                      rolling_pitch(leg, moment) + leg.more_pitch.value - leg.heel_rise.value);
}

/// Rate of the difference from the steady walk just after landing, 1/s.
FootNumbers landing_rate(const LegMoment& moment, const Landing& landing) {
  const LegCycle& steady = moment.steady;
  const double later = moment_seconds * moment.phase_rate;
  const Vec3 print = to_world(landing.root, landing.print);
  const double yaw = landing.root.heading + landing.yaw;
  const auto difference = [&](double seconds, double own) {
    const double pitch = stance_pitch(steady.pelvis.style, own);
    return (local_stance(steady, moved_on(landing.root, seconds), print, yaw, pitch) -
            steady_stance(steady, own))
        .eval();
  };
  return (difference(moment_seconds, later) - difference(0.0, 0.0)) / moment_seconds;
}

FootNumbers landing_numbers(const SteppingLeg& leg, const LegCycle& steady) {
  FootNumbers end = steady_stance(steady, 0.0);
  end[0] = leg.landing[0].value;
  end[2] = leg.landing[1].value;
  end[3] = leg.landing[2].value;
  return end;
}

/// The foot raised where it would touch the floor in the middle of its swing. Who hardly gets on
/// lifts a foot higher than who walks: it does not swing past, it is set.
FootPose clear_of_floor(FootPose foot, const FootShape& shape, double x, double speed_m_s) {
  constexpr double walking = 0.004;
  constexpr double setting = 0.04;
  constexpr double slow_m_s = 0.35;
  const double slow = smooth_step(1.0 - speed_m_s / slow_m_s);
  const double least = walking + setting * slow * 16.0 * std::pow(x * (1.0 - x), 2.0);
  constexpr double soft = 0.003;
  constexpr double ends = 0.15;  // share of the swing in which it leaves or meets the floor
  const double lowest = std::min(toe_clearance(shape, foot), heel_clearance(shape, foot));
  const double missing = soft * std::log1p(std::exp((least - lowest) / soft));
  foot.ankle.y() += missing * smooth_step(x / ends) * smooth_step((1.0 - x) / ends);
  return foot;
}

FootNumbers swinging_numbers(const SteppingLeg& leg, const LegMoment& moment) {
  const LegCycle& steady = moment.steady;
  const double x = swing_share(leg, moment);
  const double stance = steady.pelvis.style.stance_share;
  FootNumbers foot = steady_swing(steady, stance + (1.0 - stance) * x);
  const double seconds = (1.0 - leg.toe_off) / std::max(moment.phase_rate, 0.2);
  const FootNumbers end = landing_numbers(leg, steady) - steady_stance(steady, 0.0);
  for (Eigen::Index i = 0; i < foot.size(); ++i) {
    foot[i] += quintic({leg.start[i], leg.start_rate[i] * seconds},
                       {end[i], leg.landing_rate[i] * seconds}, x);
  }
  return foot;
}

}  // namespace

double own_phase(const LegCycle& steady, double cycle_phase) {
  return wrapped_phase(cycle_phase - steady.phase_offset);
}

double swing_share(const SteppingLeg& leg, const LegMoment& moment) {
  const double left = leg.lands_at - moment.phase;
  return std::clamp(1.0 - left / (1.0 - leg.toe_off), 0.0, 1.0);
}

FootPose foot_of(const SteppingLeg& leg, const LegMoment& moment) {
  if (!leg.swinging) return foot_pose(standing_numbers(leg, moment));
  return clear_of_floor(foot_pose(swinging_numbers(leg, moment)), moment.steady.foot,
                        swing_share(leg, moment), moment.root.speed.value);
}

FootPose landing_foot(const SteppingLeg& leg, const LegMoment& moment) {
  return foot_pose(landing_numbers(leg, moment.steady));
}

void hold(SteppingLeg& leg, const LegMoment& moment) {
  const DampedSpring roll = stance_roll(moment);
  leg.held = true;
  leg.more_pitch.value += roll.value;
  leg.more_pitch.rate += roll.rate;
}

void release(SteppingLeg& leg, const LegMoment& moment) {
  const DampedSpring roll = stance_roll(moment);
  leg.held = false;
  leg.more_pitch.value -= roll.value;
  leg.more_pitch.rate -= roll.rate;
}

void lift_off(SteppingLeg& leg, const LegMoment& moment) {
  const LegCycle& steady = moment.steady;
  const double own = steady.pelvis.style.stance_share;
  const double step = moment_seconds * moment.phase_rate;
  const auto difference = [&](double seconds, double at, double more) {
    const double pitch = stance_pitch(steady.pelvis.style, at) + more;
    return (local_stance(steady, moved_on(moment.root, seconds), leg.print, leg.yaw, pitch) -
            steady_stance(steady, at))
        .eval();
  };
  const DampedSpring more = {leg.more_pitch.value - leg.heel_rise.value,
                             leg.more_pitch.rate - leg.heel_rise.rate};
  leg.start = difference(0.0, own, more.value);
  leg.start_rate = (leg.start - difference(-moment_seconds, own - step,
                                           more.value - more.rate * moment_seconds)) /
                   moment_seconds;
  leg.swinging = true;
  leg.more_pitch = {};
  leg.heel_rise = {};
  leg.toe_off = own;
  leg.lands_at = moment.phase + (1.0 - own);
}

void plan_swing(SteppingLeg& leg, const LegMoment& moment, const Landing& landing, double seconds) {
  const LegCycle& steady = moment.steady;
  const FootPose wanted =
      rolled_foot(steady.foot, landing.print, landing.yaw, stance_pitch(steady.pelvis.style, 0.0));
  const std::array<double, 3> goals = {wanted.ankle.x(), wanted.ankle.z(), wanted.yaw};
  // Late in the swing the foot goes where it is going.
  const double free = std::clamp((0.92 - swing_share(leg, moment)) / 0.45, 0.0, 1.0);
  for (std::size_t i = 0; i < goals.size(); ++i) {
    leg.landing[i] = std::isinf(seconds)
                         ? DampedSpring{goals[i], 0.0}
                         : spring_step(leg.landing[i], goals[i], free * landing_stiffness, seconds);
  }
  leg.landing_rate = landing_rate(moment, landing);
}

void settle(SteppingLeg& leg, double heel_rise, double seconds) {
  leg.heel_rise = spring_step(leg.heel_rise, heel_rise, heel_stiffness, seconds);
  leg.more_pitch = spring_step(leg.more_pitch, 0.0, pitch_stiffness, seconds);
}

void touch_down(SteppingLeg& leg, const LegMoment& moment) {
  const FootNumbers foot = swinging_numbers(leg, moment);
  leg.yaw = foot[3] + moment.root.heading;
  const FootPose unmoved = rolled_foot(moment.steady.foot, Vec3::Zero(), leg.yaw,
                                       stance_pitch(moment.steady.pelvis.style, 0.0));
  leg.print = horizontal(to_world(moment.root, foot.head<3>()) - unmoved.ankle);
  leg.swinging = false;
  leg.held = false;
  leg.more_pitch = {};
  leg.heel_rise = {};
}

}  // namespace mien::motion
