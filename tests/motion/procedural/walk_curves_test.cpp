#include "motion/procedural/walk_curves.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

double slope(const CurveEnd& from, const CurveEnd& to, double x) {
  constexpr double h = 1e-6;
  return (quintic(from, to, x + h) - quintic(from, to, x - h)) / (2.0 * h);
}

double curvature(const CurveEnd& from, const CurveEnd& to, double x) {
  constexpr double h = 1e-4;
  return (quintic(from, to, x + h) - 2.0 * quintic(from, to, x) + quintic(from, to, x - h)) /
         (h * h);
}

TEST(WalkCurves, QuinticMeetsItsEndsWithoutCurvature) {
  const CurveEnd from{2.0, -3.0};
  const CurveEnd to{-1.0, 5.0};
  EXPECT_DOUBLE_EQ(quintic(from, to, 0.0), 2.0);
  EXPECT_NEAR(quintic(from, to, 1.0), -1.0, 1e-12);
  EXPECT_NEAR(slope(from, to, 0.0), -3.0, 1e-6);
  EXPECT_NEAR(slope(from, to, 1.0), 5.0, 1e-6);
  EXPECT_NEAR(curvature(from, to, 0.0), 0.0, 0.05);
  EXPECT_NEAR(curvature(from, to, 1.0), 0.0, 0.05);
}

TEST(WalkCurves, FourierSumsItsHarmonics) {
  const std::array<Harmonic, 2> harmonics = {{{1, 2.0, 0.0}, {2, 0.0, 3.0}}};
  EXPECT_NEAR(fourier(1.0, harmonics, 0.0), 3.0, 1e-12);
  EXPECT_NEAR(fourier(1.0, harmonics, 0.125), 1.0 + std::sqrt(2.0) + 3.0, 1e-12);
  EXPECT_NEAR(fourier(1.0, harmonics, -0.875), fourier(1.0, harmonics, 0.125), 1e-12);
}

TEST(WalkCurves, NormalKneeHasItsTwoFlexionWaves) {
  // Level walking at natural cadence (Winter 1991): degrees, within two.
  EXPECT_NEAR(normal_knee_flexion_deg(0.00), 4.0, 2.0);
  EXPECT_NEAR(normal_knee_flexion_deg(0.15), 19.0, 2.0);
  EXPECT_NEAR(normal_knee_flexion_deg(0.40), 6.0, 2.0);
  EXPECT_NEAR(normal_knee_flexion_deg(0.60), 38.5, 2.0);
  EXPECT_NEAR(normal_knee_flexion_deg(0.73), 62.5, 2.0);
  EXPECT_NEAR(normal_knee_flexion_deg(0.975), 4.0, 2.0);
}

TEST(WalkCurves, ShapesAreOppositeHalfACycleLaterAndOfAmplitudeOne) {
  double pelvis = 0.0;
  double obliquity = 0.0;
  double arm = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double phase = i / 200.0;
    EXPECT_NEAR(pelvis_rotation_shape(phase), -pelvis_rotation_shape(phase + 0.5), 1e-12);
    EXPECT_NEAR(pelvis_obliquity_shape(phase), -pelvis_obliquity_shape(phase + 0.5), 1e-12);
    EXPECT_NEAR(arm_swing_shape(phase, 0.8), -arm_swing_shape(phase + 0.5, 0.8), 1e-12);
    pelvis = std::max(pelvis, pelvis_rotation_shape(phase));
    obliquity = std::max(obliquity, pelvis_obliquity_shape(phase));
    arm = std::max(arm, arm_swing_shape(phase, 0.8));
    EXPECT_LE(std::abs(elbow_shape(phase, 0.0)), 1.0 + 1e-12);
  }
  EXPECT_NEAR(pelvis, 1.0, 0.01);
  EXPECT_NEAR(obliquity, 1.0, 0.02);
  EXPECT_NEAR(arm, 1.0, 0.01);
}

TEST(WalkCurves, SharpSwingDwellsAtItsEnds) {
  int soft = 0;
  int sharp = 0;
  for (int i = 0; i < 1000; ++i) {
    soft += std::abs(arm_swing_shape(i / 1000.0, -1.0)) > 0.8;
    sharp += std::abs(arm_swing_shape(i / 1000.0, 1.0)) > 0.8;
  }
  EXPECT_GT(sharp, soft + 100);
}

TEST(WalkCurves, PhasesWrapIntoOneCycle) {
  EXPECT_DOUBLE_EQ(wrapped_phase(1.25), 0.25);
  EXPECT_DOUBLE_EQ(wrapped_phase(-0.25), 0.75);
  EXPECT_DOUBLE_EQ(wrapped_phase(2.0), 0.0);
}

}  // namespace
}  // namespace mien::motion
