#include "motion/modify/foot_repair.h"

#include <gtest/gtest.h>

#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"
#include "motion/gait/foot_path.h"
#include "motion/math/rotation.h"
#include "motion/modify/hip_shift.h"
#include "motion/modify/path_length.h"
#include "motion/modify/relative_change.h"
#include "motion/procedural/walker.h"
#include "motion/skeleton/sole.h"
#include "motion/synthetic_walk.h"

#include "path_measures.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Clip ordinary() { return walk({}, 100.0, standard_body()).clip; }

Clip with_paths(const Clip& clip, const PathGains& gains) {
  return with_path_gains(clip, gains, RotationSignal::direction_vectors);
}

double lowest_sole(const Clip& clip, bool left, size_t frame) {
  const SolePoints sole = sole_paths(clip, left)[frame];
  return std::min({sole.heel.y(), sole.ball.y(), sole.tip.y()});
}

TEST(HipShift, LeavesFeetThatStand) {
  const Clip clip = ordinary();
  const Clip shifted = with_hip_shift(clip, clip, foot_plants(clip), HipPath::exact);
  EXPECT_LT(largest_distance(shifted, clip), 0.01);
  EXPECT_NEAR(shifted.cycle_displacement.z(), clip.cycle_displacement.z(), 0.01);
}

TEST(HipShift, BringsARootThatWasHeldBackOnItsWay) {
  // The same legs under a root that no longer moves.
  Clip held = synthetic_clip(steady_walk(1.2, 4.0));
  const Clip original = held;
  for (Pose& pose : held.poses) {
    pose.root_position.x() = 0.0;
    pose.root_position.z() = 0.0;
  }
  const auto plants = foot_plants(original);
  for (const HipPath path : {HipPath::exact, HipPath::smooth}) {
    const Clip shifted = with_hip_shift(held, original, plants, path);
    const Vec3 way = shifted.poses.back().root_position - shifted.poses.front().root_position;
    EXPECT_NEAR(way.z(), 1.2 * 4.0, 0.1);
    EXPECT_NEAR(way.x(), 0.0, 0.05);
  }
  const Clip exact = with_hip_shift(held, original, plants, HipPath::exact);
  EXPECT_LT(planted_drift(exact, plants), 0.01);
  EXPECT_GT(planted_drift(held, plants), 0.1);
}

TEST(HipShift, KeepsALoopOnItsLine) {
  Clip limping = ordinary();
  for (Pose& pose : limping.poses) {
    pose.rotations[LeftHip] = exp(Vec3(0, 0, 0.05)) * pose.rotations[LeftHip];
  }
  const Clip clip = ordinary();
  const Clip shifted = with_hip_shift(limping, clip, foot_plants(clip), HipPath::smooth);
  EXPECT_NEAR(shifted.cycle_displacement.x(), 0.0, 1e-9);
  EXPECT_GT(shifted.cycle_displacement.z(), 1.0);
}

TEST(HipShift, LowersTheBodyWithItsFeet) {
  Clip raised = ordinary();
  const Clip clip = raised;
  for (Pose& pose : raised.poses) pose.root_position.y() += 0.2;
  const auto plants = foot_plants(clip);
  for (const HipPath path : {HipPath::exact, HipPath::smooth}) {
    const Clip shifted = with_hip_shift(raised, clip, plants, path);
    for (size_t f = 0; f < clip.poses.size(); f += 10) {
      EXPECT_NEAR(shifted.poses[f].root_position.y(), clip.poses[f].root_position.y(), 1e-6);
    }
  }
}

TEST(FootRepair, LetsPlantedFeetStandInTheirOwnRoll) {
  const Clip clip = ordinary();
  const auto plants = foot_plants(clip);
  const Clip still = with_still_feet(clip, plants);
  EXPECT_LT(planted_drift(still, plants), 5e-4);
  for (const PathGains& gains : {longest_path_gains(), shortest_path_gains()}) {
    const Clip changed = with_paths(clip, gains);
    const Clip repaired = with_plants_carried_over(changed, still, plants);
    EXPECT_GT(planted_drift(changed, plants), 0.01);
    EXPECT_LT(planted_drift(repaired, plants), 0.001);
    for (const FootPlant& plant : plants) {
      const FootPath path = foot_path(repaired, plant.left);
      const FootPath known = foot_path(still, plant.left);
      for (int f = plant.first; f <= plant.last; ++f) {
        EXPECT_NEAR(path.ball_at(f).y(), known.ball_at(f).y(), 1e-3);
        const Quat turn = path.rotation_at(f) * known.rotation_at(f).conjugate();
        EXPECT_LT((turn * Vec3::UnitY() - Vec3::UnitY()).norm(), 1e-3);  // about the vertical
      }
    }
  }
}

