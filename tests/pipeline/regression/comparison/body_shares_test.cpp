#include "pipeline/regression/comparison/body_shares.h"

#include <gtest/gtest.h>

#include "motion/skeleton/body.h"

namespace mien::pipeline {
namespace {

using motion::Clip;

Clip standing() {
  Clip clip;
  clip.body = motion::standard_body();
  motion::Pose pose;
  pose.rotations.assign(clip.body.joints.size(), motion::Quat::Identity());
  pose.root_position = {0.0, 1.0, 0.0};
  clip.poses = {pose};
  return clip;
}

render::Camera in_front() {
  render::Camera camera;
  camera.position = {0.0f, 1.0f, 4.0f};
  camera.target = {0.0f, 1.0f, 0.0f};
  camera.width = 200;
  camera.height = 150;
  return camera;
}

/// Where the middle of a bone is in the picture.
Eigen::Vector2f middle_of(const Clip& clip, motion::BodyJoint from, motion::BodyJoint to) {
  const auto places = motion::world_positions(clip.body, clip.poses[0]);
  return *render::project(in_front(), ((places[from] + places[to]) / 2.0).cast<float>());
}

class BodyShares : public testing::Test {
 protected:
  void change(const Eigen::Vector2f& place, std::uint8_t by) {
    now_.at(static_cast<int>(place.x()), static_cast<int>(place.y()))[0] += by;
  }
  std::vector<BodyShare> shares(const Clip& before, const Clip& now,
                                const render::Camera& camera_now = in_front()) const {
    const render::Camera camera = in_front();
    return body_shares(before_, now_, {before, 0, camera}, {now, 0, camera_now});
  }

  render::Image8 before_{200, 150};
  render::Image8 now_{200, 150};
};

TEST_F(BodyShares, OfTheSamePictureAreNone) { EXPECT_TRUE(shares(standing(), standing()).empty()); }

TEST_F(BodyShares, AreThoseOfWhatMovedNearby) {
  Clip raised = standing();
  raised.poses[0].rotations[motion::LeftElbow] =
      motion::Quat(Eigen::AngleAxisd(0.5, motion::Vec3::UnitZ()));
  change(middle_of(standing(), motion::LeftElbow, motion::LeftWrist), 30);
  change(middle_of(standing(), motion::RightKnee, motion::RightAnkle), 10);  // nothing moved there
  const std::vector<BodyShare> found = shares(standing(), raised);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].part, "left forearm");
  EXPECT_NEAR(found[0].share, 0.9, 1e-12);
  EXPECT_GT(found[0].moved_px, 2.0);
  EXPECT_EQ(found[1].part, "");
  EXPECT_NEAR(found[1].share, 0.1, 1e-12);
}

TEST_F(BodyShares, KnowATwistThatMovesNoJoint) {
  Clip twisted = standing();
  twisted.poses[0].rotations[motion::LeftElbow] =
      motion::Quat(Eigen::AngleAxisd(0.5, motion::Vec3::UnitX()));  // along the arm
  change(middle_of(standing(), motion::LeftElbow, motion::LeftWrist), 30);
  const std::vector<BodyShare> found = shares(standing(), twisted);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].part, "left forearm");
}

/// A head that bends moves the box of the body, and the camera with it.
TEST_F(BodyShares, AreNotThoseOfWhatShiftsWithTheCamera) {
  Clip bent = standing();
  bent.poses[0].rotations[motion::Neck] =
      motion::Quat(Eigen::AngleAxisd(0.3, motion::Vec3::UnitZ()));
  render::Camera farther = in_front();
  farther.position.z() += 0.05f;
  change(middle_of(standing(), motion::LeftElbow, motion::LeftWrist), 10);
  change(middle_of(standing(), motion::Neck, motion::Head), 30);
  const std::vector<BodyShare> found = shares(standing(), bent, farther);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].part, "neck");
  EXPECT_EQ(found[1].part, "");
  EXPECT_NEAR(found[1].share, 0.1, 1e-12);
}

TEST_F(BodyShares, LeaveUnexplainedWhatChangesThoughNothingMoved) {
  change(middle_of(standing(), motion::LeftElbow, motion::LeftWrist), 30);
  const std::vector<BodyShare> found = shares(standing(), standing());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].part, "");
  EXPECT_EQ(found[0].share, 1.0);
}

}  // namespace
}  // namespace mien::pipeline
