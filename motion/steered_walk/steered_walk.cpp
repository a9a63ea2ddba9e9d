#include "motion/steered_walk/steered_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/steered_walk/step_plan.h"

namespace mien::motion {

namespace {

constexpr double longest_step = 1.0 / 60.0;  // seconds of time within which goals stay
constexpr double mood_stiffness = 16.0;      // 1/s: half of a change within 0.1 s
constexpr double gait_stiffness = 7.0;       // 1/s: of the legs, which have to finish a step
/// Whether it is to walk or turn: what starts it must be more than what keeps it going.
bool is_asked_to_move(const SteeredWalk& walker, const Steering& steering) {
  const double least = radians_per_degree * (walker.stepping ? 5.0 : 9.0);
  return steering.pace > 0.02 ||
         (steering.heading ? std::abs(remaining_turn(walker.root, steering)) > least
                           : std::abs(steering.turning) > 0.05);
}

double own_speed_of(const WalkerGaits& gaits, const SteeredWalk& walker) {
  return own_speed(gaits, shares_of(walker.gaits));
}

LegMoment moment_of(const SteeredWalk& walker, const LegCycle& steady) {
  return {steady, walker.root, walker.phase, walker.phase_rate};
}

/// Phase, above `phase`, at which a standing walker waits: the heel of one foot is about to rise.
double next_rest_phase(const WalkStyle& style, double phase) {
  constexpr double before = 0.02;
  constexpr double way = 0.2;
  const double rest = style.heel_rise_share - before;
  return rest + 0.5 * std::ceil((phase + way - rest) / 0.5);
}

void come_to_stand(SteeredWalk& walker, const SteeredMoment& moment, std::size_t landed) {
  walker.stepping = false;
  const std::size_t other = 1 - landed;
  hold(walker.legs[other], moment_of(walker, moment.legs[other]));
  walker.rest_phase = next_rest_phase(moment.gait.style, walker.phase);
  walker.rest_stiffness = std::max(2.5, walker.phase_rate / (walker.rest_phase - walker.phase));
  walker.centring = {};
}

/// Chooses the foot that goes first: into the turn, else the one behind.
void start_stepping(SteeredWalk& walker, const Steering& steering) {
  walker.stepping = true;
  walker.started = false;
  if (walker.activity.value > 0.02 || std::abs(walker.phase_rate) > 0.05) return;
  const double turn = steering.heading ? remaining_turn(walker.root, steering) : steering.turning;
  const double left = to_local(walker.root, walker.legs[0].print).z();
  const double right = to_local(walker.root, walker.legs[1].print).z();
  const bool turns = std::abs(turn) > radians_per_degree * 15.0;
  const bool wants_left = turns ? turn > 0.0 : left < right;
  const bool left_is_next = wrapped_phase(walker.phase) < 0.5;
  if (wants_left != left_is_next) walker.phase += 0.5;
}

/// Feet that wait go on with their stance, or wait when it is time to stand.
void hold_or_release(SteeredWalk& walker, const SteeredMoment& moment) {
  for (std::size_t side = 0; side < 2; ++side) {
    SteppingLeg& leg = walker.legs[side];
    if (leg.swinging) continue;
    const LegMoment now = moment_of(walker, moment.legs[side]);
    const WalkStyle& style = now.steady.pelvis.style;
    const double own = own_phase(now.steady, now.phase);
    const double late = style.heel_rise_share + 0.6 * (style.stance_share - style.heel_rise_share);
    if (walker.stepping && leg.held && own > 0.15 && own < late) release(leg, now);
    if (!walker.stepping && !leg.held && own > 0.15 && own < 0.9) hold(leg, now);
  }
}

/// Cycle phase until the next standing foot that walks leaves the floor.
double until_lift_off(const SteeredWalk& walker, const SteeredMoment& moment) {
  double phase = 1.0;
  for (std::size_t side = 0; side < 2; ++side) {
    const LegCycle& steady = moment.legs[side];
    if (walker.legs[side].swinging || walker.legs[side].held) continue;
    const double own = own_phase(steady, walker.phase);
    if (own < 0.95) phase = std::min(phase, steady.pelvis.style.stance_share - own);
  }
  return phase;
}

/// Share of the wanted speed and turning: who stands sets out only when a foot is about to leave.
double setting_out(const SteeredWalk& walker, const SteeredMoment& moment) {
  if (!walker.stepping) return 0.0;
  if (walker.started) return 1.0;
  const double seconds = until_lift_off(walker, moment) / cycle_rate(moment.legs[0]);
  return std::clamp((0.45 - seconds) / 0.2, 0.0, 1.0);
}

double until_event(const SteeredWalk& walker, const SteeredMoment& moment) {
  double phase = std::numeric_limits<double>::infinity();
  for (std::size_t side = 0; side < 2; ++side) {
    const SteppingLeg& leg = walker.legs[side];
    if (leg.held) continue;
    const LegCycle& steady = moment.legs[side];
    const double own = own_phase(steady, walker.phase);
    const double stance = steady.pelvis.style.stance_share;
    if (leg.swinging)
      phase = std::min(phase, leg.lands_at - walker.phase);
    else if (own < 0.95)
      phase = std::min(phase, std::max(0.0, stance - own));
  }
  return std::max(0.0, phase) / std::max(walker.phase_rate, 1e-6);
}

void take_steps(const WalkerGaits& gaits, const Steering& steering, const SteeredMoment& moment,
                SteeredWalk& walker) {
  const double own = own_speed_of(gaits, walker);
  for (std::size_t side = 0; side < 2; ++side) {
    SteppingLeg& leg = walker.legs[side];
    const LegMoment now = moment_of(walker, moment.legs[side]);
    const double phase = own_phase(now.steady, now.phase);
    const double stance = now.steady.pelvis.style.stance_share;
    constexpr double exactly = 1e-9;
    if (leg.swinging && walker.phase >= leg.lands_at - exactly) {
      touch_down(leg, now);
      const RootMotion rest = predicted(walker.root, steering, own, 1.5);
      if (!is_asked_to_move(walker, steering) && walker.root.speed.value < 0.4 &&
          stands_well(walker, moment, rest)) {
        come_to_stand(walker, moment, side);
      }
    } else if (!leg.swinging && !leg.held && phase >= stance - exactly && phase < 0.95) {
      lift_off(leg, now);
      walker.started = true;
      plan_swing(leg, now, landing_of(walker, moment, side, steering, own),
                 std::numeric_limits<double>::infinity());
    }
  }
}

/// Moves the root of a standing walker over the centre of its feet.
void centre(SteeredWalk& walker, const SteeredMoment& moment, double seconds) {
  RootMotion& root = walker.root;
  const double heading =
      root.heading + 0.5 * (std::remainder(walker.legs[0].yaw - root.heading, 2.0 * pi) +
                            std::remainder(walker.legs[1].yaw - root.heading, 2.0 * pi));
  RootMotion turned = root;
  turned.heading = heading;
  const Vec3 middle = 0.5 * (walker.legs[0].print + walker.legs[1].print) -
                      moment.gait.ahead_m * forward_of(turned);
  const std::array<double, 3> goals = {middle.x(), middle.z(), heading};
  std::array<double*, 3> values = {&root.place.x(), &root.place.z(), &root.heading};
  for (std::size_t i = 0; i < goals.size(); ++i) {
    DampedSpring& follower = walker.centring[i];
    follower.value = *values[i];
    if (walker.stepping) {
      const double left = std::exp(-8.0 * seconds);
      *values[i] += follower.rate * seconds;
      follower.rate *= left;
    } else {
      constexpr double centring_stiffness = 3.0;
      follower = spring_step(follower, goals[i], centring_stiffness, seconds);
      *values[i] = follower.value;
    }
  }
}

void follow_moods(const Steering& steering, double seconds, SteeredWalk& walker) {
  const std::vector<double> goals = mood_goals(steering.moods, walker.moods.size());
  for (std::size_t m = 0; m < goals.size(); ++m) {
    walker.moods[m] = spring_step(walker.moods[m], goals[m], mood_stiffness, seconds);
    walker.gaits[m] = spring_step(walker.gaits[m], goals[m], gait_stiffness, seconds);
  }
}

void follow_phase(const SteeredMoment& moment, double seconds, SteeredWalk& walker) {
  if (walker.stepping) {
    constexpr double rate_stiffness = 12.0;
    constexpr double hurry = 1.5;  // of a phase in which nothing moves
    const double goal = cycle_rate(moment.legs[0]) * (walker.started ? 1.0 : hurry);
    const double before = walker.phase_rate;
    walker.phase_rate += (goal - before) * (1.0 - std::exp(-rate_stiffness * seconds));
    walker.phase += 0.5 * (before + walker.phase_rate) * seconds;
    return;
  }
  const DampedSpring next = spring_step({walker.phase, walker.phase_rate}, walker.rest_phase,
                                        walker.rest_stiffness, seconds);
  walker.phase = next.value;
  walker.phase_rate = next.rate;
}

/// One step of time within which no foot comes down or leaves but at its end.
void move_on(const WalkerGaits& gaits, const Steering& steering, const SteeredMoment& moment,
             double seconds, SteeredWalk& walker) {
  const double own = own_speed_of(gaits, walker);
  const RootGoal goal = goal_of(walker.root, steering, own);
  const double share = setting_out(walker, moment);
  walker.root = advanced(walker.root, share * goal.speed, share * goal.turning, seconds);
  follow_moods(steering, seconds, walker);
  follow_phase(moment, seconds, walker);
  centre(walker, moment, seconds);
  walker.activity = spring_step(walker.activity, walker.stepping ? 1.0 : 0.0,
                                walker.stepping ? 9.0 : 5.0, seconds);
  const double ahead =
      steering.heading && walker.stepping ? 0.5 * remaining_turn(walker.root, steering) : 0.0;
  const double gaze = std::clamp(ahead + 0.4 * share * goal.turning, -0.6, 0.6);
  walker.gaze = spring_step(walker.gaze, gaze, 6.0, seconds);
  walker.seconds += seconds;
}

}  // namespace

SteeredWalk standing_walker(const WalkerGaits& gaits, const Vec3& place, double heading,
                            const std::vector<double>& moods) {
  SteeredWalk walker;
  walker.root.place = horizontal(place);
  walker.root.heading = heading;
  for (const double share : mood_goals(moods, gaits.moods.size())) {
    walker.moods.push_back({share, 0.0});
  }
  walker.gaits = walker.moods;
  const SteeredMoment moment = moment_at(gaits, walker);
  for (std::size_t side = 0; side < 2; ++side) {
    const LegCycle& steady = moment.legs[side];
    walker.legs[side].print =
        to_world(walker.root,
                 {0.5 * steady.side * steady.pelvis.style.step_width_m, 0.0, moment.gait.ahead_m});
    walker.legs[side].yaw =
        heading + steady.side * radians_per_degree * steady.pelvis.style.foot_progression_deg;
  }
  walker.phase = walker.rest_phase = next_rest_phase(moment.gait.style, -0.4);
  return walker;
}

void advance(const WalkerGaits& gaits, const Steering& steering, double seconds,
             SteeredWalk& walker) {
  while (seconds > 1e-12) {
    if (!walker.stepping && is_asked_to_move(walker, steering)) start_stepping(walker, steering);
    SteeredMoment moment = moment_at(gaits, walker);
    hold_or_release(walker, moment);
    const double step =
        std::min({seconds, longest_step, std::max(1e-6, until_event(walker, moment))});
    move_on(gaits, steering, moment, step, walker);
    moment = moment_at(gaits, walker);
    const double own = own_speed_of(gaits, walker);
    for (std::size_t side = 0; side < 2; ++side) {
      if (!walker.legs[side].swinging) continue;
      plan_swing(walker.legs[side], moment_of(walker, moment.legs[side]),
                 landing_of(walker, moment, side, steering, own), step);
    }
    take_steps(gaits, steering, moment, walker);
    follow_reach(moment, step, walker);
    seconds -= step;
  }
}

bool at_rest(const SteeredWalk& walker) {
  return !walker.stepping && walker.activity.value < 0.02 &&
         std::abs(walker.root.speed.value) < 0.005;
}

}  // namespace mien::motion
