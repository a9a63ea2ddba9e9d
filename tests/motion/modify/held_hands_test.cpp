#include "motion/modify/held_hands.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "motion/modify/modification.h"
#include "motion/procedural/knock.h"
#include "motion/skeleton/mirror.h"
#include "motion/synthetic_walk.h"

#include "path_measures.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Clip knocking() { return knock(angry_knock(), 60.0, standard_body()).clip; }

Vec3 right_wrist(const Clip& clip, int frame) {
  return world_transform(clip.body, clip.poses[static_cast<std::size_t>(frame)], RightWrist)
      .position;
}

double speed_before(const Clip& clip, int frame) {
  return (right_wrist(clip, frame) - right_wrist(clip, frame - 2)).norm() * clip.frames_per_second /
         2.0;
}

Modification leaning_with_short_paths() {
  Modification m;
  m.paths = 0.4;
  m.posture = {{PostureUnit::chest_flexion, 12.0}};
  return m;
}

TEST(HeldHands, HitWhereTheyDidBefore) {
  const Clip clip = knocking();
  const std::vector<HandHit> hits = hand_hits(clip);
  ASSERT_EQ(hits.size(), 4u);
  const ModifiedClip held = modify(clip, leaning_with_short_paths());
  Modification free = leaning_with_short_paths();
  free.repair = FootRepair::none;
  const Clip loose = modified(clip, free);
  for (const HandHit& hit : hits) {
    EXPECT_LT((right_wrist(held.clip, hit.frame) - right_wrist(clip, hit.frame)).norm(), 1e-3);
    EXPECT_GT((right_wrist(loose, hit.frame) - right_wrist(clip, hit.frame)).norm(), 0.02);
  }
  EXPECT_EQ(held.report.hits, 4);
  EXPECT_GT(held.report.hand_correction, 0.02);
  EXPECT_EQ(hand_hits(held.clip).size(), 4u);
}

TEST(HeldHands, HoldBothSidesAlike) {
  const Clip clip = knocking();
  const Clip one = mirrored(modified(clip, leaning_with_short_paths()));
  const Clip other = modified(mirrored(clip), leaning_with_short_paths());
  for (std::size_t f = 0; f < one.poses.size(); ++f)
    EXPECT_LT((world_positions(one.body, one.poses[f])[LeftWrist] -
               world_positions(other.body, other.poses[f])[LeftWrist])
                  .norm(),
              1e-6);
}

TEST(HeldHands, ChangeNothingElse) {
  const Clip clip = knocking();
  const HeldHands same = with_held_hands(clip, clip, hand_hits(clip), false);
  EXPECT_EQ(same.largest_correction, 0.0);
  Clip lower = clip;
  for (Pose& pose : lower.poses) pose.root_position.y() -= 0.01;
  const HeldHands held = with_held_hands(lower, clip, hand_hits(clip), false);
  EXPECT_NEAR(held.largest_correction, 0.01, 1e-9);
  const int first = hand_hits(clip).front().frame;
  for (std::size_t f = 0; f < clip.poses.size(); ++f) {
    for (int joint = 0; joint < body_joint_count; ++joint) {
      const bool may_move =
          (joint == RightShoulder || joint == RightElbow || joint == RightWrist) &&
          static_cast<int>(f) > first - 14;
      if (may_move) continue;
      EXPECT_EQ(held.clip.poses[f].rotations[static_cast<std::size_t>(joint)].coeffs(),
                lower.poses[f].rotations[static_cast<std::size_t>(joint)].coeffs());
    }
  }
}

TEST(HeldHands, KeepTheirHitsAtAnotherTempo) {
  const Clip clip = knocking();
  Modification m = leaning_with_short_paths();
  m.tempo = 0.8;
  const Clip slower = modified(clip, m);
  for (const HandHit& hit :
       retimed(hand_hits(clip), retiming_between(clip.frame_count(), slower.frame_count(), false)))
    EXPECT_LT((right_wrist(slower, hit.frame) - right_wrist(clip, 0) -
               (right_wrist(clip, static_cast<int>(hit.frame * 0.8 + 0.5)) - right_wrist(clip, 0)))
                  .norm(),
              0.02);
}

