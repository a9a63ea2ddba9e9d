#include "motion/animate/keys.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "motion/biomechanics/joint_angles.h"
#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"
#include "motion/math/rotation.h"
#include "motion/random_motion.h"
#include "motion/refusal.h"
#include "motion/skeleton/mirror.h"
#include "motion/skeleton/straighten.h"

#include "animated_motions.h"

namespace mien::motion {
namespace {

using namespace mien::test;

AnimatorKey key(Moment at, BodyEnd end, const Vec3& place, PlaceFrame frame = PlaceFrame::room) {
  AnimatorKey key;
  key.at = at;
  key.places[static_cast<std::size_t>(end)] = place;
  key.frame = frame;
  return key;
}

AnimatorKey look(Moment at, const Vec3& place, PlaceFrame frame = PlaceFrame::room) {
  AnimatorKey key;
  key.at = at;
  key.look_at = place;
  key.frame = frame;
  return key;
}

Vec3 place_at(const Clip& clip, double seconds, BodyEnd end) {
  return place_of(clip.body, world_transforms(clip.body, pose_at(clip, seconds)), end);
}

/// Degrees between the face and the direction to a place.
double looks_past(const Clip& clip, double seconds, const Vec3& place) {
  const JointTransforms world = world_transforms(clip.body, pose_at(clip, seconds));
  const Vec3 way = place - place_of(clip.body, world, BodyEnd::head);
  const Vec3 face = world.rotations[Head] * Vec3::UnitZ();
  return std::atan2(face.cross(way).norm(), face.dot(way)) / radians_per_degree;
}

TEST(Keys, AreHeldExactly) {
  const Clip walk = walk_of();
  const BodyFrame body = body_frame(pose_at(walk, 1.5));
  const struct {
    BodyEnd end;
    Vec3 place;
  } goals[] = {{BodyEnd::right_hand, {-0.3, 1.4, 0.35}},
               {BodyEnd::left_hand, {0.4, 1.0, 0.2}},
               {BodyEnd::left_hand, {0.25, 1.75, 0.1}},
               {BodyEnd::right_hand, {0.1, 1.2, 0.3}}};
  for (const auto& [end, place] : goals) {
    const AnimatedClip made = with_keys(walk, {key({1.5}, end, place, PlaceFrame::body)});
    EXPECT_TRUE(made.misses.empty()) << made.remarks.back();
    EXPECT_LT((place_at(made.clip, 1.5, end) - body.to_room(place)).norm(), held_metres);
    const Vec3 there = body.to_room(place);
    EXPECT_LT((place_at(with_keys(walk, {key({1.5}, end, there)}).clip, 1.5, end) - there).norm(),
              held_metres);
  }
}

TEST(Keys, MayBeGivenRelativeToTheMotion) {
  const Clip walk = walk_of();
  const Vec3 before = place_at(walk, 1.0, BodyEnd::left_hand);
  const AnimatedClip made =
      with_keys(walk, {key({1.0}, BodyEnd::left_hand, {0.1, 0.15, 0.15}, PlaceFrame::motion)});
  EXPECT_TRUE(made.misses.empty()) << made.remarks.back();
  const Vec3 moved = place_at(made.clip, 1.0, BodyEnd::left_hand) - before;
  EXPECT_LT((moved - body_frame(pose_at(walk, 1.0)).turn * Vec3(0.1, 0.15, 0.15)).norm(),
            held_metres);
}

TEST(Keys, OfSeveralPartsAreHeldTogether) {
  const Clip walk = natural_walk();
  AnimatorKey both = key({1.2}, BodyEnd::left_hand, {0.2, 1.5, 0.4}, PlaceFrame::body);
  both.places[static_cast<std::size_t>(BodyEnd::right_hand)] = Vec3(-0.2, 1.5, 0.4);
  both.places[static_cast<std::size_t>(BodyEnd::pelvis)] = Vec3(0.0, 0.87, 0.0);
  both.look_at = Vec3(1.0, 1.5, 2.0);
  const AnimatorKey later = key({1.5}, BodyEnd::right_hand, {-0.6, 1.2, 0.2}, PlaceFrame::body);
  const AnimatedClip made = with_keys(walk, {later, both});
  EXPECT_TRUE(made.misses.empty()) << made.remarks.back();
  const BodyFrame body = body_frame(pose_at(walk, 1.2));
  for (const auto& [end, place] : {std::pair(BodyEnd::left_hand, Vec3(0.2, 1.5, 0.4)),
                                   std::pair(BodyEnd::right_hand, Vec3(-0.2, 1.5, 0.4))})
    EXPECT_LT((place_at(made.clip, 1.2, end) - body.to_room(place)).norm(), held_metres);
  EXPECT_LT(looks_past(made.clip, 1.2, body.to_room(Vec3(1.0, 1.5, 2.0))), 0.01);
  EXPECT_LT((place_at(made.clip, 1.5, BodyEnd::right_hand) -
             body_frame(pose_at(walk, 1.5)).to_room(Vec3(-0.6, 1.2, 0.2)))
                .norm(),
            held_metres);
}

TEST(Keys, DirectTheFace) {
  const Clip walk = walk_of();
  const BodyFrame body = body_frame(pose_at(walk, 1.0));
  for (const Vec3& place :
       {Vec3(0, 1.6, 3), Vec3(2, 1.2, 2), Vec3(-2, 2.2, 1.5), Vec3(3, 1.5, -0.5)}) {
    const AnimatedClip made = with_keys(walk, {look({100, true}, place, PlaceFrame::body)});
    EXPECT_TRUE(made.misses.empty()) << made.remarks.back();
    EXPECT_LT(looks_past(made.clip, 1.0, body.to_room(place)), 0.01) << place.transpose();
  }
  const AnimatedClip behind = with_keys(walk, {look({1.0}, {0.3, 1.5, -3}, PlaceFrame::body)});
  ASSERT_EQ(behind.misses.size(), 1u);
  EXPECT_TRUE(behind.misses[0].is_angle);
  EXPECT_EQ(behind.misses[0].frame, 100);
  EXPECT_NE(behind.misses[0].reason.find("head's rotation"), std::string::npos)
      << behind.misses[0].reason;
}

TEST(Keys, LeaveTheMotionOutOfTheirReachBitForBit) {
  const Clip walk = natural_walk();
  AnimatorKey one = key({1.5}, BodyEnd::right_hand, {-0.2, 1.5, 0.6}, PlaceFrame::body);
  one.places[static_cast<std::size_t>(BodyEnd::pelvis)] = Vec3(0, 0.87, 0);
  one.look_at = Vec3(2, 1.5, 1);
  one.reach = 0.4;
  const Clip made = with_keys(walk, {one}).clip;
  int changed = 0;
  for (int f = 0; f < walk.frame_count(); ++f) {
    const auto at = static_cast<std::size_t>(f);
    const bool same = same_pose(made.poses[at], walk.poses[at]);
    if (std::abs(f - 150) >= 40) {
      EXPECT_TRUE(same) << f;
    }
    changed += same ? 0 : 1;
  }
  EXPECT_EQ(changed, 79);
  // And parts on which no key acts.
  for (std::size_t f = 0; f < walk.poses.size(); ++f)
    EXPECT_EQ(made.poses[f].rotations[LeftElbow].coeffs(),
              walk.poses[f].rotations[LeftElbow].coeffs());
}

TEST(Keys, MoveTheMotionSmoothly) {
  const Clip walk = walk_of(3.0, 1000.0);
  AnimatorKey one = key({1.2}, BodyEnd::right_hand, {-0.3, 1.5, 0.4}, PlaceFrame::body);
  AnimatorKey two = key({1.6}, BodyEnd::right_hand, {-0.5, 1.2, 0.2}, PlaceFrame::body);
  const Clip made = with_keys(walk, {one, two}).clip;
  std::vector<Vec3> shift;
  for (std::size_t f = 0; f < walk.poses.size(); ++f) {
    shift.push_back(place_at(made, f / 1000.0, BodyEnd::right_hand) -
                    place_at(walk, f / 1000.0, BodyEnd::right_hand));
  }
  const auto acceleration = [&](std::size_t f, std::size_t h) {
    return Vec3((shift[f - h] - 2.0 * shift[f] + shift[f + h]) / (1e-6 * double(h * h)));
  };
  // No jump: over a twentieth of the step the acceleration changes by far less.
  double near = 0.0, far = 0.0;
  for (std::size_t f = 500; f < 2400; ++f) {
    near = std::max(near, (acceleration(f + 5, 5) - acceleration(f, 5)).norm());
    far = std::max(far, (acceleration(f + 100, 5) - acceleration(f, 5)).norm());
  }
  EXPECT_GT(far, 1.0);
  EXPECT_LT(near, 0.2 * far);
}

TEST(Keys, KeepBonesAndLoops) {
  std::mt19937_64 random(3);
  const Clip loop = random_loop(random, 40, 30.0, 0.3).clip;
  const Clip made =
      with_keys(loop, {key({0.1}, BodyEnd::left_hand, {0.35, 1.2, 0.25}, PlaceFrame::body)}).clip;
  EXPECT_TRUE(made.loops);
  EXPECT_EQ(made.cycle_displacement, loop.cycle_displacement);
  for (std::size_t f = 0; f < made.poses.size(); ++f) {
    const auto now = world_positions(made.body, made.poses[f]);
    for (int j = 1; j < body_joint_count; ++j) {
      const auto at = static_cast<std::size_t>(j);
      const auto parent = static_cast<std::size_t>(body_parents[at]);
      EXPECT_NEAR((now[at] - now[parent]).norm(), made.body.joints[at].offset.norm(), 1e-9);
    }
  }
  // Across the seam: the first and the last frames are changed, and a rotated loop is the same loop
  // with its key at another time.
  EXPECT_FALSE(same_pose(made.poses.front(), loop.poses.front()));
  EXPECT_FALSE(same_pose(made.poses.back(), loop.poses.back()));
  Clip rotated = loop;
  const int by = 17;
  for (int f = 0; f < loop.frame_count(); ++f) {
    const int from = (f + by) % loop.frame_count();
    Pose& pose = rotated.poses[static_cast<std::size_t>(f)];
    pose = loop.poses[static_cast<std::size_t>(from)];
    if (f + by >= loop.frame_count()) pose.root_position += loop.cycle_displacement;
  }
  const Clip other = with_keys(rotated, {key({0.1 + (40 - by) / 30.0}, BodyEnd::left_hand,
                                             {0.35, 1.2, 0.25}, PlaceFrame::body)})
                         .clip;
  for (int f = 0; f < loop.frame_count(); ++f) {
    const Pose& a = other.poses[static_cast<std::size_t>(f)];
    const Pose& b = made.poses[static_cast<std::size_t>((f + by) % loop.frame_count())];
    for (std::size_t j = 0; j < a.rotations.size(); ++j)
      EXPECT_LT(angle_between(a.rotations[j], b.rotations[j]), 1e-7) << f << ' ' << j;
  }
}

TEST(Keys, AreMirroredWithTheMotion) {
  const Clip walk = natural_walk();
  AnimatorKey right = key({1.4}, BodyEnd::right_hand, {-0.2, 1.5, 0.75}, PlaceFrame::body);
  right.look_at = Vec3(-3, 1, 1);
  right.places[static_cast<std::size_t>(BodyEnd::pelvis)] = Vec3(0.02, 0.87, 0.0);
  AnimatorKey left = key({1.4}, BodyEnd::left_hand, {0.2, 1.5, 0.75}, PlaceFrame::body);
  left.look_at = Vec3(3, 1, 1);
  left.places[static_cast<std::size_t>(BodyEnd::pelvis)] = Vec3(-0.02, 0.87, 0.0);
  const Clip one = mirrored(with_keys(walk, {right}).clip);
  const Clip two = with_keys(mirrored(walk), {left}).clip;
  for (std::size_t f = 0; f < one.poses.size(); ++f) {
    const auto a = world_positions(one.body, one.poses[f]);
    const auto b = world_positions(two.body, two.poses[f]);
    for (std::size_t j = 0; j < a.size(); ++j) EXPECT_LT((a[j] - b[j]).norm(), 1e-6) << f;
  }
}

TEST(Keys, DoTheSameAtEveryFrameRate) {
  const std::vector<AnimatorKey> keys = {
      key({1.213}, BodyEnd::right_hand, {-0.3, 1.4, 0.4}, PlaceFrame::body),
      key({1.5}, BodyEnd::right_hand, {-0.5, 1.1, 0.3}, PlaceFrame::body)};
  const Clip fine = with_keys(walk_of(3.0, 200.0), keys).clip;
  const Clip coarse = with_keys(walk_of(3.0, 50.0), keys).clip;
  for (int f = 0; f < coarse.frame_count(); ++f) {
    const auto a = world_positions(coarse.body, coarse.poses[static_cast<std::size_t>(f)]);
    const auto b = world_positions(fine.body, fine.poses[static_cast<std::size_t>(4 * f)]);
    for (std::size_t j = 0; j < a.size(); ++j) EXPECT_LT((a[j] - b[j]).norm(), 1e-3) << f;
  }
}

TEST(Keys, OutOfReachAreApproachedAndTold) {
  const Clip walk = walk_of();
  const AnimatedClip made =
      with_keys(walk, {key({150, true}, BodyEnd::right_hand, {-0.2, 1.4, 1.6}, PlaceFrame::body)});
  ASSERT_EQ(made.misses.size(), 1u);
  EXPECT_EQ(made.misses[0].part, "right hand");
  EXPECT_EQ(made.misses[0].frame, 150);
  const Vec3 target = body_frame(pose_at(walk, 1.5)).to_room(Vec3(-0.2, 1.4, 1.6));
  const double left = (place_at(made.clip, 1.5, BodyEnd::right_hand) - target).norm();
  EXPECT_NEAR(made.misses[0].amount, left, 1e-9);
  EXPECT_LT(left, (place_at(walk, 1.5, BodyEnd::right_hand) - target).norm() - 0.5);
  EXPECT_NE(made.remarks.back().find("(frame 150): out of reach"), std::string::npos)
      << made.remarks.back();
}

TEST(Keys, LeanTheTrunkWhereTheArmIsTooShort) {
  const Clip walk = walk_of();
  const Vec3 place(-0.2, 1.3, 0.75);
  const AnimatedClip made =
      with_keys(walk, {key({1.5}, BodyEnd::right_hand, place, PlaceFrame::body)});
  EXPECT_TRUE(made.misses.empty()) << made.remarks.back();
  EXPECT_GT(angle_between(made.clip.poses[150].rotations[Chest], walk.poses[150].rotations[Chest]),
            0.05);
  const AnimatedClip near =
      with_keys(walk, {key({1.5}, BodyEnd::right_hand, {-0.2, 1.3, 0.4}, PlaceFrame::body)});
  EXPECT_EQ(near.clip.poses[150].rotations[Chest].coeffs(),
            walk.poses[150].rotations[Chest].coeffs());
}

TEST(Keys, StopAtTheLimitsOfJoints) {
  const Clip walk = walk_of();
  // Behind the back, and too near to the shoulder for the elbow.
  const struct {
    Vec3 place;
    const char* reason;
  } goals[] = {{{-0.2, 1.35, -0.6}, "right shoulder's"},
               {{-0.2, 1.42, 0.03}, "right elbow's flexion"}};
  for (const auto& [place, reason] : goals) {
    const AnimatedClip made =
        with_keys(walk, {key({1.5}, BodyEnd::right_hand, place, PlaceFrame::body)});
    ASSERT_EQ(made.misses.size(), 1u) << place.transpose();
    EXPECT_NE(made.misses[0].reason.find(reason), std::string::npos) << made.misses[0].reason;
    for (std::size_t f = 0; f < made.clip.poses.size(); ++f) {
      const std::vector<double> before = measured_angles(walk.poses[f]);
      const std::vector<double> after = measured_angles(made.clip.poses[f]);
      for (std::size_t a = 0; a < after.size(); ++a) {
        const JointAngle& angle = joint_angles()[a];
        EXPECT_LT(after[a], std::max(before[a], angle.most_degrees) + 0.6) << f;
        EXPECT_GT(after[a], std::min(before[a], angle.least_degrees) - 0.6) << f;
      }
    }
  }
}

TEST(Keys, OfThePelvisLeaveTheFeetWhereTheyAre) {
  const Clip walk = natural_walk();
  const AnimatedClip made =
      with_keys(walk, {key({1.5}, BodyEnd::pelvis, {0.02, -0.03, 0.01}, PlaceFrame::motion)});
  EXPECT_TRUE(made.misses.empty()) << made.remarks.back();
  for (std::size_t f = 0; f < walk.poses.size(); ++f) {
    const JointTransforms a = world_transforms(walk.body, walk.poses[f]);
    const JointTransforms b = world_transforms(walk.body, made.clip.poses[f]);
    for (const BodyJoint ankle : {LeftAnkle, RightAnkle}) {
      EXPECT_LT((a.positions[ankle] - b.positions[ankle]).norm(), 1e-3) << f;
      EXPECT_LT(angle_between(a.rotations[ankle], b.rotations[ankle]), 1e-6) << f;
    }
  }
  // A pelvis that legs cannot follow stops, and the feet stay.
  const AnimatedClip high =
      with_keys(walk, {key({1.5}, BodyEnd::pelvis, {0.0, 1.2, 0.0}, PlaceFrame::body)});
  ASSERT_EQ(high.misses.size(), 1u);
  EXPECT_NE(high.misses[0].reason.find("length of the"), std::string::npos)
      << high.misses[0].reason;
  for (std::size_t f = 0; f < walk.poses.size(); ++f) {
    for (const BodyEnd foot : {BodyEnd::left_foot, BodyEnd::right_foot})
      EXPECT_LT((place_at(high.clip, f / 100.0, foot) - place_at(walk, f / 100.0, foot)).norm(),
                2e-3);
  }
}

TEST(Keys, OfAPlantedFootMoveItsWholeContact) {
  const Clip walk = natural_walk();
  const std::vector<FootPlant> plants = foot_plants(walk);
  const FootPlant plant = plants[2];
  const BodyEnd foot = plant.left ? BodyEnd::left_foot : BodyEnd::right_foot;
  const Vec3 shift(plant.left ? 0.03 : -0.03, 0.0, 0.01);
  const int middle = (plant.first + plant.last) / 2;
  const AnimatedClip made =
      with_keys(walk, {key({double(middle), true}, foot, shift, PlaceFrame::motion)});
  EXPECT_TRUE(made.misses.empty()) << made.remarks.back();
  EXPECT_LT(planted_drift(made.clip, plants), planted_drift(walk, plants) + 1e-6);
  const auto moved = [&](int f) {
    return Vec3(place_at(made.clip, f / 100.0, foot) - place_at(walk, f / 100.0, foot));
  };
  EXPECT_LT((moved(middle) - shift).norm(), 1e-3);
  for (int f = plant.first; f <= plant.last; ++f) {
    EXPECT_LT((moved(f) - moved(middle)).norm(), held_metres) << f;
  }
}

TEST(Keys, OfASwingingFootKeepItsContacts) {
  const Clip walk = natural_walk();
  const std::vector<FootPlant> plants = foot_plants(walk);
  const FootPlant plant = plants[2];
  const BodyEnd foot = plant.left ? BodyEnd::left_foot : BodyEnd::right_foot;
  const double swing = (plant.last + 20) / 100.0;
  const AnimatedClip made =
      with_keys(walk, {key({swing}, foot, {0.0, 0.15, 0.0}, PlaceFrame::motion)});
  EXPECT_TRUE(made.misses.empty()) << made.remarks.back();
  EXPECT_NEAR((place_at(made.clip, swing, foot) - place_at(walk, swing, foot)).y(), 0.15,
              held_metres);
  EXPECT_LT(planted_drift(made.clip, plants), planted_drift(walk, plants) + 1e-9);
}

TEST(Keys, RefuseWhatCannotBeMeant) {
  const Clip walk = walk_of();
  const auto refusal = [&](const std::vector<AnimatorKey>& keys) {
    return refusal_of([&] { with_keys(walk, keys); });
  };
  const AnimatorKey hand = key({1.0}, BodyEnd::left_hand, {0.3, 1.2, 0.3});
  EXPECT_EQ(refusal({key({5.0}, BodyEnd::left_hand, {0, 1, 0})}),
            "a key is at 5 s, but the motion lasts 3 s; give a moment of the motion");
  EXPECT_EQ(refusal({key({-1.0}, BodyEnd::left_hand, {0, 1, 0})}),
            "a key is at -1 s, but the motion lasts 3 s; give a moment of the motion");
  EXPECT_EQ(refusal({hand, key({100, true}, BodyEnd::left_hand, {0, 1, 0})}),
            "two keys place the left hand at 1 s; omit one of them");
  AnimatorKey short_reach = hand;
  short_reach.reach = 0.0;
  EXPECT_NE(refusal({short_reach}).find("reach is not above 0"), std::string::npos);
  std::mt19937_64 random(1);
  const Clip loop = random_loop(random, 30).clip;
  EXPECT_EQ(refusal_of([&] {
              with_keys(loop, {key({1.0}, BodyEnd::left_hand, {0, 1, 0})});
            }),
            "a key is at 1 s, but the motion lasts 1 s; give a moment of its first cycle");
}

}  // namespace
}  // namespace mien::motion
