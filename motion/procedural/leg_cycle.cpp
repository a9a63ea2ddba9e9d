#include "motion/procedural/leg_cycle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace mien::motion {

namespace {

constexpr double top = 0.285;           // phase of the highest point, in left single support
constexpr double fastest = 0.08;        // phase of the greatest forward speed
constexpr double surge = 0.04;          // amplitude of the forward speed, of its mean
constexpr double leftmost = 0.30;       // phase
constexpr double tilt_amplitude = 1.0;  // degrees, twice a cycle

/// A dip of depth 1 in each loading response, otherwise near 0: a raised cosine to the fourth
/// power.
double loading_dip(double phase) {
  constexpr double deepest = 0.12;
  const double raised = 0.5 + 0.5 * wave(2, phase, deepest);
  return raised * raised;
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

/// What a leg is at a phase of its swing apart from the angles that `fit_swing` looks for, and what
/// share of each of those it takes.
struct SwingMoment {
  LegLine line;
  double pitch;
  double toe_extension;
  double early, middle, late;  ///< shares of knee_peak, lift and landing
  Vec3 hip;
};

SwingMoment swing_moment(const LegCycle& leg, double phase) {
  const double x = share_of_swing(leg, phase);
  SwingMoment moment;
  moment.early = bump(x, 3, 6);
  moment.middle = bump(x, 3, 3);
  moment.late = bump(x, 8, 2);
  moment.line.knee_flexion =
      radians_per_degree * normal_knee_flexion_deg(phase) + at(leg.knee_correction, x);
  moment.line.swing = at(leg.swing_angle, x);
  constexpr double circumduction = 0.014;  // of the leg's length: the foot passes outside
  moment.line.outward =
      at(leg.outward, x) + circumduction * (leg.thigh_m + leg.shank_m) * moment.middle;
  moment.pitch = at(leg.pitch, x);
  moment.toe_extension = swing_toe_extension(leg.toe_extension, x);
  moment.hip = hip_position(leg, phase + leg.phase_offset);
  return moment;
}

double knee_flexion_in(const LegCycle& leg, const SwingMoment& moment) {
  const double flexion = moment.line.knee_flexion + leg.knee_peak * moment.early +
                         leg.lift * moment.middle + leg.landing * moment.late;
  return std::max(flexion, 0.0);
}

FootPose foot_in(const LegCycle& leg, const SwingMoment& moment) {
  LegLine line = moment.line;
  line.knee_flexion = knee_flexion_in(leg, moment);
  FootPose foot;
  foot.yaw = yaw_of(leg);
  foot.pitch = moment.pitch + 0.5 * leg.lift * moment.middle;
  foot.toe_extension = moment.toe_extension;
  foot.ankle = ankle_at(leg, moment.hip, line);
  return foot;
}

constexpr int swing_samples = 64;
using SwingMoments = std::array<SwingMoment, swing_samples + 1>;

SwingMoments swing_moments(const LegCycle& leg) {
  const double stance = leg.pelvis.style.stance_share;
  SwingMoments moments;
  for (int i = 0; i <= swing_samples; ++i) {
    const double phase = stance + (1.0 - stance) * i / swing_samples;
    moments[static_cast<std::size_t>(i)] = swing_moment(leg, phase);
  }
  return moments;
}

bool reaches_knee_flexion(const LegCycle& leg, const SwingMoments& moments, double wanted) {
  return std::any_of(moments.begin(), moments.end(), [&](const SwingMoment& moment) {
    return knee_flexion_in(leg, moment) >= wanted;
  });
}

/// Whether the toes are so high in the middle of the swing. Near its ends the foot is close to the
/// floor because it leaves and meets it.
bool clears_in_mid_swing(const LegCycle& leg, const SwingMoments& moments, double wanted) {
  const std::span middle(&moments[swing_samples / 3], &moments[7 * swing_samples / 10 + 1]);
  return std::all_of(middle.begin(), middle.end(), [&](const SwingMoment& moment) {
    return toe_clearance(leg.foot, foot_in(leg, moment)) >= wanted;
  });
}

/// Whether no part of the foot is in the floor from mid-swing to landing.
bool comes_from_above(const LegCycle& leg, const SwingMoments& moments) {
  const std::span later(&moments[swing_samples / 3], &moments[swing_samples]);
  return std::all_of(later.begin(), later.end(), [&](const SwingMoment& moment) {
    const FootPose foot = foot_in(leg, moment);
    return toe_clearance(leg.foot, foot) >= 0.0 && heel_clearance(leg.foot, foot) >= 0.0;
  });
}

/// The value of `knob` in [low, high] from which on `is_enough`.
template <typename Enough>
void find_enough(double& knob, double low, double high, Enough is_enough) {
  for (int i = 0; i < 40; ++i) {
    knob = 0.5 * (low + high);
    (is_enough() ? high : low) = knob;
  }
}

void reach_style(LegCycle& leg) {
  const WalkStyle& style = leg.pelvis.style;
  const SwingMoments moments = swing_moments(leg);
  const double further = radians_per_degree * 5.0;  // the knee goes on bending after toe off
  const double peak = std::max(radians_per_degree * style.swing_knee_deg,
                               knee_flexion_in(leg, moments.front()) + further);
  find_enough(leg.knee_peak, -0.8, 0.8, [&] { return reaches_knee_flexion(leg, moments, peak); });
  const auto clears = [&] { return clears_in_mid_swing(leg, moments, style.foot_clearance_m); };
  if (!clears()) find_enough(leg.lift, 0.0, 0.8, clears);
  const auto lands = [&] { return comes_from_above(leg, moments); };
  if (!lands()) find_enough(leg.landing, 0.0, 0.8, lands);
}

}  // namespace

Vec3 pelvis_position(const PelvisPath& path, double phase) {
  const double surge_length = surge * path.stride_m / (4.0 * pi);
  return {0.5 * path.style.sway_m * wave(1, phase, leftmost),
          path.mean_height_m +
              0.5 * path.style.bounce_m * (wave(2, phase, top) + 0.14 * wave(4, phase, 0.14)) -
              path.style.impact_m * loading_dip(phase),
          path.stride_m * phase + surge_length * std::sin(4.0 * pi * (phase - fastest))};
}

Quat pelvis_rotation(const PelvisPath& path, double phase) {
  const double yaw = -path.style.pelvis_rotation_deg * pelvis_rotation_shape(phase);
  const double obliquity = path.style.pelvis_obliquity_deg * pelvis_obliquity_shape(phase);
  const double tilt = path.style.pelvis_tilt_deg + tilt_amplitude * wave(2, phase, 0.02);
  return Quat(Eigen::AngleAxisd(radians_per_degree * yaw, Vec3::UnitY()) *
              Eigen::AngleAxisd(radians_per_degree * obliquity, Vec3::UnitZ()) *
              Eigen::AngleAxisd(radians_per_degree * tilt, Vec3::UnitX()));
}

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

Vec3 print_of(const LegCycle& leg) {
  const double start = leg.pelvis.stride_m * leg.phase_offset;
  return {leg.side * 0.5 * leg.pelvis.style.step_width_m, 0.0, start + leg.ahead_m};
}

double yaw_of(const LegCycle& leg) {
  return leg.side * radians_per_degree * leg.pelvis.style.foot_progression_deg;
}

FootPose planted_foot(const LegCycle& leg, double phase) {
  return stance_foot(leg.foot, leg.pelvis.style, print_of(leg), yaw_of(leg), phase);
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
  return foot_in(leg, swing_moment(leg, phase));
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