TEST(HeldHands, AreFreeWhereTheirTimingChangesOtherwise) {
  const Clip clip = knocking();
  Modification m;
  m.acceleration = 1.0;
  EXPECT_EQ(modify(clip, m).report.hand_correction, 0.0);
  m.limbs.right_hand = false;
  m.paths = 0.4;
  EXPECT_GT(modify(clip, m).report.hand_correction, 0.01);
  m = {};
  m.variation = 1.0;
  EXPECT_EQ(modify(clip, m).report.hand_correction, 0.0);
}

TEST(HeldHands, AreFiniteWhereHitsComeToTheSameFrame) {
  const Clip clip = knocking();
  std::vector<HandHit> hits = hand_hits(clip);
  hits.push_back(hits.back());
  hits.back().frame += 1;
  const std::vector<HandHit> fewer =
      retimed(hits, retiming_between(clip.frame_count(), clip.frame_count() / 4, false));
  EXPECT_EQ(fewer.size(), 4u);
  Modification m = leaning_with_short_paths();
  m.tempo = 4.0;
  for (const Pose& pose : modified(clip, m).poses)
    for (const Quat& rotation : pose.rotations) EXPECT_TRUE(rotation.coeffs().allFinite());
}

TEST(HeldHands, HitHarderWithAccelerationAtContactsOrHits) {
  const Clip clip = knocking();
  for (const AccelerationPlace place : {AccelerationPlace::contacts, AccelerationPlace::hits}) {
    Modification m;
    m.acceleration = 1.0;
    m.acceleration_place = place;
    const ModifiedClip harder = modify(clip, m);
    for (const HandHit& hit : hand_hits(clip)) {
      EXPECT_GT(speed_before(harder.clip, hit.frame), 1.5 * speed_before(clip, hit.frame));
      EXPECT_LT((right_wrist(harder.clip, hit.frame) - right_wrist(clip, hit.frame)).norm(), 1e-3);
    }
    for (const std::string& remark : harder.report.remarks)
      EXPECT_EQ(remark.find("no effect"), std::string::npos) << remark;
  }
}

/// Whether all poses of two clips are the same to the bit, but for the right arm.
bool same_but_for_right_arm(const Clip& a, const Clip& b) {
  for (std::size_t f = 0; f < a.poses.size(); ++f) {
    for (std::size_t j = 0; j < body_joint_count; ++j) {
      const bool is_right_arm = j >= RightClavicle && j <= RightWrist;
      if (!is_right_arm && a.poses[f].rotations[j].coeffs() != b.poses[f].rotations[j].coeffs()) {
        return false;
      }
    }
  }
  return true;
}

/// The largest turn of a joint above the pelvis between two clips, radians.
double largest_turn_above_pelvis(const Clip& a, const Clip& b) {
  double largest = 0.0;
  for (std::size_t f = 0; f < a.poses.size(); ++f) {
    for (std::size_t j = Spine; j <= RightWrist; ++j) {
      largest = std::max(largest, a.poses[f].rotations[j].angularDistance(b.poses[f].rotations[j]));
    }
  }
  return largest;
}

TEST(HeldHands, AreNotAcceleratedAtHitsWhereTheyHitNothing) {
  const Clip walk = synthetic_clip(steady_walk(1.2, 3.0));
  Modification m;
  m.acceleration = 1.0;
  m.soft_joint_limits = false;
  m.acceleration_place = AccelerationPlace::contacts;
  EXPECT_GT(largest_turn_above_pelvis(modified(walk, m), walk), 0.05);
  m.acceleration_place = AccelerationPlace::hits;
  const ModifiedClip after = modify(walk, m);
  EXPECT_LT(largest_turn_above_pelvis(after.clip, walk), 1e-9);
  for (const std::string& remark : after.report.remarks)
    EXPECT_EQ(remark.find("no effect"), std::string::npos) << remark;
}

TEST(HeldHands, AloneAreAcceleratedAtHits) {
  Modification m;
  m.acceleration = 1.0;
  m.acceleration_place = AccelerationPlace::hits;
  m.repair = FootRepair::none;
  m.soft_joint_limits = false;
  m.limbs = {true, true, true, true, true};
  const Clip clip = knocking();
  const Clip harder = modified(clip, m);
  EXPECT_TRUE(same_but_for_right_arm(harder, clip));
  EXPECT_GT(speed_before(harder, hand_hits(clip).front().frame),
            1.5 * speed_before(clip, hand_hits(clip).front().frame));
  m.limbs.right_hand = false;
  EXPECT_EQ(largest_distance(modified(clip, m), clip), 0.0);
}

}  // namespace
}  // namespace mien::motion
