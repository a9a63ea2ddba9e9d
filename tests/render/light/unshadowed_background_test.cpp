#include "render/light/unshadowed_background.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "render/light/one_by_one.h"

namespace mien::render {
namespace {

Scene lined_floor(bool with_major_lines) {
  Scene scene;
  scene.ground.albedo = {0.5f, 0.4f, 0.3f};
  scene.ground.line_spacing = 0.7f;
  scene.ground.line_width = 0.03f;
  scene.ground.offset_x = 0.21f;
  scene.ground.offset_z = -0.13f;
  if (with_major_lines) {
    scene.ground.major_every = 3;
    scene.ground.major_albedo = {0.1f, 0.2f, 0.8f};
  }
  scene.ground.fade_start = 4.0f;
  scene.ground.fade_end = 9.0f;
  scene.sky = {{0.9f, 0.8f, 1.0f},
               {0.4f, 0.5f, 0.6f},
               Color::Zero(),
               {0.2f, 0.3f, 0.4f},
               {0.7f, 0.6f, 0.5f}};
  scene.lights = {softbox({2.0f, 3.0f, 1.0f}, Vec3::UnitY(), 1.5f, 0.8f, {6.0f, 5.0f, 4.0f}),
                  softbox({-1.0f, 0.4f, 1.0f}, Vec3::Zero(), 1.0f, 2.0f, {1.0f, 2.0f, 3.0f})};
  return scene;
}

/// The ray through the centre of a pixel, in every lane.
LaneRays through(const CameraFrame& camera, int x, int y) {
  const CameraRay ray = camera.ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
  return {test::in_all_lanes(ray.origin), test::in_all_lanes(ray.direction)};
}

/// Compares all pixels with what background_pixel shows of their middles; how many show the floor.
int compared(const Scene& scene, const Camera& camera) {
  const CameraFrame frame = frame_of(camera);
  const UnshadowedBackground open(scene, frame);
  int floor = 0;
  for (int y = 0; y < camera.height; ++y) {
    const UnshadowedRow row(open, y, camera.width);
    for (int x = 0; x < camera.width; ++x) {
      const LaneBackground found = row.pixels(x / 8 * 8);
      const int i = x % 8;
      const test::BackgroundPixel expected = test::background_pixel(
          scene, frame, frame.ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f));
      const Color radiance = found.radiance.at(i), albedo = found.visible_albedo.at(i);
      const LaneBackground alone = open.along(through(frame, x, y));
      EXPECT_TRUE(alone.radiance.at(5).isApprox(radiance, 2e-4f)) << x << ' ' << y;
      EXPECT_LT((alone.visible_albedo.at(5) - albedo).abs().maxCoeff(), 2e-4f);
      EXPECT_TRUE(radiance.isApprox(expected.radiance, 2e-4f)) << x << ' ' << y;
      EXPECT_LT((albedo - expected.visible_albedo).abs().maxCoeff(), 2e-4f) << x << ' ' << y;
      // Where the floor has all but faded rounding decides.
      if (expected.visible_albedo.sum() < 1e-5f) continue;
      EXPECT_GT(found.share[i], 0.0f);
      EXPECT_LT((found.point.at(i) - expected.point).norm(), 1e-6f + 1e-5f * expected.point.norm());
      ++floor;
    }
  }
  return floor;
}

TEST(UnshadowedBackground, ShowsEightPixelsAsOneByOne) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> share(-1.0f, 1.0f);
  int floor = 0;
  constexpr int trials = 24, width = 45, height = 30;
  for (int k = 0; k < trials; ++k) {
    Scene scene = lined_floor(k % 2 == 0);
    if (k % 5 == 4) scene.ground.line_spacing = 0.0f;
    Camera camera{.position = {3.0f * share(random), 1.6f + share(random), 3.0f * share(random)},
                  .target = {share(random), 0.4f * share(random), share(random)},
                  .up = {0.3f * share(random), 1.0f, 0.0f},
                  .vertical_field_of_view = 0.9f,
                  .shift_x = 3.0f * share(random),
                  .width = width,
                  .height = height};
    if (k % 3 == 2) camera.parallel_height = 2.5f;
    floor += compared(scene, camera);
  }
  EXPECT_GT(floor, trials * width * height / 4);
  EXPECT_LT(floor, trials * width * height);
}

