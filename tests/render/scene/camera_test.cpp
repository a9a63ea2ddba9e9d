#include "render/scene/camera.h"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

TEST(Camera, SeesItsTargetInTheMiddle) {
  const Camera camera{.position = {3.0f, 2.0f, -4.0f}, .target = {0.2f, 0.9f, 0.1f}};
  const auto framebuffer = project(camera, camera.target);
  ASSERT_TRUE(framebuffer);
  EXPECT_NEAR(framebuffer->x(), 480.0f, 1e-3f);
  EXPECT_NEAR(framebuffer->y(), 270.0f, 1e-3f);
}

TEST(Camera, SeesHalfItsFieldOfViewAboveTheAxis) {
  Camera camera{.position = {0.0f, 1.0f, 5.0f}, .target = {0.0f, 1.0f, 0.0f}};
  camera.vertical_field_of_view = std::numbers::pi_v<float> / 2.0f;  // as far up as away
  const auto top = project(camera, {0.0f, 6.0f, 0.0f});
  const auto right = project(camera, {5.0f, 1.0f, 0.0f});
  ASSERT_TRUE(top && right);
  EXPECT_NEAR(top->y(), 0.0f, 1e-3f);
  EXPECT_NEAR(right->x(), 480.0f + 270.0f, 1e-3f);  // square pixels
}

TEST(Camera, LooksThroughTheFilmPointOfWhatItSees) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> place(-3.0f, 3.0f), along(0.0f, 1.0f);
  for (int trial = 0; trial < 200; ++trial) {
    const Camera camera{.position = {place(random), place(random) + 8.0f, place(random)},
                        .target = {place(random), place(random), place(random)},
                        .vertical_field_of_view = 0.1f + 2.0f * along(random)};
    const CameraFrame frame = frame_of(camera);
    const Eigen::Vector2f framebuffer{960.0f * along(random), 540.0f * along(random)};
    const float distance = 0.5f + 9.0f * along(random);
    const Vec3 point =
        frame.position + distance * frame.ray(framebuffer.x(), framebuffer.y()).direction;
    const auto seen = project(camera, point);
    ASSERT_TRUE(seen);
    EXPECT_LT((*seen - framebuffer).norm(), 0.02f) << "trial " << trial;
  }
}

TEST(Camera, DoesNotSeeWhatIsBehindIt) {
  EXPECT_FALSE(project(Camera{}, {0.0f, 1.0f, 5.1f}));
  EXPECT_TRUE(project(Camera{}, {0.0f, 1.0f, 4.9f}));
}

TEST(Camera, IsRefusedWhenItsAxesAreUndefined) {
  EXPECT_THROW(frame_of({.width = 0}), std::invalid_argument);
  EXPECT_THROW(frame_of({.target = {0.0f, 1.0f, 5.0f}}), std::invalid_argument);
  EXPECT_THROW(frame_of({.up = Vec3::UnitZ()}), std::invalid_argument);
  EXPECT_THROW(frame_of({.vertical_field_of_view = 0.0f}), std::invalid_argument);
  EXPECT_THROW(frame_of({.vertical_field_of_view = 3.2f}), std::invalid_argument);
  EXPECT_THROW(frame_of({.position = {NAN, 1.0f, 5.0f}}), std::invalid_argument);
}

TEST(View, HoldsWhatFallsOnTheFilmAndNothingElse) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> uniform(-6.0f, 6.0f);
  for (const float parallel : {0.0f, 3.0f}) {
    const Camera camera{.position = {1.0f, 2.0f, 4.0f},
                        .target = {0.2f, 1.0f, 0.1f},
                        .vertical_field_of_view = 0.8f,
                        .parallel_height = parallel,
                        .shift_x = 40.0f};
    const auto view = view_of(frame_of(camera), camera.width, camera.height, 0.0f);
    int inside = 0;
    for (int trial = 0; trial < 5000; ++trial) {
      const Vec3 point{uniform(random), uniform(random), uniform(random)};
      const auto framebuffer = project(camera, point);
      if (!framebuffer) continue;
      const auto margin = [](float x, float size) { return std::min(x, size - x); };
      const float within =
          std::min(margin(framebuffer->x(), 960.0f), margin(framebuffer->y(), 540.0f));
      if (std::abs(within) < 0.01f) continue;
      bool holds = true;
      for (const HalfSpace& half : view) holds = holds && half.normal.dot(point) >= half.offset;
      EXPECT_EQ(holds, within > 0.0f);
      inside += holds ? 1 : 0;
    }
    EXPECT_GT(inside, 100);
  }
}

}  // namespace
}  // namespace mien::render
