#include "motion/modify/held_hands.h"

#include <gtest/gtest.h>

#include "motion/modify/modification.h"
#include "motion/procedural/knock.h"
#include "motion/skeleton/mirror.h"

namespace mien::motion {
namespace {

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

TEST(HeldHands, HitHarderWithAccelerationAtContacts) {
  const Clip clip = knocking();
  Modification m;
  m.acceleration = 1.0;
  m.acceleration_place = AccelerationPlace::contacts;
  const ModifiedClip harder = modify(clip, m);
  for (const HandHit& hit : hand_hits(clip)) {
    EXPECT_GT(speed_before(harder.clip, hit.frame), 1.5 * speed_before(clip, hit.frame));
    EXPECT_LT((right_wrist(harder.clip, hit.frame) - right_wrist(clip, hit.frame)).norm(), 1e-3);
  }
  for (const std::string& remark : harder.report.remarks)
    EXPECT_EQ(remark.find("no effect"), std::string::npos) << remark;
}

}  // namespace
}  // namespace mien::motion
