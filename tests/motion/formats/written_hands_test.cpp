#include <gtest/gtest.h>

#include "motion/formats/bvh/bvh.h"
#include "motion/formats/gltf/gltf.h"
#include "motion/formats/smpl/smpl.h"
#include "motion/formats/smpl/smpl_joints.h"
#include "motion/handed_motion.h"
#include "motion/rig/body_mapping.h"
#include "motion/skeleton/finger_angles.h"
#include "motion/skeleton/recorded_hands.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Clip handed_walk() {
  std::mt19937_64 random(1);
  return with_moving_fingers(synthetic_clip(steady_walk(1.2, 1.0)), random);
}

/// The largest distance between fingertips in the world, metres; floors apart.
double largest_tip_distance(const Clip& a, const Clip& b) {
  double largest = 0.0;
  for (size_t f = 0; f < a.poses.size(); ++f) {
    const auto of_a = fingertips(a.body, a.poses[f]);
    const auto of_b = fingertips(b.body, b.poses[f]);
    for (size_t tip = 0; tip < of_a.size(); ++tip) {
      const int wrist = tip < fingers_per_hand ? LeftWrist : RightWrist;
      const JointTransform in_a = world_transform(a.body, a.poses[f], wrist);
      const JointTransform in_b = world_transform(b.body, b.poses[f], wrist);
      Vec3 way =
          in_a.position + in_a.rotation * of_a[tip] - in_b.position - in_b.rotation * of_b[tip];
      way.y() -= a.poses[f].root_position.y() - b.poses[f].root_position.y();
      largest = std::max(largest, way.norm());
    }
  }
  return largest;
}

void expect_hand_tips_of_body(const Clip& read, const Clip& written) {
  for (const BodyJoint wrist : {LeftWrist, RightWrist})
    EXPECT_LT((*read.body.joints[wrist].tip - *written.body.joints[wrist].tip).norm(), 1e-6);
}

TEST(WrittenHands, OfBvhAreReadAsTheyWere) {
  const Clip clip = handed_walk();
  const Recording recording = to_recording(clip);
  ASSERT_EQ(recording.skeleton.size(), body_joint_count + finger_joint_count);
  const Recording parsed = parse_bvh(to_bvh(recording), "walk.bvh");
  const BodyMapping mapping = recognise(parsed);
  EXPECT_EQ(mapping.rig, "mien");
  EXPECT_TRUE(mapping.warnings.empty());
  const Clip read = to_body(parsed, mapping);
  EXPECT_LT(largest_tip_distance(clip, read), 1e-6);
  expect_hand_tips_of_body(read, clip);
  const Clip quick = to_body(as_read_from_bvh(recording));
  for (size_t f = 0; f < read.poses.size(); ++f)
    for (size_t j = 0; j < size_t(finger_joint_count); ++j)
      EXPECT_EQ(quick.poses[f].fingers[j].coeffs(), read.poses[f].fingers[j].coeffs());
}

TEST(WrittenHands, OfGltfAreReadAsTheyWere) {
  const Clip clip = handed_walk();
  const Clip read = to_body(parse_gltf(to_glb(to_recording(clip)), "walk.glb"));
  EXPECT_LT(largest_tip_distance(clip, read), 1e-6);
  expect_hand_tips_of_body(read, clip);
}

// Bone lengths are not part of the format, so the fingers are compared joint by joint.
TEST(WrittenHands, OfAmassAreReadAsTheyWere) {
  const Clip clip = handed_walk();
  const Clip read = to_body(parse_smpl(to_amass_npz(to_recording(clip)), "walk.npz"));
  ASSERT_TRUE(has_fingers(read));
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    EXPECT_LT(largest_finger_turn(clip.poses[f], read.poses[f]), 1e-6) << f;
    const auto of_clip = fingertips(clip.body, clip.poses[f]);
    const auto of_read = fingertips(clip.body, read.poses[f]);
    for (size_t tip = 0; tip < of_clip.size(); ++tip)
      EXPECT_LT((of_clip[tip] - of_read[tip]).norm(), 1e-6) << f;
  }
}

TEST(WrittenHands, AreTheSameWhenTheyAreWrittenAgain) {
  const Clip clip = handed_walk();
  const std::string once = to_bvh(to_recording(clip));
  const std::string twice = to_bvh(to_recording(to_body(parse_bvh(once, "a.bvh"))));
  const Clip first = to_body(parse_bvh(once, "a.bvh"));
  const Clip second = to_body(parse_bvh(twice, "a.bvh"));
  EXPECT_LT(largest_tip_distance(first, second), 1e-7);
}

TEST(WrittenHands, OfMotionsWithoutFingersAreNotThere) {
  Clip clip = handed_walk();
  for (Pose& pose : clip.poses) pose.fingers.clear();
  const Recording recording = to_recording(clip);
  EXPECT_TRUE(is_body(recording.skeleton));
  EXPECT_EQ(to_bvh(recording).find("Index"), std::string::npos);
  const Clip read = to_body(parse_smpl(to_amass_npz(recording), "walk.npz"));
  EXPECT_FALSE(has_fingers(read));
}

TEST(WrittenHands, OfAmassHaveThePlacesOfTheirNames) {
  const Skeleton smplh = smpl_skeleton(52);
  for (int j = 0; j < finger_joint_count; ++j) {
    const std::string& name = smplh.joints[size_t(smplh_joint_of_finger(j))].name;
    const char* fingers[] = {"thumb", "index", "middle", "ring", "pinky"};
    EXPECT_EQ(name, std::string(is_left_finger(j) ? "left_" : "right_") +
                        fingers[static_cast<int>(finger_of(j))] +
                        std::to_string(segment_of(j) + 1));
  }
}

}  // namespace
}  // namespace mien::motion