// As with an aperture or a moving camera: each ray starts elsewhere.
TEST(UnshadowedBackground, ShowsWhatEachOfEightRaysMeets) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> share(-1.0f, 1.0f);
  const Scene scene = lined_floor(true);
  const CameraFrame camera = frame_of({.position = {0.5f, 1.5f, 3.0f}, .target = Vec3::Zero()});
  const UnshadowedBackground background(scene, camera);
  int floor = 0;
  for (int trial = 0; trial < 100; ++trial) {
    LaneRays rays;
    for (int i = 0; i < 8; ++i) {
      rays.origin.set(i,
                      camera.position + 0.2f * Vec3{share(random), share(random), share(random)});
      rays.direction.set(
          i,
          (camera.forward + 0.4f * Vec3{share(random), share(random), share(random)}).normalized());
    }
    const LaneBackground found = background.along(rays);
    for (int i = 0; i < 8; ++i) {
      const test::BackgroundPixel expected =
          test::background_pixel(scene, camera, {rays.origin.at(i), rays.direction.at(i)});
      EXPECT_TRUE(found.radiance.at(i).isApprox(expected.radiance, 2e-4f)) << trial << ' ' << i;
      EXPECT_LT((found.visible_albedo.at(i) - expected.visible_albedo).abs().maxCoeff(), 2e-4f);
      floor += expected.shows_floor ? 1 : 0;
    }
  }
  EXPECT_GT(floor, 200);
  EXPECT_LT(floor, 800);
}

TEST(UnshadowedBackground, ShowsTheBackdropAloneWithoutGroundAndFromBelow) {
  Scene scene = lined_floor(false);
  const Camera below{
      .position = {0.0f, -0.5f, 2.0f}, .target = Vec3::Zero(), .width = 24, .height = 16};
  EXPECT_EQ(compared(scene, below), 0);
  scene.has_ground = false;
  const Camera above{
      .position = {0.0f, 1.5f, 2.0f}, .target = Vec3::Zero(), .width = 24, .height = 16};
  EXPECT_EQ(compared(scene, above), 0);
}

// Near a camera that stands upright, where lights are interpolated: also of a light that shines
// aside and ends on this floor, and of one too low for that.
TEST(UnshadowedBackground, InterpolatesLightsAlongRows) {
  Scene scene = lined_floor(false);
  scene.ground.line_spacing = 0.0f;
  scene.sky.horizon = scene.sky.zenith = Color::Zero();
  const std::vector<AreaLight> lights = {
      softbox({2.0f, 3.0f, 1.0f}, Vec3::UnitY(), 1.5f, 0.8f, Color::Constant(6.0f)),
      softbox({0.3f, 2.5f, 0.5f}, {3.0f, 2.5f, 0.5f}, 1.0f, 0.5f, Color::Constant(8.0f)),
      softbox({0.2f, 0.15f, 0.0f}, {0.2f, 0.0f, 0.0f}, 0.2f, 0.2f, Color::Constant(9.0f))};
  const Camera camera{
      .position = {0.2f, 1.6f, 3.0f}, .target = {0.0f, 0.3f, 0.0f}, .width = 301, .height = 120};
  const CameraFrame frame = frame_of(camera);
  for (const AreaLight& light : lights) {
    scene.lights = {light};
    const UnshadowedBackground open(scene, frame);
    float largest = 0.0f, brightest = 0.0f;
    for (int y = 0; y < camera.height; ++y) {
      const UnshadowedRow row(open, y, camera.width);
      for (int x = 0; x < camera.width; x += 8) {
        const LaneBackground found = row.pixels(x);
        for (int i = 0; i < 8 && x + i < camera.width; ++i) {
          if (found.share[i] < 1.0f) continue;
          const float expected = test::unshadowed_floor(scene, found.point.at(i)).x();
          largest = std::max(largest, std::abs(found.radiance.red[i] - expected));
          brightest = std::max(brightest, expected);
        }
      }
    }
    EXPECT_GT(brightest, 0.01f);
    EXPECT_LT(largest, 2e-5f * brightest);
  }
}

}  // namespace
}  // namespace mien::render
