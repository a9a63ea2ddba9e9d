#include "motion/modify/posture.h"

#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"
#include "motion/procedural/walker.h"
#include "motion/skeleton/mirror.h"

#include "path_measures.h"
#include "real_takes.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Clip standing_still(const Skeleton& body) {
  Clip clip;
  clip.body = body;
  clip.frames_per_second = 30.0;
  clip.poses.assign(20, standing_pose(body));
  return clip;
}

/// Joint places, seen from the pelvis, of somebody standing with that change.
std::vector<Vec3> places_with(PostureUnit unit, double degrees) {
  const Clip clip = with_posture(standing_still(standard_body()), {{unit, degrees}});
  std::vector<Vec3> places = joint_paths(clip)[10];
  const JointTransforms world = world_transforms(clip.body, clip.poses[10]);
  for (const int joint : {Head, LeftWrist, RightWrist, LeftToe, RightToe}) {
    places.push_back(places[size_t(joint)] +
                     world.rotations[size_t(joint)] * (0.1 * rest_direction(BodyJoint(joint))));
  }
  return places;
}

// Entries of `places_with` after the joints: ends of the bones that the last joints carry.
enum : int { Crown = body_joint_count, LeftHand, RightHand, LeftTip, RightTip };

TEST(Posture, HasAUniqueNameForEveryUnit) {
  std::set<std::string_view> names;
  for (const PostureUnitName& unit : posture_units()) {
    names.insert(unit.name);
    EXPECT_EQ(posture_unit(unit.name), unit.unit);
    EXPECT_EQ(name_of(unit.unit), unit.name);
  }
  EXPECT_EQ(names.size(), 20u);
  EXPECT_FALSE(posture_unit("head-flexing"));
}

TEST(Posture, MovesTheBodyWhereItsDescriptionSays) {
  using enum PostureUnit;
  struct Expectation {
    PostureUnit unit;
    int joint;
    Vec3 towards;
  };
  const Vec3 left = Vec3::UnitX(), up = Vec3::UnitY(), forward = Vec3::UnitZ();
  const std::vector<Expectation> expectations = {
      {head_flexion, Crown, forward},
      {head_lateral, Crown, left},
      {chest_flexion, Neck, forward},
      {spine_flexion, Chest, forward},
      {spine_lateral, Chest, left},
      {spine_turn, LeftShoulder, -forward},
      {pelvis_tilt, Head, forward},
      {shoulder_elevation, LeftShoulder, up},
      {shoulder_protraction, LeftShoulder, forward},
      {shoulder_abduction, LeftElbow, left},
      {shoulder_flexion, LeftElbow, forward},
      {shoulder_internal_rotation, LeftWrist, -left},
      {elbow_flexion, LeftWrist, forward},
      {wrist_flexion, LeftHand, -left},
      {hip_abduction, LeftAnkle, left},
      {hip_flexion, LeftKnee, forward},
      {hip_internal_rotation, LeftToe, -left},
      {knee_flexion, LeftAnkle, -forward},
      {ankle_dorsiflexion, LeftToe, up},
  };
  const std::map<int, int> other_side = {{LeftHand, RightHand}, {LeftTip, RightTip}};
  for (const Expectation& e : expectations) {
    const auto before = places_with(e.unit, 0.0);
    const auto after = places_with(e.unit, 10.0);
    const auto moved = [&](int j) { return Vec3(after[size_t(j)] - before[size_t(j)]); };
    EXPECT_GT(moved(e.joint).normalized().dot(e.towards), 0.7) << name_of(e.unit);
    const auto named = other_side.find(e.joint);
    const int right = named != other_side.end()    ? named->second
                      : e.joint < body_joint_count ? int(mirrored(BodyJoint(e.joint)))
                                                   : e.joint;
    if (right == e.joint || e.unit == spine_turn) continue;
    EXPECT_LT((mirrored_place(moved(e.joint)) - moved(right)).norm(), 1e-12) << name_of(e.unit);
  }
}

TEST(Posture, TurnsTheFaceToTheLeft) {
  const Clip clip = with_posture(standing_still(standard_body()), {{PostureUnit::head_turn, 30.0}});
  const Vec3 face = world_transforms(clip.body, clip.poses[0]).rotations[Head] * Vec3::UnitZ();
  EXPECT_NEAR(std::atan2(face.x(), face.z()), 30.0 * radians_per_degree, 1e-9);
}

TEST(Posture, TurnsTheJointByTheStatedAngle) {
  using enum PostureUnit;
  const std::map<PostureUnit, BodyJoint> turned = {
      {head_flexion, Head},       {spine_flexion, Chest},
      {chest_flexion, Chest},     {shoulder_abduction, LeftShoulder},
      {elbow_flexion, LeftElbow}, {hip_abduction, LeftHip},
      {hip_flexion, RightHip},    {knee_flexion, RightKnee},
      {pelvis_tilt, Pelvis}};
  const Clip before = standing_still(standard_body());
  for (const auto& [unit, joint] : turned) {
    const Clip after = with_posture(before, {{unit, 17.0}});
    const auto from = world_transforms(before.body, before.poses[5]).rotations[size_t(joint)];
    const auto to = world_transforms(after.body, after.poses[5]).rotations[size_t(joint)];
    EXPECT_NEAR(angle_between(from, to), 17.0 * radians_per_degree, 1e-9) << name_of(unit);
  }
}

