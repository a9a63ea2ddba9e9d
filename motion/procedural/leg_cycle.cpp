#include "motion/procedural/leg_cycle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mien::motion {

namespace {

Vec3 print(const LegCycle& leg) {
  const double start = leg.pelvis.stride_m * leg.phase_offset;
  return {leg.side * 0.5 * leg.pelvis.style.step_width_m, 0.0, start + leg.ahead_m};
}

double yaw(const LegCycle& leg) {
  return leg.side * radians_per_degree * leg.pelvis.style.foot_progression_deg;
}

LegLine leg_line(const LegCycle& leg, const Vec3& hip, const Vec3& ankle) {
  const Vec3 line = ankle - hip;
  return {knee_flexion_at(leg, line.norm()), std::atan2(line.z(), -line.y()), leg.side * line.x()};
}

Vec3 ankle_at(const LegCycle& leg, const Vec3& hip, const LegLine& line) {
  const double length = leg_length_at(leg, line.knee_flexion);
  const double sagittal = std::sqrt(std::max(0.0, length * length - line.outward * line.outward));
  return hip + Vec3(leg.side * line.outward, -sagittal * std::cos(line.swing),
                    sagittal * std::sin(line.swing));
}

/// Everything that has to go on smoothly from stance to swing and back.
struct StanceState {
  double knee;
  double swing;
  double outward;
  double pitch;
  double toe_extension;
};

StanceState stance_state(const LegCycle& leg, double phase) {
  const FootPose foot = planted_foot(leg, phase);
  const LegLine line = leg_line(leg, hip_position(leg, phase + leg.phase_offset), foot.ankle);
  const double normal = radians_per_degree * normal_knee_flexion_deg(phase);
  return {line.knee_flexion - normal, line.swing, line.outward, foot.pitch, foot.toe_extension};
}

/// Value and slope where the swing leaves the stance (`sign` −1: the states go back in time) or
/// meets it (+1: they go on). Slopes are taken with respect to the share of the swing.
CurveEnd curve_end(const std::array<StanceState, 3>& states, double StanceState::*member,
                   double sign, double step, double swing_share) {
  const double a = states[0].*member;
  const double b = states[1].*member;
  const double c = states[2].*member;
  return {a, sign * (-3.0 * a + 4.0 * b - c) / (2.0 * step) * swing_share};
}

std::array<StanceState, 3> stance_states(const LegCycle& leg, double phase, double step) {
  return {stance_state(leg, phase), stance_state(leg, phase + step),
          stance_state(leg, phase + 2.0 * step)};
}

/// A bump of height 1 at x = a/(a+b) of the swing; with a, b ≥ 2 it leaves values and slopes at the
/// ends alone.
double bump(double x, double a, double b) {
  const double peak = a / (a + b);
  return std::pow(x / peak, a) * std::pow((1.0 - x) / (1.0 - peak), b);
}

double share_of_swing(const LegCycle& leg, double phase) {
  const double stance = leg.pelvis.style.stance_share;
  return (phase - stance) / (1.0 - stance);
}

/// A foot turns fast while it leaves and meets the floor. Only part of that speed is carried into
/// the swing; the rest fades within a few hundredths of the cycle, or the curve would overshoot.
double at(const SwingCurve& curve, double x) {
  constexpr double carried = 0.3;
  constexpr double fading = 0.08;
  CurveEnd start = curve.toe_off;
  CurveEnd end = curve.heel_strike;
  const double start_rest = start.rate * (1.0 - carried);
  const double end_rest = end.rate * (1.0 - carried);
  start.rate *= carried;
  end.rate *= carried;
  return quintic(start, end, x) + start_rest * x * std::exp(-x / fading) -
         end_rest * (1.0 - x) * std::exp(-(1.0 - x) / fading);
}

/// The toes have come back level with the foot well before the foot lands.
double swing_toe_extension(const SwingCurve& curve, double x) {
  constexpr double done = 0.75;
  if (x >= done) return 0.0;
  CurveEnd start = curve.toe_off;
  start.rate *= done;
  return quintic(start, CurveEnd{}, x / done);
}

double swing_knee_flexion(const LegCycle& leg, double phase) {
  const double x = share_of_swing(leg, phase);
  const double flexion = radians_per_degree * normal_knee_flexion_deg(phase) +
                         at(leg.knee_correction, x) + leg.knee_peak * bump(x, 3, 6) +
                         leg.lift * bump(x, 3, 3) + leg.landing * bump(x, 8, 2);
  return std::max(flexion, 0.0);
}

constexpr int swing_samples = 64;

double swing_phase(const LegCycle& leg, int sample) {
  const double stance = leg.pelvis.style.stance_share;
  return stance + (1.0 - stance) * sample / swing_samples;
}

double peak_knee_flexion(const LegCycle& leg) {
  double peak = 0.0;
  for (int i = 0; i <= swing_samples; ++i) {
    peak = std::max(peak, swing_knee_flexion(leg, swing_phase(leg, i)));
  }
  return peak;
}

/// Least height of the toes in the middle of the swing. Near its ends the foot is close to the
/// floor because it leaves and meets it.
double mid_swing_clearance(const LegCycle& leg) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = swing_samples / 3; i <= 7 * swing_samples / 10; ++i) {
    least = std::min(least, toe_clearance(leg.foot, swinging_foot(leg, swing_phase(leg, i))));
  }
  return least;
}

