#pragma once

#include <span>

namespace mien::motion {

/// One term of a Fourier series over the gait cycle: c·cos(2πnφ) + s·sin(2πnφ).
struct Harmonic {
  int n = 1;
  double c = 0.0;
  double s = 0.0;
};

/// Returns mean + Σ harmonics at `phase` (in gait cycles; any real number).
double fourier(double mean, std::span<const Harmonic> harmonics, double phase);

/// A cosine with `n` periods in a gait cycle, +1 at phase `peak`.
double wave(int n, double phase, double peak);

/// Value and slope of a curve at one end.
struct CurveEnd {
  double value = 0.0;
  double rate = 0.0;
};

/// The polynomial of degree 5 with these values and slopes at its ends and zero second derivatives
/// there; x ∈ [0, 1], slopes with respect to x.
double quintic(const CurveEnd& from, const CurveEnd& to, double x);

/// `phase` brought into [0, 1).
double wrapped_phase(double phase);

/// Knee flexion of level walking, degrees, from the leg's own heel strike (phase 0): loading peak
/// of about 19° at 15 % of the cycle, nearly straight at 42 %, swing peak of about 63° at 73 %.
/// Five harmonics fitted to the shape tabulated in gait textbooks (Winter 1991; Perry & Burnfield
/// 2010).
double normal_knee_flexion_deg(double phase);

/// The remaining curves with amplitude 1, as functions of the phase of the left leg. The right leg
/// is half a cycle later.
///
/// Axial rotation of the pelvis: +1 with the left hip forward, at left heel strike.
double pelvis_rotation_shape(double phase);
/// Pelvic obliquity: +1 with the left hip high, early in left single support.
double pelvis_obliquity_shape(double phase);
/// Axial rotation of the shoulder line: +1 with the left shoulder forward, near right heel strike.
double shoulder_rotation_shape(double phase, double sharpness);
/// Upper arm: +1 at the forward end of the left arm's swing, just after right heel strike.
double arm_swing_shape(double phase, double sharpness);
/// Elbow: +1 at the most flexed, −1 at the least; the elbow stays extended longer behind the body
/// than in front of it.
double elbow_shape(double phase, double sharpness);

}  // namespace mien::motion
