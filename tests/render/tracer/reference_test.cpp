// The reference against values in closed form: it shares no arithmetic with them.

#include "render/tracer/reference.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "render/patch.h"

namespace mien::render {
namespace {

using test::camera_on;
using test::even_sky;
using test::expect_mean;
using test::radiance_at;

Quality reference_of(int samples) {
  Quality quality = reference_quality();
  quality.samples_per_pixel = samples;
  return quality;
}

Scene ball_on_floor() {
  Scene scene;
  scene.materials = {{.albedo = Color::Constant(0.6f)}};
  scene.ground.albedo = Color::Constant(0.5f);
  scene.ground.line_spacing = 0.0f;
  scene.sky = even_sky(Color::Constant(1.0f));
  return scene;
}

// In a furnace all directions bring the same light, whatever of them the sphere itself hides.
TEST(ReferenceRenderer, ShowsASphereInAFurnaceAsItsAlbedo) {
  Scene scene = ball_on_floor();
  scene.has_ground = false;
  scene.solids.spheres = {{.centre = {0.0f, 1.0f, 0.0f}, .radius = 1.0f}};
  const Camera camera = camera_on({0.0f, 2.0f, 0.0f}, {0.0f, 3.0f, 0.0f});
  const Framebuffer picture = Tracer().trace(scene, camera, reference_of(4));
  for (const float channel : picture.channels) EXPECT_NEAR(channel, 0.6f, 1e-6f);
}

// A sphere wholly above the horizon hides (R/d)² cos θ of an even sky.
TEST(ReferenceRenderer, BesideASphereLacksTheSpheresFormFactor) {
  Scene scene = ball_on_floor();
  scene.solids.spheres = {{.centre = {0.0f, 0.6f, 0.0f}, .radius = 0.6f}};
  for (const float x : {0.3f, 1.0f, 2.0f}) {
    SCOPED_TRACE(x);
    const double hidden = std::pow(0.6 / std::hypot(static_cast<double>(x), 0.6), 3);
    expect_mean(
        radiance_at(scene, camera_on({x, 0.0f, 0.0f}, {4.0f, 3.0f, 0.0f}), reference_of(16), 16),
        0.5 * (1.0 - hidden), 0.002, 1e-5);
  }
}

// The form factor of a square right above a surface element (Howell B-3, four corners).
TEST(ReferenceRenderer, LightsFloorAndSphereFromARectangle) {
  Scene scene = ball_on_floor();
  scene.sky = even_sky(Color::Zero());
  scene.lights = {{.centre = {0.0f, 4.0f, 0.0f}, .radiance = Color::Constant(7.0f)}};
  const auto expected = [](double distance, double albedo) {
    const double x = 0.5 / distance, p = std::sqrt(1.0 + x * x);
    return albedo * 7.0 * 8.0 * (x / p) * std::atan(x / p) / (2.0 * std::numbers::pi);
  };
  const double on_floor = expected(4.0, 0.5);
  expect_mean(radiance_at(scene, camera_on(Vec3::Zero(), {4.0f, 3.0f, 0.0f}), reference_of(16), 4),
              on_floor, 1e-3 * on_floor, 1e-4 * on_floor);
  scene.solids.spheres = {{.centre = {0.0f, 1.0f, 0.0f}, .radius = 1.0f}};
  const double on_top = expected(2.0, 0.6);
  expect_mean(
      radiance_at(scene, camera_on({0.0f, 2.0f, 0.0f}, {0.0f, 3.0f, 0.0f}), reference_of(16), 4),
      on_top, 1e-3 * on_top, 3e-4 * on_top);
}

TEST(ReferenceRenderer, GivesTheSameBytesWithAnyNumberOfThreads) {
  Scene scene = ball_on_floor();
  scene.solids.spheres = {{.centre = {0.0f, 0.6f, 0.0f}, .radius = 0.6f}};
  const Camera camera{.position = {2.0f, 1.5f, 3.0f}, .width = 70, .height = 50};
  const Framebuffer one = Tracer({.threads = 1}).trace(scene, camera, reference_of(3));
  EXPECT_EQ(Tracer({.threads = 3}).trace(scene, camera, reference_of(3)), one);
}

// What a ball hides of the light is the alpha of its shadow; the ball itself is opaque.
TEST(ReferenceRenderer, LeavesAShadowAsAlpha) {
  Scene scene = ball_on_floor();
  scene.solids.spheres = {{.centre = {0.0f, 0.6f, 0.0f}, .radius = 0.6f}};
  View view{scene, camera_on({1.0f, 0.0f, 0.0f}, {4.0f, 3.0f, 0.0f}), reference_of(64), {}, {}};
  view.quality.background = Background::shadow;
  const RenderTarget shadow = Tracer().render_view(view);
  test::SampleMean alpha;
  for (const float a : shadow.alpha) alpha.add(static_cast<double>(a));
  expect_mean(alpha, std::pow(0.6 / std::hypot(1.0, 0.6), 3), 0.002, 1e-4);
  view.camera = camera_on({0.0f, 1.2f, 0.0f}, {0.0f, 3.0f, 0.0f});
  for (const float a : Tracer().render_view(view).alpha) EXPECT_EQ(a, 1.0f);
}

}  // namespace
}  // namespace mien::render
