#include "motion/math/spring_damper.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/math/geometry.h"

namespace mien::motion {
namespace {

/// Response of x'' + 2ζω·x' + ω²·x = ω² from rest at 0, as in textbooks of control.
double unit_step_response(double w, double z, double t) {
  if (z < 1.0) {
    const double wd = w * std::sqrt(1.0 - z * z);
    return 1.0 - std::exp(-z * w * t) *
                     (std::cos(wd * t) + z / std::sqrt(1.0 - z * z) * std::sin(wd * t));
  }
  if (z == 1.0) return 1.0 - std::exp(-w * t) * (1.0 + w * t);
  const double root = std::sqrt(z * z - 1.0);
  const double slow = w * (z - root), fast = w * (z + root);
  return 1.0 - (fast * std::exp(-slow * t) - slow * std::exp(-fast * t)) / (fast - slow);
}

TEST(SpringDamper, AnswersAStepAsTheTextbookSays) {
  for (const double z : {0.0, 0.3, 0.7, 0.999, 1.0, 1.001, 1.5, 4.0}) {
    const SpringDamper spring{7.0, z};
    for (const double step : {0.001, 0.037, 0.4}) {
      SpringState state{-1.0, 0.0};
      for (int i = 1; i * step < 2.5; ++i) {
        state = after(state, spring, 0.0, 0.0, step);
        EXPECT_NEAR(1.0 + state.offset, unit_step_response(7.0, z, i * step), 1e-9)
            << "damping " << z << ", after " << i * step << " s";
      }
    }
  }
}

TEST(SpringDamper, OvershootsOnlyBelowCriticalDamping) {
  for (const double z : {0.2, 0.5, 0.8, 1.0, 2.0}) {
    double highest = 0.0;
    for (int i = 1; i < 20000; ++i) {
      const SpringState state = after({-1.0, 0.0}, {5.0, z}, 0.0, 0.0, 0.001 * i);
      highest = std::max(highest, 1.0 + state.offset);
    }
    const double expected = z < 1.0 ? 1.0 + std::exp(-pi * z / std::sqrt(1.0 - z * z)) : 1.0;
    EXPECT_NEAR(highest, expected, 1e-5) << z;
  }
}

TEST(SpringDamper, FollowsAMovingTargetUnderAForceAtASteadyDistance) {
  const SpringDamper spring{12.0, 0.6};
  const SpringState state = after({0.3, -2.0}, spring, 1.5, 4.0, 30.0);
  EXPECT_NEAR(state.speed, 1.5, 1e-9);
  EXPECT_NEAR(state.offset, (4.0 - 2.0 * 0.6 * 12.0 * 1.5) / (12.0 * 12.0), 1e-9);
}

TEST(SpringDamper, IsTheSameInManyStepsAsInOne) {
  for (const double z : {0.4, 1.0, 2.5}) {
    const SpringState once = after({0.2, 1.0}, {9.0, z}, -0.7, 3.0, 1.0);
    SpringState often{0.2, 1.0};
    for (int i = 0; i < 1000; ++i) often = after(often, {9.0, z}, -0.7, 3.0, 0.001);
    EXPECT_NEAR(once.offset, often.offset, 1e-9) << z;
    EXPECT_NEAR(once.speed, often.speed, 1e-9) << z;
  }
}

TEST(SpringDamper, OfGreatStiffnessIsAtItsTargetAtOnce) {
  for (const double z : {0.5, 1.0, 3.0}) {
    const SpringState state = after({0.5, 20.0}, {1e7, z}, 2.0, 50.0, 0.01);
    EXPECT_NEAR(state.offset, 0.0, 1e-5) << z;
    EXPECT_NEAR(state.speed, 2.0, 1e-3) << z;
  }
}

}  // namespace
}  // namespace mien::motion