/// Least height of any part of the foot from mid-swing to landing.
double landing_clearance(const LegCycle& leg) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = swing_samples / 3; i < swing_samples; ++i) {
    const FootPose foot = swinging_foot(leg, swing_phase(leg, i));
    least = std::min({least, toe_clearance(leg.foot, foot), heel_clearance(leg.foot, foot)});
  }
  return least;
}

/// The value of `knob` in [low, high] at which the increasing measure reaches `wanted`.
template <typename Measure>
void solve_increasing(double& knob, double low, double high, double wanted, Measure measure) {
  for (int i = 0; i < 40; ++i) {
    knob = 0.5 * (low + high);
    (measure() < wanted ? low : high) = knob;
  }
}

void reach_style(LegCycle& leg) {
  const WalkStyle& style = leg.pelvis.style;
  const double further = radians_per_degree * 5.0;  // the knee goes on bending after toe off
  const double peak = std::max(radians_per_degree * style.swing_knee_deg,
                               swing_knee_flexion(leg, style.stance_share) + further);
  solve_increasing(leg.knee_peak, -0.8, 0.8, peak, [&] { return peak_knee_flexion(leg); });
  if (mid_swing_clearance(leg) < style.foot_clearance_m) {
    solve_increasing(leg.lift, 0.0, 0.8, style.foot_clearance_m,
                     [&] { return mid_swing_clearance(leg); });
  }
  if (landing_clearance(leg) < 0.0) {
    solve_increasing(leg.landing, 0.0, 0.8, 0.0, [&] { return landing_clearance(leg); });
  }
}

}  // namespace

double leg_length_at(const LegCycle& leg, double knee_flexion) {
  const double a = leg.thigh_m;
  const double b = leg.shank_m;
  return std::sqrt(a * a + b * b + 2.0 * a * b * std::cos(knee_flexion));
}

double knee_flexion_at(const LegCycle& leg, double distance) {
  const double a = leg.thigh_m;
  const double b = leg.shank_m;
  const double cosine = (distance * distance - a * a - b * b) / (2.0 * a * b);
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

Vec3 hip_position(const LegCycle& leg, double cycle_phase) {
  return pelvis_position(leg.pelvis, cycle_phase) +
         pelvis_rotation(leg.pelvis, cycle_phase) * leg.hip_offset;
}

FootPose planted_foot(const LegCycle& leg, double phase) {
  return stance_foot(leg.foot, leg.pelvis.style, print(leg), yaw(leg), phase);
}

LegCycle with_swing_curves(LegCycle leg) {
  constexpr double step = 1e-3;
  const double stance = leg.pelvis.style.stance_share;
  const auto leaving = stance_states(leg, stance, -step);
  const auto landing = stance_states(leg, 0.0, step);
  const auto curve = [&](double StanceState::*member) {
    return SwingCurve{curve_end(leaving, member, -1.0, step, 1.0 - stance),
                      curve_end(landing, member, 1.0, step, 1.0 - stance)};
  };
  leg.knee_correction = curve(&StanceState::knee);
  leg.swing_angle = curve(&StanceState::swing);
  leg.outward = curve(&StanceState::outward);
  leg.pitch = curve(&StanceState::pitch);
  leg.toe_extension = curve(&StanceState::toe_extension);
  leg.knee_correction.heel_strike.rate = 0.0;
  return leg;
}

LegCycle fit_swing(LegCycle leg) {
  leg = with_swing_curves(leg);
  reach_style(leg);
  return leg;
}

FootPose swinging_foot(const LegCycle& leg, double phase) {
  const double x = share_of_swing(leg, phase);
  LegLine line;
  line.knee_flexion = swing_knee_flexion(leg, phase);
  line.swing = at(leg.swing_angle, x);
  constexpr double circumduction = 0.014;  // of the leg's length: the foot passes outside
  line.outward = at(leg.outward, x) + circumduction * (leg.thigh_m + leg.shank_m) * bump(x, 3, 3);
  FootPose foot;
  foot.yaw = yaw(leg);
  foot.pitch = at(leg.pitch, x) + 0.5 * leg.lift * bump(x, 3, 3);
  foot.toe_extension = swing_toe_extension(leg.toe_extension, x);
  foot.ankle = ankle_at(leg, hip_position(leg, phase + leg.phase_offset), line);
  return foot;
}

FootPose foot_at(const LegCycle& leg, double cycle_phase) {
  const double phase = wrapped_phase(cycle_phase - leg.phase_offset);
  const double cycles_before = std::round(cycle_phase - leg.phase_offset - phase);
  FootPose foot =
      phase <= leg.pelvis.style.stance_share ? planted_foot(leg, phase) : swinging_foot(leg, phase);
  foot.ankle.z() += cycles_before * leg.pelvis.stride_m;
  return foot;
}

}  // namespace mien::motion
