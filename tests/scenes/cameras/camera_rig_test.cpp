#include "scenes/cameras/camera_rig.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "scenes/cameras/figure_place.h"

namespace mien::scenes {
namespace {

/// A body that walks in a direction for `seconds`, arms moving a little.
motion::Clip walk(const motion::Vec3& direction, int frames) {
  motion::Clip clip;
  clip.body = motion::standard_body();
  const motion::Quat facing = motion::turn_between(motion::Vec3::UnitZ(), direction);
  for (int f = 0; f < frames; ++f) {
    motion::Pose pose;
    pose.rotations.assign(motion::body_joint_count, motion::Quat::Identity());
    pose.rotations[motion::Pelvis] = facing;
    pose.rotations[motion::LeftShoulder] =
        motion::Quat(Eigen::AngleAxisd(std::sin(f * 0.2), motion::Vec3::UnitZ()));
    pose.root_position = motion::Vec3(0.4, 0.95, -0.7) + f * 0.04 * direction;
    clip.poses.push_back(pose);
  }
  return clip;
}

class EveryCamera : public testing::TestWithParam<std::string> {};

TEST_P(EveryCamera, KeepsTheWholeActionInThePicture) {
  for (const std::array<int, 2> size : {std::array{960, 540}, std::array{400, 600}}) {
    for (const motion::Vec3& direction :
         {motion::Vec3(0, 0, 1), motion::Vec3(-0.6, 0, 0.8), motion::Vec3(0, 0, -1)}) {
      const Action action = action_of(walk(direction, 80));
      const CameraRig rig = make_camera_rig({GetParam()}, action, size);
      for (size_t f = 0; f < action.points.size(); ++f) {
        for (const motion::Vec3& point : action.points[f]) {
          const auto seen = render::project(rig.at(static_cast<int>(f)), point.cast<float>());
          ASSERT_TRUE(seen.has_value());
          EXPECT_GT(seen->x(), 0.03f * size[0]);
          EXPECT_LT(seen->x(), 0.97f * size[0]);
          EXPECT_GT(seen->y(), 0.03f * size[1]);
          EXPECT_LT(seen->y(), 0.97f * size[1]);
        }
      }
    }
  }
}

TEST_P(EveryCamera, FramesAPartOfTheBodyAsLargeAsItCan) {
  const motion::Clip clip = walk({-0.6, 0, 0.8}, 4);  // hardly moves
  const std::array<int, 2> size{960, 540};
  double whole = 0.0;
  for (const CameraSubject subject :
       {CameraSubject::whole_body, CameraSubject::upper_body, CameraSubject::head}) {
    Action action = action_of(clip);
    action.framed = subject_points(clip, subject);
    const CameraRig rig = make_camera_rig({GetParam()}, action, size);
    const auto& framed = action.framed.empty() ? action.points : action.framed;
    ASSERT_EQ(framed.size(), clip.poses.size());
    bool is_foot_outside = false;
    for (size_t f = 0; f < framed.size(); ++f) {
      const auto frame = static_cast<int>(f);
      for (const motion::Vec3& point : framed[f]) {
        const auto seen = render::project(rig.at(frame), point.cast<float>());
        ASSERT_TRUE(seen.has_value());
        EXPECT_GT(seen->x(), 0.03f * size[0]);
        EXPECT_LT(seen->x(), 0.97f * size[0]);
        EXPECT_GT(seen->y(), 0.03f * size[1]);
        EXPECT_LT(seen->y(), 0.97f * size[1]);
      }
      const auto foot =
          render::project(rig.at(frame), action.points[f][motion::LeftAnkle].cast<float>());
      is_foot_outside = is_foot_outside || !foot || foot->y() > size[1];
    }
    const double now = figure_pixels(rig);
    if (subject == CameraSubject::whole_body) {
      whole = now;
      EXPECT_FALSE(is_foot_outside);
    } else {
      EXPECT_GT(now, subject == CameraSubject::head ? 3.0 * whole : 1.4 * whole);
      EXPECT_TRUE(is_foot_outside);
    }
  }
}

TEST_P(EveryCamera, ShowsTheFigureWhereItIsToldAndAllElseShiftedLikewise) {
  const Action action = action_of(walk({-0.6, 0, 0.8}, 80));
  const CameraRig as_framed = make_camera_rig({GetParam()}, action, {400, 600});
  CameraRig moved = as_framed;
  place_figure_at(moved, {-12.5, 150.25});
  const auto place = figure_place(moved);
  ASSERT_TRUE(place.has_value());
  EXPECT_NEAR((*place)[0], -12.5, 1e-3);
  EXPECT_NEAR((*place)[1], 150.25, 1e-3);
  const auto before = figure_place(as_framed);
  const Eigen::Vector2d shift(-12.5 - (*before)[0], 150.25 - (*before)[1]);
  const Eigen::AlignedBox2d part = action_bounds(as_framed, action);
  const Eigen::AlignedBox2d moved_part = action_bounds(moved, action);
  EXPECT_LT((moved_part.min() - part.min() - shift).norm(), 1e-2);
  EXPECT_LT((moved_part.max() - part.max() - shift).norm(), 1e-2);
  EXPECT_EQ(figure_pixels(moved), figure_pixels(as_framed));
}

INSTANTIATE_TEST_SUITE_P(CameraRig, EveryCamera, testing::ValuesIn(camera_names()),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(CameraRig, SeenFromTheSideTheFigureWalksFromLeftToRight) {
  for (const motion::Vec3& direction : {motion::Vec3(0, 0, 1), motion::Vec3(0.8, 0, -0.6)}) {
    const Action action = action_of(walk(direction, 60));
    const CameraRig rig = make_camera_rig({"side"}, action, {960, 540});
    const auto start = render::project(rig.at(0), action.points.front()[0].cast<float>());
    const auto end = render::project(rig.at(0), action.points.back()[0].cast<float>());
    EXPECT_GT(end->x() - start->x(), 300.0f);
    EXPECT_NEAR(end->y(), start->y(), 25.0f);
  }
}

TEST(CameraRig, TheFrontCameraSeesTheFaceAndTheFigureComesNearer) {
  const Action action = action_of(walk(motion::Vec3::UnitZ(), 60));
  const CameraRig rig = make_camera_rig({"front"}, action, {960, 540});
  EXPECT_GT(rig.at(0).position.z(), action.points.back()[0].z());
  const auto left = render::project(rig.at(0), action.points[0][motion::LeftHip].cast<float>());
  const auto right = render::project(rig.at(0), action.points[0][motion::RightHip].cast<float>());
  EXPECT_GT(left->x(), right->x());  // the figure's left hand is at the right of the picture
}

TEST(CameraRig, TheFollowingCameraKeepsTheFigureInItsPlace) {
  const Action action = action_of(walk(motion::Vec3::UnitZ(), 90));
  const CameraRig rig = make_camera_rig({"follow"}, action, {960, 540});
  const auto first = render::project(rig.at(20), action.points[20][0].cast<float>());
  const auto last = render::project(rig.at(70), action.points[70][0].cast<float>());
  EXPECT_LT((*first - *last).norm(), 2.0f);
}

TEST(CameraRig, RefusesAnUnknownCamera) {
  const Action action = action_of(walk(motion::Vec3::UnitZ(), 10));
  EXPECT_THROW(make_camera_rig({"above"}, action, {960, 540}), Error);
}

}  // namespace
}  // namespace mien::scenes