// Rolling off over toes that stay straight, or bend twice as far, a foot would go through the
// floor.
TEST(FootRepair, LeavesTheWayOfACaptureWhoseFeetSlide) {
  // A modification that changes nothing must not change how far and how fast somebody walks.
  Clip sliding = repeated(ordinary(), 3);
  const double step = 0.0006;  // metres a frame: 6 cm/s
  for (size_t f = 0; f < sliding.poses.size(); ++f)
    sliding.poses[f].root_position.z() += step * static_cast<double>(f);
  const auto plants = foot_plants(sliding);
  ASSERT_GT(planted_drift(sliding, plants), 0.02);
  const Clip same = with_repaired_feet(sliding, sliding, plants, FootRepair::plants);
  EXPECT_LT(planted_drift(same, plants), 0.003);
  for (size_t f = 0; f < same.poses.size(); ++f) {
    ASSERT_LT(horizontal(same.poses[f].root_position - sliding.poses[f].root_position).norm(),
              1e-9);
  }
  // What a modification adds still moves the root: legs that swing half as far.
  const Clip half = with_swing(sliding, {.step_length = 0.5});
  const Clip repaired = with_repaired_feet(half, sliding, plants, FootRepair::plants);
  const double way = sliding.poses.back().root_position.z();
  EXPECT_LT(repaired.poses.back().root_position.z(), 0.8 * way);
  EXPECT_GT(repaired.poses.back().root_position.z(), 0.3 * way);
}

TEST(FootRepair, BendsToesOfPlantedFeetAsTheyStood) {
  const Clip clip = ordinary();
  const auto plants = foot_plants(clip);
  const Clip still = with_still_feet(clip, plants);
  for (const double bend : {0.0, 0.5, 2.0}) {
    Clip changed = clip;
    for (Pose& pose : changed.poses) {
      for (const BodyJoint toe : {LeftToe, RightToe}) {
        pose.rotations[toe] = exp(bend * log(pose.rotations[toe]));
      }
    }
    const Clip repaired = with_plants_carried_over(changed, still, plants);
    double deepest = 0.0;
    for (const FootPlant& plant : plants) {
      const auto was = sole_paths(still, plant.left);
      const auto is = sole_paths(repaired, plant.left);
      for (int f = plant.first; f <= plant.last; ++f) {
        const auto t = static_cast<size_t>(f % clip.frame_count());
        deepest = std::max(deepest, was[t].tip.y() - is[t].tip.y());
      }
    }
    EXPECT_LT(deepest, 0.002) << bend;
    EXPECT_LT(largest_second_difference(repaired), 3.0 * largest_second_difference(clip) + 0.005);
  }
}

TEST(FootRepair, TurnsFeetInwardsWithTheLegs) {
  Clip clip = ordinary();
  const auto plants = foot_plants(clip);
  Clip turned = clip;
  for (Pose& pose : turned.poses) {
    pose.rotations[LeftHip] = pose.rotations[LeftHip] * exp(Vec3(0, -0.2, 0));
  }
  const Clip repaired = with_repaired_feet(turned, clip, plants, FootRepair::plants);
  const FootPath path = foot_path(repaired, true);
  const FootPath before = foot_path(clip, true);
  const int middle = 20;  // the left foot is flat
  const Vec3 toes = path.rotation_at(middle) * Vec3::UnitZ();
  const Vec3 toes_before = before.rotation_at(middle) * Vec3::UnitZ();
  EXPECT_NEAR(std::atan2(toes.x(), toes.z()) - std::atan2(toes_before.x(), toes_before.z()), -0.2,
              0.05);
}

