#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "motion/fitting/functional_joint.h"
#include "motion/fitting/hinge_axis.h"
#include "motion/fitting/hip_centres.h"
#include "motion/fitting/rigid_placement.h"
#include "motion/math/rotation.h"

namespace mien::motion {
namespace {

TEST(HipCentre, IsThatOfHarringtonsEquations) {
  // Depth 160 mm, width 240 mm, leg 880 mm.
  const Vec3 left = hip_centre({0.240, 0.160, 0.880}, true);
  EXPECT_NEAR(left.z(), -0.0483, 1e-9);
  EXPECT_NEAR(left.y(), -0.0807, 1e-9);
  EXPECT_NEAR(left.x(), 0.0911, 1e-9);
  const Vec3 right = hip_centre({0.240, 0.160, 0.880}, false);
  EXPECT_DOUBLE_EQ(right.x(), -left.x());
  EXPECT_NEAR(hip_centre({0.240, 0.160, std::nullopt}, true).y(), -0.0829, 1e-9);
}

TEST(RigidPlacement, RecoversARotationAndATranslation) {
  const std::vector<Vec3> shape = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.2, 0}, {0.05, 0.1, 0.02}};
  const Quat turn = exp(Vec3(0.4, -2.0, 0.3));
  std::vector<Vec3> measured;
  for (const Vec3& point : shape) measured.push_back(turn * point + Vec3(3, 1, -2));
  const auto placement = rigid_placement(shape, measured);
  ASSERT_TRUE(placement.has_value());
  EXPECT_LT(angle_between(placement->rotation, turn), 1e-9);
  EXPECT_LT((placement->position - Vec3(3, 1, -2)).norm(), 1e-9);
}

TEST(RigidPlacement, NeedsThreePointsThatAreNotOnALine) {
  const std::vector<Vec3> line = {{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}};
  EXPECT_FALSE(rigid_placement(line, line).has_value());
  const std::vector<Vec3> pair = {{0, 0, 0}, {0.1, 0, 0}};
  EXPECT_FALSE(rigid_placement(pair, pair).has_value());
}

/// A leg that bends about its x axis, turned by `twist` about the vertical.
struct BendingLeg {
  Track hip, knee, ankle, left;
  explicit BendingLeg(double twist, double noise = 0.0) {
    for (int frame = 0; frame < 60; ++frame) {
      const double bend = 0.6 * (1.0 - std::cos(0.2 * frame));  // 0 to 69°
      const Quat turn = exp(Vec3(0, twist, 0));
      const double error = frame % 2 ? noise : -noise;
      hip.emplace_back(Vec3(0, 0.9, 0));
      knee.emplace_back(Vec3(0, 0.47, 0) + turn * Vec3(error, 0, error));
      ankle.emplace_back(Vec3(0, 0.47, 0) +
                         turn * (0.42 * Vec3(0, -std::cos(bend), -std::sin(bend))));
      left.emplace_back(Vec3::UnitX());
    }
  }
};

TEST(HingeAxis, IsPerpendicularToThePlaneOfBend) {
  const BendingLeg leg(0.3);
  const Track axis = hinge_axis(leg.hip, leg.knee, leg.ankle, leg.left, Hinge{});
  const Vec3 expected = exp(Vec3(0, 0.3, 0)) * Vec3::UnitX();
  for (const auto& direction : axis) EXPECT_GT(direction->dot(expected), 0.9999);
}

TEST(HingeAxis, DoesNotFlipWhenTheLimbIsStraight) {
  const BendingLeg leg(0.3, 0.008);
  const Track axis = hinge_axis(leg.hip, leg.knee, leg.ankle, leg.left, Hinge{});
  const Vec3 expected = exp(Vec3(0, 0.3, 0)) * Vec3::UnitX();
  for (const auto& direction : axis) EXPECT_GT(direction->dot(expected), 0.9);
}

TEST(FunctionalJoint, IsWhereTheSegmentsTurn) {
  // The shank turns about the knee's x axis; the guess is 4 cm off in front of the joint.
  std::vector<Track> thigh(3);
  std::vector<Track> shank(3);
  Track guess;
  const std::vector<Vec3> on_thigh = {{0.08, 0.2, 0}, {0.02, 0.1, 0.08}, {0.07, 0.1, -0.03}};
  const std::vector<Vec3> on_shank = {{0.06, -0.1, 0.02}, {0, -0.2, 0.06}, {0.05, -0.2, -0.03}};
  for (int frame = 0; frame < 80; ++frame) {
    const Quat swing = exp(Vec3(0.3 * std::sin(0.2 * frame), 0.1, 0));
    const Quat bend = swing * exp(Vec3(0.5 - 0.5 * std::cos(0.3 * frame), 0, 0));
    const Vec3 knee(0.01 * frame, 0.5, 0.02 * frame);
    for (std::size_t i = 0; i < 3; ++i) {
      thigh[i].emplace_back(knee + swing * on_thigh[i]);
      shank[i].emplace_back(knee + bend * on_shank[i]);
    }
    guess.emplace_back(knee + swing * Vec3(0, 0, 0.04));
  }
  const Track centre = functional_joint(thigh, shank, guess, 0.003);
  for (int frame = 0; frame < 80; ++frame) {
    const Vec3 knee(0.01 * frame, 0.5, 0.02 * frame);
    EXPECT_LT((*centre[static_cast<std::size_t>(frame)] - knee).norm(), 0.008);
  }
}

}  // namespace
}  // namespace mien::motion
