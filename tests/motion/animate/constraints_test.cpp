#include "motion/animate/constraints.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "motion/animate/smooth_limit.h"
#include "motion/biomechanics/joint_angles.h"
#include "motion/math/rotation.h"
#include "motion/random_motion.h"
#include "motion/refusal.h"
#include "motion/skeleton/mirror.h"

#include "animated_motions.h"

namespace mien::motion {
namespace {

using namespace mien::test;

MotionConstraint between(double from, double to, BodyEnd part) {
  MotionConstraint constraint;
  constraint.from = Moment{from};
  constraint.to = Moment{to};
  constraint.part = part;
  return constraint;
}

Vec3 placed_at(const Clip& clip, int frame, BodyEnd end) {
  return place_of(clip.body,
                  world_transforms(clip.body, clip.poses[static_cast<std::size_t>(frame)]), end);
}

BodyFrame body_at(const Clip& clip, int frame) {
  return body_frame(clip.poses[static_cast<std::size_t>(frame)]);
}

TEST(Constraints, HoldAPartAtAPlace) {
  const Clip walk = walk_of();
  MotionConstraint one = between(1.0, 2.0, BodyEnd::right_hand);
  one.place = Vec3(-0.25, 1.3, 0.4);
  const AnimatedClip made = with_constraints(walk, {one});
  EXPECT_TRUE(made.misses.empty()) << made.remarks.back();
  for (int f = 100; f <= 200; ++f) {
    EXPECT_LT(
        (body_at(walk, f).from_room(placed_at(made.clip, f, BodyEnd::right_hand)) - *one.place)
            .norm(),
        held_metres)
        << f;
  }
}

TEST(Constraints, LetAPartStayWhereItIs) {
  const Clip walk = walk_of();
  MotionConstraint one = between(1.0, 1.12, BodyEnd::left_hand);
  one.stays = Stays::position;
  const AnimatedClip made = with_constraints(walk, {one});
  EXPECT_TRUE(made.misses.empty()) << made.remarks.back();
  const Vec3 there = placed_at(walk, 100, BodyEnd::left_hand);
  for (int f = 100; f <= 112; ++f)
    EXPECT_LT((placed_at(made.clip, f, BodyEnd::left_hand) - there).norm(), held_metres) << f;
  one.frame = PlaceFrame::body;
  const Clip carried = with_constraints(walk, {one}).clip;
  for (int f = 100; f <= 112; ++f) {
    EXPECT_LT((body_at(walk, f).from_room(placed_at(carried, f, BodyEnd::left_hand)) -
               body_at(walk, 100).from_room(there))
                  .norm(),
              held_metres)
        << f;
  }
}

TEST(Constraints, LetAPartFollowAPath) {
  const Clip walk = walk_of();
  MotionConstraint one;
  one.part = BodyEnd::right_hand;
  one.follows = {{{1.0}, Vec3(-0.3, 1.2, 0.3)},
                 {{1.4}, Vec3(-0.4, 1.4, 0.3)},
                 {{150, true}, Vec3(-0.2, 1.3, 0.4)}};
  const AnimatedClip made = with_constraints(walk, {one});
  EXPECT_TRUE(made.misses.empty()) << made.remarks.back();
  for (const auto& [frame, place] :
       {std::pair(100, Vec3(-0.3, 1.2, 0.3)), std::pair(140, Vec3(-0.4, 1.4, 0.3)),
        std::pair(150, Vec3(-0.2, 1.3, 0.4))}) {
    EXPECT_LT(
        (body_at(walk, frame).from_room(placed_at(made.clip, frame, BodyEnd::right_hand)) - place)
            .norm(),
        held_metres)
        << frame;
  }
}

TEST(Constraints, KeepAPartInARegion) {
  const Clip walk = walk_of();
  MotionConstraint one = between(0.5, 2.5, BodyEnd::right_hand);
  one.within[2] = {{0.0, 0.2}};
  const AnimatedClip made = with_constraints(walk, {one});
  EXPECT_TRUE(made.misses.empty()) << made.remarks.back();
  double least_before = 0.0;
  for (int f = 50; f <= 250; ++f) {
    const double before = body_at(walk, f).from_room(placed_at(walk, f, BodyEnd::right_hand)).z();
    const double z = body_at(walk, f).from_room(placed_at(made.clip, f, BodyEnd::right_hand)).z();
    least_before = std::min(least_before, before);
    EXPECT_GE(z, -1e-9);
    EXPECT_LE(z, 0.2 + 1e-9);
    if (before > 0.05 && before < 0.15) {
      EXPECT_NEAR(z, before, 1e-9);  // is left alone inside
    }
  }
  EXPECT_LT(least_before, -0.1);
}

TEST(Constraints, KeepPartsAtADistance) {
  const Clip walk = walk_of();
  MotionConstraint one = between(1.0, 2.0, BodyEnd::left_hand);
  one.distance_to = BodyEnd::right_hand;
  one.at_most = 0.3;
  const auto distance = [](const Clip& clip, int f) {
    return (placed_at(clip, f, BodyEnd::left_hand) - placed_at(clip, f, BodyEnd::right_hand))
        .norm();
  };
  const AnimatedClip made = with_constraints(walk, {one});
  EXPECT_TRUE(made.misses.empty()) << made.remarks.back();
  for (int f = 100; f <= 200; ++f) {
    EXPECT_GT(distance(walk, f), 0.4);
    EXPECT_LT(distance(made.clip, f), 0.3 + 1e-6);
    const Vec3 left =
        placed_at(made.clip, f, BodyEnd::left_hand) - placed_at(walk, f, BodyEnd::left_hand);
    const Vec3 right =
        placed_at(made.clip, f, BodyEnd::right_hand) - placed_at(walk, f, BodyEnd::right_hand);
    EXPECT_LT((left + right).norm(), 1e-6);  // each half of the way
  }
  one.at_least = 0.3;
  const Clip exact = with_constraints(walk, {one}).clip;
  for (int f = 100; f <= 200; ++f) EXPECT_NEAR(distance(exact, f), 0.3, 1e-6);
  one.distance_to = BodyEnd::pelvis;
  one.at_least.reset();
  one.at_most = 0.3;
  const Clip near = with_constraints(walk, {one}).clip;
  for (int f = 100; f <= 200; ++f) {
    EXPECT_LT((placed_at(near, f, BodyEnd::left_hand) - placed_at(near, f, BodyEnd::pelvis)).norm(),
              0.3 + 1e-6);
    EXPECT_EQ(placed_at(near, f, BodyEnd::pelvis), placed_at(walk, f, BodyEnd::pelvis));
  }
}

TEST(Constraints, KeepAnOrientation) {
  const Clip walk = walk_of();
  for (const BodyEnd part :
       {BodyEnd::left_hand, BodyEnd::right_foot, BodyEnd::head, BodyEnd::right_hand}) {
    MotionConstraint one = between(1.0, 1.5, part);
    one.stays = Stays::orientation;
    const AnimatedClip made = with_constraints(walk, {one});
    EXPECT_TRUE(made.misses.empty()) << name_of(part) << made.remarks.back();
    const auto turn = [&](const Clip& clip, int f) {
      return world_transforms(clip.body, clip.poses[static_cast<std::size_t>(f)])
          .rotations[joint_of(part)];
    };
    for (int f = 100; f <= 150; ++f) {
      EXPECT_LT(angle_between(turn(made.clip, f), turn(walk, 100)), 1e-6) << name_of(part) << f;
      const bool is_foot = part == BodyEnd::right_foot;
      EXPECT_LT((placed_at(made.clip, f, part) - placed_at(walk, f, part)).norm(),
                is_foot ? 1e-4 : 0.1)
          << name_of(part);
    }
  }
}

TEST(Constraints, KeepAnglesInARange) {
  std::mt19937_64 random(6);
  const Clip clip = repeated(random_loop(random, 60, 30.0, 0.6).clip, 2);
  for (const RangeAngle angle :
       {RangeAngle::head_flexion, RangeAngle::head_turn, RangeAngle::spine_lateral,
        RangeAngle::left_elbow_flexion, RangeAngle::right_elbow_flexion}) {
    MotionConstraint one;
    one.from = Moment{1.0};
    one.to = Moment{3.0};
    one.angle = angle;
    one.at_least = 5.0;
    one.at_most = 20.0;
    const Clip made = with_constraints(clip, {one}).clip;
    for (std::size_t f = 30; f <= 90; ++f) {
      const double degrees = angle_of(made.poses[f], angle) / radians_per_degree;
      EXPECT_GE(degrees, 5.0 - 1e-6);
      EXPECT_LE(degrees, 20.0 + 1e-6);
    }
  }
}

TEST(Constraints, AnglesAreSetAsTheyAreMeasured) {
  std::mt19937_64 random(7);
  const Clip clip = random_loop(random, 20, 30.0, 0.6).clip;
  for (int i = 0; i < 8; ++i) {
    const auto angle = static_cast<RangeAngle>(i);
    for (const Pose& pose : clip.poses) {
      const double wanted = angle_of(pose, angle) + 0.2;
      EXPECT_NEAR(angle_of(with_angle(pose, angle, wanted), angle), wanted, 1e-9) << i;
    }
  }
  // A flexed elbow is one that the other measure calls flexed.
  Pose pose;
  pose.rotations.assign(body_joint_count, Quat::Identity());
  for (const auto& [angle, joint] :
       {std::pair(RangeAngle::left_elbow_flexion, LeftElbow),
        std::pair(RangeAngle::right_elbow_flexion, RightElbow),
        std::pair(RangeAngle::head_flexion, Head), std::pair(RangeAngle::spine_flexion, Chest)}) {
    const std::vector<double> measured = measured_angles(with_angle(pose, angle, 0.5));
    for (std::size_t a = 0; a < measured.size(); ++a) {
      if (joint_angles()[a].joint == joint && joint_angles()[a].name == "flexion") {
        EXPECT_NEAR(measured[a], 0.5 / radians_per_degree, 1e-6);
      }
    }
  }
}

TEST(Constraints, KeepTheFaceOnAPlace) {
  const Clip walk = walk_of();
  MotionConstraint one = between(1.0, 1.5, BodyEnd::head);
  one.frame = PlaceFrame::room;
  one.look_at = Vec3(2.0, 1.4, 3.0);
  const AnimatedClip made = with_constraints(walk, {one});
  EXPECT_TRUE(made.misses.empty()) << made.remarks.back();
  for (std::size_t f = 100; f <= 150; ++f) {
    const JointTransforms world = world_transforms(made.clip.body, made.clip.poses[f]);
    const Vec3 way = *one.look_at - place_of(made.clip.body, world, BodyEnd::head);
    EXPECT_LT((way.normalized() - world.rotations[Head] * Vec3::UnitZ()).norm(), 1e-4);
  }
}

TEST(Constraints, OfThePelvisLeaveTheFeet) {
  const Clip walk = natural_walk();
  MotionConstraint one = between(1.0, 2.0, BodyEnd::pelvis);
  one.within[1] = {{0.7, 0.9}};
  const AnimatedClip made = with_constraints(walk, {one});
  EXPECT_TRUE(made.misses.empty()) << made.remarks.back();
  for (int f = 0; f < walk.frame_count(); ++f) {
    for (const BodyEnd foot : {BodyEnd::left_foot, BodyEnd::right_foot})
      EXPECT_LT((placed_at(made.clip, f, foot) - placed_at(walk, f, foot)).norm(), 1e-3) << f;
  }
  EXPECT_LT(placed_at(made.clip, 150, BodyEnd::pelvis).y(), 0.9);
}

TEST(Constraints, LeaveOtherFramesBitForBitAndActSmoothly) {
  const Clip walk = walk_of(3.0, 500.0);
  MotionConstraint one = between(1.0, 1.5, BodyEnd::right_hand);
  one.place = Vec3(-0.25, 1.3, 0.4);
  one.reach = 0.3;
  const Clip made = with_constraints(walk, {one}).clip;
  std::vector<Vec3> shift;
  for (int f = 0; f < walk.frame_count(); ++f) {
    const auto at = static_cast<std::size_t>(f);
    if (f <= 350 || f >= 900) {
      EXPECT_TRUE(same_pose(made.poses[at], walk.poses[at])) << f;
    }
    shift.push_back(placed_at(made, f, BodyEnd::right_hand) -
                    placed_at(walk, f, BodyEnd::right_hand));
  }
  const auto acceleration = [&](std::size_t f) {
    return Vec3((shift[f - 3] - 2.0 * shift[f] + shift[f + 3]) / 3.6e-5);
  };
  double near = 0.0, far = 0.0;
  for (std::size_t f = 300; f < 950; ++f) {
    near = std::max(near, (acceleration(f + 3) - acceleration(f)).norm());
    far = std::max(far, (acceleration(f + 60) - acceleration(f)).norm());
  }
  EXPECT_GT(far, 1.0);
  EXPECT_LT(near, 0.25 * far);
}

TEST(Constraints, ActAcrossTheSeamOfALoop) {
  std::mt19937_64 random(3);
  const Clip loop = random_loop(random, 60, 30.0, 0.3).clip;
  MotionConstraint one = between(0.1, 0.4, BodyEnd::left_hand);
  one.stays = Stays::position;
  const Clip made = with_constraints(loop, {one}).clip;
  EXPECT_FALSE(same_pose(made.poses.back(), loop.poses.back()));
  const Clip twice = repeated(made, 2);
  MotionConstraint later = between(2.1, 2.4, BodyEnd::left_hand);
  later.stays = Stays::position;
  MotionConstraint first = one;
  const Clip other = with_constraints(repeated(loop, 2), {first, later}).clip;
  for (std::size_t f = 30; f < 90; ++f) {
    EXPECT_LT((placed_at(twice, static_cast<int>(f), BodyEnd::left_hand) -
               placed_at(other, static_cast<int>(f), BodyEnd::left_hand))
                  .norm(),
              1e-6)
        << f;
  }
}

TEST(Constraints, AreMirroredWithTheMotion) {
  const Clip walk = walk_of(2.0);
  MotionConstraint right = between(0.8, 1.2, BodyEnd::right_hand);
  right.place = Vec3(-0.2, 1.4, 0.8);  // out of reach without the trunk
  MotionConstraint left = between(0.8, 1.2, BodyEnd::left_hand);
  left.place = Vec3(0.2, 1.4, 0.8);
  const Clip one = mirrored(with_constraints(walk, {right}).clip);
  const Clip two = with_constraints(mirrored(walk), {left}).clip;
  for (std::size_t f = 0; f < one.poses.size(); ++f) {
    const auto a = world_positions(one.body, one.poses[f]);
    const auto b = world_positions(two.body, two.poses[f]);
    for (std::size_t j = 0; j < a.size(); ++j) EXPECT_LT((a[j] - b[j]).norm(), 1e-6) << f;
  }
}

TEST(Constraints, OutOfReachAreTold) {
  const Clip walk = walk_of();
  MotionConstraint far = between(1.0, 1.4, BodyEnd::right_hand);
  far.place = Vec3(-0.2, 1.4, 2.0);
  const AnimatedClip made = with_constraints(walk, {far});
  ASSERT_EQ(made.misses.size(), 1u);
  EXPECT_GE(made.misses[0].frame, 100);
  EXPECT_LE(made.misses[0].frame, 140);
  EXPECT_EQ(made.misses[0].reason, "out of reach");
  const int f = made.misses[0].frame;
  EXPECT_NEAR(
      made.misses[0].amount,
      (body_at(walk, f).to_room(*far.place) - placed_at(made.clip, f, BodyEnd::right_hand)).norm(),
      1e-9);
  MotionConstraint behind = between(1.0, 1.4, BodyEnd::right_hand);
  behind.place = Vec3(-0.2, 1.3, -0.55);
  const AnimatedClip stopped = with_constraints(walk, {behind});
  ASSERT_EQ(stopped.misses.size(), 1u);
  EXPECT_NE(stopped.misses[0].reason.find("stopped by the range of the right shoulder's"),
            std::string::npos)
      << stopped.misses[0].reason;
}

TEST(Constraints, RefuseWhatCannotBeMeant) {
  const Clip walk = walk_of();
  const auto refusal = [](const Clip& clip, const MotionConstraint& one) {
    return refusal_of([&] { with_constraints(clip, {one}); });
  };
  MotionConstraint late = between(1.0, 4.0, BodyEnd::left_hand);
  late.stays = Stays::position;
  EXPECT_EQ(refusal(walk, late),
            "a constraint names 4 s, but the motion lasts 3 s; give moments of the motion");
  late = between(2.0, 1.0, BodyEnd::left_hand);
  late.stays = Stays::position;
  EXPECT_EQ(refusal(walk, late),
            "a constraint ends at 1 s, before it begins at 2 s; give from: before to:");
  MotionConstraint path;
  path.part = BodyEnd::left_hand;
  path.follows = {{{2.0}, Vec3(0, 1, 0)}, {{1.0}, Vec3(0, 1, 0)}};
  EXPECT_NE(refusal(walk, path).find("not in order of time: 1 s comes after 2 s"),
            std::string::npos);
  std::mt19937_64 random(1);
  MotionConstraint whole;
  whole.part = BodyEnd::left_hand;
  whole.stays = Stays::position;
  EXPECT_NE(refusal(random_loop(random, 30).clip, whole).find("throughout a loop that travels"),
            std::string::npos);
}

TEST(Constraints, LimitsHaveContinuousSecondDerivatives) {
  const auto second = [](double x, double h) {
    const auto f = [](double v) { return smoothly_limited(v, 1.0, 0.2); };
    return (f(x + h) - 2.0 * f(x) + f(x - h)) / (h * h);
  };
  EXPECT_EQ(smoothly_limited(0.7, 1.0, 0.2), 0.7);
  EXPECT_LT(smoothly_limited(5.0, 1.0, 0.2), 1.0 + 1e-12);
  for (const double h : {1e-2, 1e-3, 1e-4}) EXPECT_LT(std::abs(second(0.8, h)), 30.0 * h) << h;
  EXPECT_EQ(smoothly_within(0.5, 0.3, 0.3, 0.1), 0.3);
}

}  // namespace
}  // namespace mien::motion
