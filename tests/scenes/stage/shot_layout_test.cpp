// Several motions on one stage.

#include <vector>

#include <gtest/gtest.h>

#include "motion/skeleton/recorded_hands.h"
#include "scenes/stage/shot.h"
#include "scenes/walking_clip.h"

namespace mien::scenes {
namespace {

using motion::Vec3;

/// Two people who walk towards each other, `apart` metres from each other at the start.
std::vector<Performance> two_people(double apart, const Vec3& from) {
  motion::Clip first = test::walking_clip(31, Vec3::UnitZ(), 0.04);
  motion::Clip second = test::walking_clip(21, -Vec3::UnitZ(), 0.04);
  for (motion::Pose& pose : first.poses) pose.root_position += from;
  for (motion::Pose& pose : second.poses) pose.root_position += from + apart * Vec3::UnitZ();
  return {{.name = "a", .clip = first}, {.name = "b", .clip = second}};
}

Shot staged(const std::vector<Performance>& people, Layout layout) {
  Look look;
  look.layout = layout;
  return stage(people, look);
}

const Vec3& start_of(const Actor& actor) { return actor.clip.poses.front().root_position; }

TEST(ShotLayout, AsRecordedKeepsPlacesAndHeadings) {
  const std::vector<Performance> people = two_people(3.0, Vec3::Zero());
  const Shot shot = staged(people, Layout::as_recorded);
  for (std::size_t i = 0; i < people.size(); ++i) {
    const auto& poses = shot.actors[i].clip.poses;
    ASSERT_EQ(poses.size(), people[i].clip.poses.size());
    for (std::size_t f = 0; f < poses.size(); ++f) {
      EXPECT_EQ(poses[f].root_position, people[i].clip.poses[f].root_position);
      EXPECT_EQ(poses[f].rotations.front().coeffs(),
                people[i].clip.poses[f].rotations.front().coeffs());
    }
  }
  EXPECT_EQ(shot.frame_count(), 31);
}

// Far from the origin, all are moved alike.
TEST(ShotLayout, AsRecordedKeepsDistancesAnywhere) {
  const Shot shot = staged(two_people(3.0, {2000.0, 0.0, -500.0}), Layout::as_recorded);
  EXPECT_LT(start_of(shot.actors[0]).norm(), 10.0);
  EXPECT_LT((start_of(shot.actors[1]) - start_of(shot.actors[0]) - 3.0 * Vec3::UnitZ()).norm(),
            1e-9);
}

TEST(ShotLayout, GivesEachPersonHandsOfTheirOwn) {
  std::vector<Performance> people = two_people(3.0, Vec3::Zero());
  people[1].hands = Hands::drawn;
  Look look;
  look.layout = Layout::as_recorded;
  const Shot one = stage(people, look);
  EXPECT_FALSE(has_fingers(one.actors[0].clip));
  EXPECT_TRUE(has_fingers(one.actors[1].clip));
  EXPECT_TRUE(one.actors[0].warnings.empty());
  EXPECT_EQ(one.actors[1].warnings.size(), 1u);
  look.hands = Hands::drawn;
  people[1].hands = Hands::hidden;
  const Shot other = stage(people, look);
  EXPECT_TRUE(has_fingers(other.actors[0].clip));
  EXPECT_FALSE(has_fingers(other.actors[1].clip));
}

TEST(ShotLayout, SuperimposedBeginsInOnePlace) {
  const Shot shot = staged(two_people(3.0, Vec3::Zero()), Layout::superimposed);
  Vec3 between = start_of(shot.actors[1]) - start_of(shot.actors[0]);
  between.y() = 0.0;
  EXPECT_LT(between.norm(), 1e-9);
}

TEST(ShotLayout, OfAllPutsEveryoneIntoThePicture) {
  for (const Layout layout : {Layout::superimposed, Layout::side_by_side, Layout::as_recorded}) {
    const Shot shot = staged(two_people(3.0, Vec3::Zero()), layout);
    for (const Actor& actor : shot.actors) {
      for (int f = 0; f < actor.clip.frame_count(); ++f) {
        const render::Camera& camera = camera_at(shot, f);
        const render::CameraFrame frame = render::frame_of(camera);
        const Eigen::Vector3f place =
            actor.clip.poses[static_cast<std::size_t>(f)].root_position.cast<float>() -
            camera.position;
        const float depth = place.dot(frame.forward);
        ASSERT_GT(depth, 0.0f);
        // `step_right` and `step_down` are one pixel at distance 1.
        EXPECT_LT(std::abs(place.dot(frame.step_right.normalized())) / depth,
                  0.5f * static_cast<float>(camera.width) * frame.step_right.norm());
        EXPECT_LT(std::abs(place.dot(frame.step_down.normalized())) / depth,
                  0.5f * static_cast<float>(camera.height) * frame.step_down.norm());
      }
    }
  }
}

}  // namespace
}  // namespace mien::scenes
