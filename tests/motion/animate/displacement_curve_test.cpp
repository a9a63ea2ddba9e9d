#include "motion/animate/displacement_curve.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

CurveKey key(double seconds, const Vec3& value, double reach = 0.5) {
  return {seconds, seconds, value, reach, reach};
}

Vec3 random_place(std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  return {any(random), any(random), any(random)};
}

/// Keys at uneven times, some of whose reaches overlap, some of which hold.
std::vector<CurveKey> random_keys(std::mt19937_64& random, double until) {
  std::uniform_real_distribution<double> step(0.1, 1.4), reach(0.2, 0.6), length(0.05, 0.4);
  std::vector<CurveKey> keys;
  for (double t = step(random); t < until - 0.5; t += step(random)) {
    keys.push_back({t, t, random_place(random), reach(random), reach(random)});
    if (random() % 3 == 0) t = keys.back().to += length(random);
  }
  return keys;
}

Vec3 acceleration(const DisplacementCurve& curve, double seconds, double h = 1e-4) {
  return (curve.at(seconds - h) - 2.0 * curve.at(seconds) + curve.at(seconds + h)) / (h * h);
}

TEST(DisplacementCurve, PassesThroughItsKeysExactly) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 40; ++trial) {
    const std::vector<CurveKey> keys = random_keys(random, 5.0);
    const bool loops = trial % 2 == 1;
    const DisplacementCurve curve = loops ? DisplacementCurve(keys, 5.2) : DisplacementCurve(keys);
    for (const CurveKey& one : keys) {
      EXPECT_LT((curve.at(one.from) - one.value).norm(), 1e-12);
      EXPECT_LT((curve.at(one.to) - one.value).norm(), 1e-12);
      EXPECT_LT((curve.at(0.5 * (one.from + one.to)) - one.value).norm(), 1e-12);
    }
  }
}

TEST(DisplacementCurve, IsExactlyZeroOutOfReach) {
  const DisplacementCurve curve({key(1.0, Vec3(1, 2, 3), 0.3), key(3.0, Vec3(1, 2, 3), 0.4)});
  for (const double t : {-1.0, 0.0, 0.69, 1.31, 2.0, 2.59, 3.41, 9.0})
    EXPECT_EQ(curve.at(t), Vec3::Zero().eval()) << t;
  for (const double t : {0.75, 1.25, 2.65, 3.35}) EXPECT_GT(curve.at(t).norm(), 1e-6) << t;
  EXPECT_EQ(DisplacementCurve().at(0.0), Vec3::Zero().eval());
}

TEST(DisplacementCurve, HasContinuousAcceleration) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 6; ++trial) {
    const std::vector<CurveKey> keys = random_keys(random, 4.0);
    const DisplacementCurve curve =
        trial % 2 == 0 ? DisplacementCurve(keys) : DisplacementCurve(keys, 4.3);
    // A jump would stay; what is continuous changes in proportion to the step.
    double largest = 0.0, finer = 0.0;
    const auto largest_change = [&](double step) {
      double most = 0.0;
      for (double t = -0.5; t < 5.0; t += step)
        most = std::max(most, (acceleration(curve, t + step) - acceleration(curve, t)).norm());
      return most;
    };
    largest = largest_change(2e-3);
    finer = largest_change(5e-4);
    EXPECT_LT(finer, 0.4 * largest) << trial;
  }
}

TEST(DisplacementCurve, RepeatsInALoop) {
  std::mt19937_64 random(3);
  const double period = 1.1;
  const DisplacementCurve curve({key(0.05, Vec3(1, 0, 0), 0.4), key(0.6, Vec3(0, 1, 0), 0.3)},
                                period);
  for (double t = 0.0; t < period; t += 0.01) {
    EXPECT_LT((curve.at(t) - curve.at(t + period)).norm(), 1e-9);
    EXPECT_LT((curve.at(t) - curve.at(t - 2.0 * period)).norm(), 1e-9);
  }
  EXPECT_LT((curve.at(1e-7) - curve.at(period - 1e-7)).norm(), 1e-5);
  EXPECT_GT(curve.at(period - 0.1).norm(), 1e-3);  // before the first key, across the seam
}

TEST(DisplacementCurve, OfOneKeyReachesNoFartherThanHalfOfItsLoop) {
  const DisplacementCurve curve({key(0.2, Vec3(1, 0, 0), 5.0)}, 1.0);
  EXPECT_LT(curve.at(0.7).norm(), 1e-9);
  EXPECT_LT((curve.at(0.2) - Vec3(1, 0, 0)).norm(), 1e-12);
}

TEST(DisplacementCurve, IsTheSameForwardsAndBackwards) {
  std::mt19937_64 random(4);
  const std::vector<CurveKey> keys = random_keys(random, 6.0);
  std::vector<CurveKey> reversed;
  for (const CurveKey& one : keys)
    reversed.push_back({-one.to, -one.from, one.value, one.after, one.before});
  const DisplacementCurve curve(keys), backwards(reversed);
  for (double t = -1.0; t < 7.0; t += 0.013)
    EXPECT_LT((curve.at(t) - backwards.at(-t)).norm(), 1e-9);
}

double squared_jerk(const DisplacementCurve& curve, double bump, double from, double to,
                    double centre, double width) {
  const double h = 1e-3;
  const auto at = [&](double t) {
    const double x = (t - centre) / width;
    const double extra = std::abs(x) < 1.0 ? bump * std::pow(1.0 - x * x, 4) * x : 0.0;
    return Vec3(curve.at(t) + Vec3(extra, 0.0, 0.0));
  };
  double sum = 0.0;
  for (double t = from; t < to; t += h) {
    const Vec3 third =
        (at(t + 1.5 * h) - 3.0 * at(t + 0.5 * h) + 3.0 * at(t - 0.5 * h) - at(t - 1.5 * h)) /
        (h * h * h);
    sum += h * third.squaredNorm();
  }
  return sum;
}

TEST(DisplacementCurve, HasTheLeastJerk) {
  // The bump is zero at the key, and zero with two derivatives at the ends of its reach.
  const DisplacementCurve curve({key(1.0, Vec3(0.4, 0.1, 0), 0.5), key(1.3, Vec3(0.1, 0, 0), 0.5)});
  const double least = squared_jerk(curve, 0.0, 0.4, 1.9, 1.0, 0.3);
  for (const double bump : {-1e-2, -1e-3, 1e-3, 1e-2})
    EXPECT_GT(squared_jerk(curve, bump, 0.4, 1.9, 1.0, 0.3), least) << bump;
}

TEST(DisplacementCurve, OfOneKeyIsTheMinimumJerkMovement) {
  // Flash and Hogan's rise, for the curve of a single key is symmetric: slope 0 at the key, but the
  // curvature is free, so that a quintic of least jerk remains: 2.5 s³ − 1.5 … computed by hand.
  const DisplacementCurve curve({key(0.0, Vec3(1, 0, 0), 1.0)});
  // d(s) = c₃s³ + c₄s⁴ + c₅s⁵ from 0 to 1 with d(1) = 1, d'(1) = 0 and ∂J/∂d''(1) = 0.
  const double c3 = 20.0 / 3.0, c4 = -25.0 / 3.0, c5 = 8.0 / 3.0;
  for (double s = 0.0; s <= 1.0; s += 0.05)
    EXPECT_NEAR(curve.at(s - 1.0).x(), s * s * s * (c3 + s * (c4 + s * c5)), 1e-9) << s;
}

}  // namespace
}  // namespace mien::motion