TEST(FootRepair, BendsKneesForwardThatWereBentBackwards) {
  const Clip clip = ordinary();
  const auto plants = foot_plants(clip);
  for (const double degrees : {-8.0, -5.0, -2.0}) {
    Clip stiff = clip;
    for (size_t f = 0; f < 30; ++f) {
      stiff.poses[f].rotations[LeftKnee] = exp(Vec3(degrees * radians_per_degree, 0.0, 0.0));
    }
    const Clip repaired = with_repaired_feet(stiff, clip, plants, FootRepair::plants);
    for (const Pose& pose : repaired.poses) {
      EXPECT_GT(log(pose.rotations[LeftKnee]).x(), -0.01) << degrees;
    }
  }
}

TEST(FootRepair, ThrowsNoKneeSidewaysThatBowsAndGetsStraight) {
  Clip bowed = ordinary();
  const auto plants = foot_plants(bowed);
  for (size_t f = 0; f < bowed.poses.size(); ++f) {
    const double bend = 0.06 * std::sin(2.0 * pi * 4.0 * static_cast<double>(f) /
                                        static_cast<double>(bowed.poses.size()));
    bowed.poses[f].rotations[LeftKnee] = exp(Vec3(bend, 0.0, 0.25));
    bowed.poses[f].rotations[RightKnee] = exp(Vec3(-bend, 0.0, -0.25));
  }
  const Clip repaired = with_repaired_feet(bowed, ordinary(), plants, FootRepair::plants);
  EXPECT_LT(largest_second_difference(repaired), 3.0 * largest_second_difference(bowed) + 0.015);
  // They bow to the side to which they did.
  for (size_t f = 0; f < bowed.poses.size(); ++f) {
    EXPECT_GT(log(repaired.poses[f].rotations[LeftKnee]).z(), 0.0) << f;
    EXPECT_LT(log(repaired.poses[f].rotations[RightKnee]).z(), 0.0) << f;
  }
}

TEST(FootRepair, OfNoneLeavesTheClip) {
  const Clip clip = ordinary();
  const Clip changed = with_paths(clip, longest_path_gains());
  EXPECT_EQ(largest_distance(with_repaired_feet(changed, clip, foot_plants(clip), FootRepair::none),
                             changed),
            0.0);
  EXPECT_EQ(largest_distance(with_repaired_feet(changed, clip, {}, FootRepair::plants), changed),
            0.0);
}

TEST(FootRepair, RaisesFeetThatSinkDeeperThanTheyDid) {
  const Clip clip = ordinary();
  EXPECT_EQ(largest_distance(with_feet_above_floor(clip, clip), clip), 0.0);
  Clip pointed = clip;  // the toes of the left foot point down all along
  for (Pose& pose : pointed.poses) {
    pose.rotations[LeftAnkle] = pose.rotations[LeftAnkle] * exp(Vec3(0.25, 0, 0));
  }
  const Clip raised = with_feet_above_floor(pointed, clip);
  double deepest = 0.0;
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    deepest = std::max(deepest, -lowest_sole(pointed, true, f));
    EXPECT_GE(lowest_sole(raised, true, f), std::min(lowest_sole(clip, true, f), 0.0) - 0.0051);
    EXPECT_EQ(raised.poses[f].rotations[RightAnkle].coeffs(),
              pointed.poses[f].rotations[RightAnkle].coeffs());
  }
  EXPECT_GT(deepest, 0.02);
}

TEST(FootRepair, LiftsToesThatWouldScrapeTheFloor) {
  const Clip clip = ordinary();
  const auto plants = foot_plants(clip);
  Clip sunk = clip;
  for (Pose& pose : sunk.poses) pose.root_position.y() -= 0.03;
  const Clip cleared = with_toe_clearance(sunk, clip, plants);
  double lifted = 0.0;
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    for (const bool left : {true, false}) {
      const double before = lowest_sole(sunk, left, f);
      const double after = lowest_sole(cleared, left, f);
      EXPECT_GE(after, before - 1e-9);
      lifted = std::max(lifted, after - before);
    }
  }
  EXPECT_GT(lifted, 0.02);
  EXPECT_LT(largest_distance(with_toe_clearance(clip, clip, plants), clip), 1e-9);
}

}  // namespace
}  // namespace mien::motion
