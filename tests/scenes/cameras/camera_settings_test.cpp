#include <cmath>

#include <gtest/gtest.h>

#include "scenes/cameras/camera_path.h"
#include "scenes/cameras/camera_rig.h"
#include "scenes/walking_clip.h"

namespace mien::scenes {
namespace {

using motion::Vec3;

constexpr std::array<int, 2> size = {960, 540};

Action diagonal_walk(double metres_a_frame = 0.04) {
  return action_of(test::walking_clip(80, Vec3(0.6, 0.0, 0.8), metres_a_frame));
}

TEST(CameraSettings, AnOrthographicCameraKeepsTheWholeActionInThePicture) {
  const Action action = diagonal_walk();
  for (const char* view : {"front", "side", "three-quarter", "follow", "orbit"}) {
    CameraSettings settings{.view = view, .orthographic = true};
    const CameraRig rig = make_camera_rig(settings, action, size);
    EXPECT_GT(rig.at(0).parallel_height, 1.5f);
    for (std::size_t f = 0; f < action.points.size(); ++f) {
      for (const Vec3& point : action.points[f]) {
        const auto seen = render::project(rig.at(static_cast<int>(f)), point.cast<float>());
        ASSERT_TRUE(seen.has_value());
        EXPECT_GT(seen->x(), 0.03f * size[0]) << view;
        EXPECT_LT(seen->x(), 0.97f * size[0]) << view;
        EXPECT_GT(seen->y(), 0.03f * size[1]) << view;
        EXPECT_LT(seen->y(), 0.97f * size[1]) << view;
      }
    }
  }
}

TEST(CameraSettings, NumbersAreInTheFiguresAxes) {
  const Action action = diagonal_walk();
  CameraSettings settings;
  settings.position = Vec3(-3.0, 1.5, 4.0);
  settings.target = Vec3(0.0, 0.9, 0.0);
  settings.fov_degrees = 40.0;
  const render::Camera camera = make_camera_rig(settings, action, size).at(7);
  const Vec3 left = Vec3::UnitY().cross(action.forward);
  const Vec3 expected = action.centre - 3.0 * left + 1.5 * Vec3::UnitY() + 4.0 * action.forward;
  EXPECT_LT((camera.position.cast<double>() - expected).norm(), 1e-5);
  EXPECT_NEAR(camera.vertical_field_of_view, 40.0 * motion::radians_per_degree, 1e-6);
}

TEST(CameraSettings, OnTheScreenTheFigureIsAsLargeAsWasAskedFor) {
  const Action action = diagonal_walk(0.0);
  for (const char* view : {"front", "side", "three-quarter", "follow", "orbit"}) {
    CameraSettings settings{.view = view};
    settings.screen = ScreenSettings{57.0, 50.0, 8.0};
    const CameraRig rig = make_camera_rig(settings, action, size);
    EXPECT_NEAR(visual_degrees(rig), 8.0, 0.02) << view;
    // Centimetres on the screen, and the angle that an eye sees them under.
    const double pixels = figure_pixels(rig);
    const double on_screen = pixels * 50.0 / size[0];
    const double angle = 2.0 * std::atan(0.5 * on_screen / 57.0) / motion::radians_per_degree;
    EXPECT_NEAR(angle, 8.0, 0.05) << view;
    // Without degrees the picture of the figure is as tall as the figure.
    settings.screen->degrees.reset();
    const CameraRig natural = make_camera_rig(settings, action, size);
    EXPECT_NEAR(figure_pixels(natural) * 0.5 / size[0], action.height_m, 0.01) << view;
  }
}

TEST(CameraSettings, ShowsTheFigureInTheSizeAskedFor) {
  const Action action = diagonal_walk();
  for (const bool parallel : {false, true}) {
    for (const char* view : {"front", "side", "three-quarter", "follow", "orbit"}) {
      CameraSettings settings{.view = view, .orthographic = parallel};
      const Vec3 place = std::string(view) == "follow" ? action.points[0][0] : action.centre;
      settings.figure_px = 120.0;
      const CameraRig rig = make_camera_rig(settings, action, size);
      EXPECT_NEAR(figure_pixels(rig), 120.0, 0.01) << view;
      // A figure of that height, upright in the picture's plane, measured in the picture.
      const render::Camera& camera = rig.cameras.front();
      const render::CameraFrame frame = render::frame_of(camera);
      const render::Vec3 middle{static_cast<float>(place.x()),
                                static_cast<float>(0.5 * action.height_m),
                                static_cast<float>(place.z())};
      const render::Vec3 half =
          static_cast<float>(0.5 * action.height_m) * frame.step_down.normalized();
      const auto top = render::project(camera, middle - half);
      const auto bottom = render::project(camera, middle + half);
      ASSERT_TRUE(top && bottom) << view;
      EXPECT_NEAR(bottom->y() - top->y(), 120.0, 1.0) << view;
    }
  }
}

TEST(CameraSettings, TheFocusGoesWithTheFigureUnlessItIsGiven) {
  const Action action = diagonal_walk();
  CameraSettings settings{.view = "front"};
  EXPECT_EQ(make_camera_rig(settings, action, size).cameras[0].aperture_radius, 0.0f);
  settings.depth_of_field = DepthOfField{.aperture_m = 0.08};
  const CameraRig rig = make_camera_rig(settings, action, size);
  ASSERT_EQ(rig.cameras.size(), action.points.size());
  EXPECT_FLOAT_EQ(rig.cameras[0].aperture_radius, 0.04f);
  // The figure comes nearer by 79 steps of 4 cm, seen from 6 degrees above.
  const float nearer = rig.cameras.front().focus_distance - rig.cameras.back().focus_distance;
  EXPECT_NEAR(nearer, 79 * 0.04f * std::cos(0.105f), 0.01f);
  EXPECT_EQ(rig.cameras.front().position, rig.cameras.back().position);
  settings.depth_of_field->focus_m = 2.5;
  const CameraRig fixed = make_camera_rig(settings, action, size);
  ASSERT_EQ(fixed.cameras.size(), 1u);
  EXPECT_FLOAT_EQ(fixed.cameras[0].focus_distance, 2.5f);
}

TEST(CameraSettings, APathGoesThroughItsKeysWithoutJerks) {
  const std::vector<CameraKey> path = {{0.0, {0, 1, 5}, {0, 1, 0}},
                                       {1.0, {2, 1, 4}, {0, 1, 0}},
                                       {3.0, {4, 2, 0}, {0, 1, 1}},
                                       {3.5, {4, 2, -3}, {0, 1, 0}}};
  for (const CameraKey& key : path) {
    EXPECT_LT((camera_on_path(path, key.seconds).position - key.position).norm(), 1e-12);
    EXPECT_LT((camera_on_path(path, key.seconds).target - key.target).norm(), 1e-12);
    // The speed is the same on both sides of a key.
    if (key.seconds == 0.0 || key.seconds == 3.5) continue;
    const double h = 1e-5;
    const auto at = [&](double t) { return camera_on_path(path, t).position; };
    const Vec3 before = (at(key.seconds) - at(key.seconds - h)) / h;
    const Vec3 after = (at(key.seconds + h) - at(key.seconds)) / h;
    EXPECT_LT((after - before).norm(), 1e-3);
  }
  EXPECT_EQ(camera_on_path(path, -1.0).position, path.front().position);
  EXPECT_EQ(camera_on_path(path, 9.0).position, path.back().position);
}

TEST(Stereo, WhatIsAtTheDistanceOfConvergenceIsAtTheSamePlaceInBothPictures) {
  render::Camera camera;
  camera.position = {1.0f, 1.5f, 5.0f};
  camera.target = {0.0f, 1.0f, 0.0f};
  const auto [left, right] = stereo_pair(camera, 0.063, 5.0);
  const render::CameraFrame frame = render::frame_of(camera);
  const auto disparity = [&](float depth, float aside) {
    const render::Vec3 point = frame.position + depth * (frame.forward + aside * frame.step_right);
    return render::project(left, point)->x() - render::project(right, point)->x();
  };
  for (const float aside : {-300.0f, 0.0f, 200.0f}) {
    EXPECT_NEAR(disparity(5.0f, aside), 0.0f, 0.01f);
    // Crossed before it, by the difference of the two eyes' angles; uncrossed behind it.
    const double pixel = static_cast<double>(frame.step_right.norm());
    const double expected = 0.063 / pixel * (1.0 / 2.0 - 1.0 / 5.0);
    EXPECT_NEAR(disparity(2.0f, aside), expected, 0.02);
    EXPECT_LT(disparity(9.0f, aside), -1.0f);
  }
}

TEST(Stereo, EachEyeHasHalfOfThePicture) {
  CameraSettings settings;
  settings.stereo_separation_m = 0.063;
  const CameraRig rig = make_camera_rig(settings, diagonal_walk(), size);
  EXPECT_EQ(rig.at(0).width, 480);
  EXPECT_EQ(rig.at(0).height, 540);
  EXPECT_EQ(rig.stereo_separation_m, 0.063);
}

}  // namespace
}  // namespace mien::scenes