double head_pitch(const Clip& clip, size_t frame) {
  const JointTransforms world = world_transforms(clip.body, clip.poses[frame]);
  const Quat facing = heading(world.rotations[Chest] * Vec3::UnitZ());
  const Vec3 up = facing.conjugate() * (world.rotations[Head] * Vec3::UnitY());
  return std::atan2(up.z(), up.y()) / radians_per_degree;
}

TEST(Posture, LowersTheHeadOfRealWalksByTheStatedAngle) {
  const std::vector<Clip> walks = real_walks();
  if (walks.empty()) GTEST_SKIP() << "no motion capture here: set MIEN_DATA";
  for (const Clip& walk : walks) {
    const Clip lowered = with_posture(walk, {{PostureUnit::head_flexion, 25.0}});
    double mean = 0.0;
    for (size_t f = 0; f < walk.poses.size(); ++f) {
      mean += (head_pitch(lowered, f) - head_pitch(walk, f)) / walk.frame_count();
      EXPECT_NEAR(angle_between(world_transforms(walk.body, walk.poses[f]).rotations[Head],
                                world_transforms(walk.body, lowered.poses[f]).rotations[Head]),
                  25.0 * radians_per_degree, 1e-9);
    }
    // A head that is tilted sideways goes round the vertical a little faster.
    EXPECT_NEAR(mean, 25.0, 2.0) << walk.name;
  }
}

TEST(Posture, FadesFromAnArmThatIsRaised) {
  Clip clip = standing_still(standard_body());
  for (Pose& pose : clip.poses) pose.rotations[LeftShoulder] = Quat::Identity();  // to the side
  const Clip after = with_posture(clip, {{PostureUnit::shoulder_abduction, 20.0}});
  EXPECT_LT(angle_between(after.poses[5].rotations[LeftShoulder], Quat::Identity()), 1e-9);
  EXPECT_NEAR(angle_between(after.poses[5].rotations[RightShoulder],
                            clip.poses[5].rotations[RightShoulder]),
              20.0 * radians_per_degree, 1e-9);
}

TEST(Posture, OfTwoPosesMakesOneOfTheOther) {
  Clip clip = standing_still(standard_body());
  Pose posed = clip.poses[0];
  for (const int joint : {Spine, Head, LeftClavicle, LeftShoulder, RightElbow, RightHip}) {
    posed.rotations[size_t(joint)] =
        posed.rotations[size_t(joint)] * exp(Vec3(0.1, -0.03 * joint, 0.05));
  }
  const Clip after = with_posture(clip, {}, pose_difference(clip.poses[0], posed));
  for (size_t j = 0; j < body_joint_count; ++j) {
    EXPECT_LT(angle_between(after.poses[7].rotations[j], posed.rotations[j]), 1e-9) << j;
  }
}

TEST(Posture, OfTwoPosesDoesNotMindWhereTheyFace) {
  const Pose neutral = standing_pose(standard_body());
  Pose posed = neutral;
  posed.rotations[Pelvis] = exp(Vec3(0, 1.3, 0)) * exp(Vec3(0.2, 0, 0));
  EXPECT_LT((log(pose_difference(neutral, posed).turns[Pelvis]) - Vec3(0.2, 0, 0)).norm(), 1e-9);
}

TEST(Posture, TurnsBodiesOfEverySizeAlike) {
  const std::vector<PostureChange> changes = {{PostureUnit::shoulder_abduction, 12.0},
                                              {PostureUnit::knee_flexion, 5.0}};
  const Clip tall = with_posture(walk({}, 30.0, standard_body(1.95)).clip, changes);
  Clip small = walk({}, 30.0, standard_body(1.95)).clip;
  small.body = standard_body(1.5);
  for (Pose& pose : small.poses) pose.root_position *= 1.5 / 1.95;
  small = with_posture(small, changes);
  for (size_t f = 0; f < tall.poses.size(); ++f) {
    for (size_t j = 0; j < body_joint_count; ++j) {
      EXPECT_LT(angle_between(tall.poses[f].rotations[j], small.poses[f].rotations[j]), 1e-9);
    }
  }
}

TEST(Posture, OfLoopsHasNoSeam) {
  const Clip clip = walk({}, 30.0, standard_body()).clip;
  const Clip after = with_posture(clip, {{PostureUnit::shoulder_abduction, 25.0}});
  EXPECT_LT(largest_second_difference(after), 1.2 * largest_second_difference(clip));
}

}  // namespace
}  // namespace mien::motion
