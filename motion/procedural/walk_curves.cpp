#include "motion/procedural/walk_curves.h"

#include <array>
#include <cmath>

#include "motion/math/geometry.h"

namespace mien::motion {

double fourier(double mean, std::span<const Harmonic> harmonics, double phase) {
  double value = mean;
  for (const Harmonic& h : harmonics) {
    const double angle = 2.0 * pi * h.n * phase;
    value += h.c * std::cos(angle) + h.s * std::sin(angle);
  }
  return value;
}

double wave(int n, double phase, double peak) { return std::cos(2.0 * pi * n * (phase - peak)); }

double quintic(const CurveEnd& from, const CurveEnd& to, double x) {
  const double rise = to.value - from.value - from.rate;
  const double bend = to.rate - from.rate;
  const double c3 = 10.0 * rise - 4.0 * bend;
  const double c4 = -15.0 * rise + 7.0 * bend;
  const double c5 = 6.0 * rise - 3.0 * bend;
  return from.value + x * (from.rate + x * x * (c3 + x * (c4 + x * c5)));
}

double wrapped_phase(double phase) { return phase - std::floor(phase); }

double normal_knee_flexion_deg(double phase) {
  constexpr std::array<Harmonic, 5> harmonics = {{{1, -2.38, -20.82},
                                                  {2, -15.14, 6.99},
                                                  {3, -0.76, 3.38},
                                                  {4, -1.32, 0.67},
                                                  {5, -0.22, 0.57}}};
  return fourier(24.21, harmonics, phase);
}

namespace {

/// A cosine whose phase runs ahead and falls behind twice a cycle: for k > 0 it dwells at its
/// extremes, for k < 0 it hurries through them.
double shaped_cosine(double phase, double k) {
  return std::cos(2.0 * pi * phase - 0.5 * k * std::sin(4.0 * pi * phase));
}

constexpr double shoulder_peak = 0.53;
constexpr double arm_peak = 0.54;
constexpr double dwell = 0.45;  // largest k that still looks like a living arm

}  // namespace

double pelvis_rotation_shape(double phase) { return wave(1, phase, 0.01); }

double pelvis_obliquity_shape(double phase) {
  // The third harmonic makes the drop of the swinging side quick (in the loading response) and its
  // recovery slow.
  constexpr double peak = 0.19;
  return 0.68 * wave(1, phase, peak + 0.03) + 0.34 * wave(3, phase, peak);
}

double shoulder_rotation_shape(double phase, double sharpness) {
  return shaped_cosine(phase - shoulder_peak, dwell * sharpness);
}

double arm_swing_shape(double phase, double sharpness) {
  return shaped_cosine(phase - arm_peak, dwell * sharpness);
}

double elbow_shape(double phase, double sharpness) {
  const double swing = shaped_cosine(phase - arm_peak, dwell * sharpness);
  return swing + 0.18 * (swing * swing - 1.0);
}

}  // namespace mien::motion
