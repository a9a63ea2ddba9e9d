#include "motion/math/rotation.h"

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

Quat random_rotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Quat(normal(random), normal(random), normal(random), normal(random)).normalized();
}

double difference(const Quat& a, const Quat& b) {
  return (a.toRotationMatrix() - b.toRotationMatrix()).norm();
}

/// The product of turns about the axes, from left to right.
Quat from_euler(const std::array<Axis, 3>& order, const Vec3& radians) {
  Quat rotation = Quat::Identity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 axis = Vec3::Unit(static_cast<int>(order[i]));
    rotation = rotation * Quat(Eigen::AngleAxisd(radians[static_cast<int>(i)], axis));
  }
  return rotation;
}

TEST(Rotation, ExpUndoesLog) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    const Quat q = random_rotation(random);
    EXPECT_LT(difference(q, exp(log(q))), 1e-12);
  }
}

TEST(Rotation, LogOfTinyRotationsKeepsItsPrecision) {
  for (double angle : {1e-3, 1e-6, 1e-9, 1e-12, 0.0}) {
    EXPECT_NEAR(log(Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()))).z(), angle, 1e-15);
  }
}

TEST(Rotation, LogTakesTheShortWayRound) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 1000; ++i) EXPECT_LE(log(random_rotation(random)).norm(), pi + 1e-12);
}

TEST(Rotation, EulerAnglesGoRoundInEveryOrder) {
  const std::vector<std::array<Axis, 3>> orders = {
      {Axis::x, Axis::y, Axis::z}, {Axis::x, Axis::z, Axis::y}, {Axis::y, Axis::x, Axis::z},
      {Axis::y, Axis::z, Axis::x}, {Axis::z, Axis::x, Axis::y}, {Axis::z, Axis::y, Axis::x}};
  std::mt19937_64 random(3);
  for (const auto& order : orders) {
    for (int i = 0; i < 300; ++i) {
      const Quat q = random_rotation(random);
      EXPECT_LT(difference(q, from_euler(order, to_euler(order, q))), 1e-10);
    }
  }
}

TEST(Rotation, EulerAnglesGoRoundAtGimbalLock) {
  for (double middle : {pi / 2, -pi / 2}) {
    for (const auto& order :
         {std::array{Axis::z, Axis::x, Axis::y}, std::array{Axis::y, Axis::x, Axis::z},
          std::array{Axis::x, Axis::y, Axis::z}}) {
      const Quat q = from_euler(order, {0.4, middle, -0.9});
      EXPECT_LT(difference(q, from_euler(order, to_euler(order, q))), 1e-7);
    }
  }
}

TEST(Rotation, DirectionVectorsGoRoundTo1em12) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 1000; ++i) {
    const Quat q = random_rotation(random);
    EXPECT_LT(difference(q, to_rotation(to_direction_vectors(q), random_rotation(random))), 1e-12);
  }
}

TEST(Rotation, LengthOfDirectionVectorsMeansNothing) {
  std::mt19937_64 random(5);
  const Quat q = random_rotation(random);
  DirectionVectors directions = to_direction_vectors(q);
  directions.d1 *= 3.7;
  directions.d2 *= 0.2;
  EXPECT_LT(difference(q, to_rotation(directions, q)), 1e-12);
}

TEST(Rotation, DegenerateDirectionVectorsFallBackOnThePreviousRotation) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 200; ++i) {
    const Quat previous = random_rotation(random);
    EXPECT_LT(difference(previous, to_rotation({Vec3::Zero(), Vec3::Zero()}, previous)), 1e-12);
    const Vec3 x = previous * Vec3::UnitX();
    EXPECT_LT(difference(previous, to_rotation({x, x}, previous)), 1e-12);
  }
}

TEST(Rotation, SlerpMovesAtConstantAngularSpeed) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200; ++i) {
    const Quat a = random_rotation(random);
    const Quat b = random_rotation(random);
    const double whole = angle_between(a, b);
    for (double t : {0.25, 0.5, 0.9}) {
      EXPECT_NEAR(angle_between(a, slerp(a, b, t)), t * whole, 1e-9);
    }
  }
}

TEST(Rotation, TwistIsThePartAboutTheAxis) {
  const Quat twist(Eigen::AngleAxisd(0.8, Vec3::UnitY()));
  const Quat swing(Eigen::AngleAxisd(0.5, Vec3(1, 0, 1).normalized()));
  EXPECT_LT(difference(twist, twist_about(swing * twist, Vec3::UnitY())), 1e-12);
}

TEST(Rotation, HeadingTurnsForwardToTheDirection) {
  const Vec3 direction(0.3, 5.0, -0.4);
  const Vec3 turned = heading(direction) * Vec3::UnitZ();
  EXPECT_LT((turned - Vec3(0.6, 0, -0.8)).norm(), 1e-12);
}

}  // namespace
}  // namespace mien::motion
