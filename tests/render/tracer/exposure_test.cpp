// Opacity, shutter, lens, parallel view and alpha.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "render/light/one_by_one.h"
#include "render/patch.h"
#include "render/tracer/tracer.h"

namespace mien::render {
namespace {

/// A ball that shines evenly before a black backdrop.
Scene shining_ball(float radius) {
  Scene scene;
  scene.has_ground = false;
  scene.sky = test::even_sky(Color::Zero());
  scene.sky.backdrop_horizon = scene.sky.backdrop_zenith = Color::Zero();
  scene.materials = {{.albedo = Color::Zero(), .emission = {0.8f, 0.4f, 0.2f}}};
  scene.solids.spheres = {{.centre = Vec3::Zero(), .radius = radius}};
  return scene;
}

Camera straight_on() {
  return {.position = {0.0f, 0.0f, 5.0f},
          .target = Vec3::Zero(),
          .vertical_field_of_view = 0.4f,
          .width = 96,
          .height = 64};
}

/// Sum of the first channel over the film, and its mean column.
struct Spot {
  double light = 0.0;
  double column = 0.0;
  double spread = 0.0;  // standard deviation along x, pixels
};

Spot spot_on(const Framebuffer& framebuffer) {
  Spot spot;
  double squares = 0.0;
  for (int y = 0; y < framebuffer.height; ++y) {
    for (int x = 0; x < framebuffer.width; ++x) {
      const auto light = static_cast<double>(framebuffer.at(x, y)[0]);
      spot.light += light;
      spot.column += light * (x + 0.5);
      squares += light * (x + 0.5) * (x + 0.5);
    }
  }
  spot.column /= spot.light;
  spot.spread = std::sqrt(squares / spot.light - spot.column * spot.column);
  return spot;
}

TEST(Exposing, ShowsAFigureToTheShareOfItsOpacity) {
  Scene scene = shining_ball(0.6f);
  scene.sky.backdrop_horizon = scene.sky.backdrop_zenith = Color::Constant(0.1f);
  scene.figures[0].opacity = 0.25f;
  // Another one half behind it, and both overlap with themselves.
  scene.figures.push_back({"second", 0.5f});
  scene.parts.push_back({"ball", 1});
  scene.materials.push_back({.albedo = Color::Zero(), .emission = Color::Constant(1.0f)});
  scene.solids.spheres.push_back({{0.0f, 0.0f, -2.0f}, 0.8f, 1, 1});
  scene.solids.spheres.push_back({{0.05f, 0.0f, 0.1f}, 0.6f, 0, 0});
  const Framebuffer framebuffer = Tracer().trace(scene, straight_on(), {.samples_per_pixel = 64});
  const Color expected = 0.25f * Color(0.8f, 0.4f, 0.2f) +
                         0.75f * (0.5f * Color::Constant(1.0f) + 0.5f * Color::Constant(0.1f));
  Color mean = Color::Zero();
  for (int y = 28; y < 36; ++y)
    for (int x = 44; x < 52; ++x) mean += Eigen::Map<const Color>(framebuffer.at(x, y)) / 64.0f;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], expected[c], 0.01f);
}

TEST(Exposing, ShowsAShiningSurfaceInExactlyItsColour) {
  Scene scene = shining_ball(0.6f);
  scene.lights = {softbox({0.0f, 4.0f, 3.0f}, Vec3::Zero(), 1.0f, 1.0f, Color::Constant(30.0f))};
  const Framebuffer framebuffer = Tracer().trace(scene, straight_on(), {});
  EXPECT_FLOAT_EQ(framebuffer.at(48, 32)[0], 0.8f);
  EXPECT_FLOAT_EQ(framebuffer.at(48, 32)[1], 0.4f);
  EXPECT_FLOAT_EQ(framebuffer.at(48, 32)[2], 0.2f);
}

// While the shutter is open the ball's light is spread evenly along its way: a uniform distribution
// of width w has variance w²/12.
TEST(Exposing, SpreadsWhatMovesAlongItsWay) {
  const Scene opening = shining_ball(0.1f);
  Scene closing = opening;
  closing.solids.spheres[0].centre.x() = 0.8f;
  Tracer tracer;
  const Quality quality{.samples_per_pixel = 64};
  const Spot still = spot_on(tracer.trace(opening, straight_on(), quality));
  const Spot moving = spot_on(tracer.render_view({opening, straight_on(), quality, closing}).color);
  const double pixels_per_metre = 32.0 / (5.0 * std::tan(0.2));
  EXPECT_NEAR(moving.light, still.light, 0.02 * still.light);
  EXPECT_NEAR(moving.column, still.column + 0.4 * pixels_per_metre, 0.2);
  EXPECT_NEAR(moving.spread, std::hypot(still.spread, 0.8 * pixels_per_metre / std::sqrt(12.0)),
              0.2);
}

TEST(Exposing, SpreadsWhatStandsWhenTheCameraMoves) {
  const Scene scene = shining_ball(0.1f);
  Camera closing = straight_on();
  closing.position.x() -= 0.8f;
  closing.target.x() -= 0.8f;
  Tracer tracer;
  const Quality quality{.samples_per_pixel = 64};
  const Spot moving =
      spot_on(tracer.render_view({scene, straight_on(), quality, {}, closing}).color);
  const double pixels_per_metre = 32.0 / (5.0 * std::tan(0.2));
  EXPECT_NEAR(moving.column, 48.0 + 0.4 * pixels_per_metre, 0.2);
}

TEST(Exposing, RefusesAClosingSceneOfOtherSolids) {
  const Scene opening = shining_ball(0.1f);
  Scene closing = opening;
  closing.solids.spheres.clear();
  EXPECT_THROW(Tracer().render_view({opening, straight_on(), {}, closing}), std::invalid_argument);
}

// A point at distance d of a lens of radius r focused at f is seen as a disc of radius
// r (1/d − 1/f) in units of the film at distance 1; an even disc of radius R has variance R²/4
// along each axis.
TEST(Exposing, BlursWhatIsOutOfFocusIntoADisc) {
  const Scene scene = shining_ball(0.12f);
  Camera camera = straight_on();
  const Quality quality{.samples_per_pixel = 512};
  Tracer tracer;
  const Spot sharp = spot_on(tracer.trace(scene, camera, quality));
  camera.aperture_radius = 0.2f;
  camera.focus_distance = 5.0f;
  const Spot focused = spot_on(tracer.trace(scene, camera, quality));
  EXPECT_NEAR(focused.spread, sharp.spread, 0.1);
  camera.focus_distance = 3.0f;
  const Spot blurred = spot_on(tracer.trace(scene, camera, quality));
  const double radius = 0.2 * std::abs(1.0 / 5.0 - 1.0 / 3.0) * 32.0 / std::tan(0.2);
  EXPECT_NEAR(blurred.light, sharp.light, 0.02 * sharp.light);
  EXPECT_NEAR(blurred.spread, std::hypot(sharp.spread, 0.5 * radius), 0.1);
}

TEST(Exposing, ShowsThingsAsLargeFromFarInAParallelView) {
  Scene scene = shining_ball(0.5f);
  Camera camera = straight_on();
  camera.parallel_height = 2.0f;
  const double area = std::numbers::pi * 16.0 * 16.0;  // 0.5 m is 16 of 64 pixels
  for (const float away : {0.0f, -20.0f}) {
    scene.solids.spheres[0].centre.z() = away;
    const Spot spot = spot_on(Tracer().trace(scene, camera, {.samples_per_pixel = 16}));
    EXPECT_NEAR(spot.light / static_cast<double>(0.8f), area, 0.01 * area);
  }
}

/// A grey figure on a grey floor, so that what it takes away is grey.
Scene grey_scene() {
  Scene scene;
  scene.materials = {Material{}};
  scene.ground.line_spacing = 0.0f;
  scene.solids.spheres = {{.centre = {0.0f, 0.5f, 0.0f}, .radius = 0.4f}};
  scene.lights = {softbox({1.5f, 3.0f, 2.0f}, Vec3::Zero(), 0.5f, 0.5f, Color::Constant(20.0f))};
  return scene;
}

TEST(Exposing, CompositesBackToThePictureWithItsSet) {
  const Scene scene = grey_scene();
  Scene nobody = scene;
  nobody.solids = {};
  const Camera camera{.position = {0.5f, 1.5f, 4.0f}, .width = 96, .height = 64};
  Tracer tracer;
  Quality quality{.samples_per_pixel = 8};
  const Framebuffer shown = tracer.trace(scene, camera, quality);
  const Framebuffer set = tracer.trace(nobody, camera, quality);
  quality.background = Background::shadow;
  const RenderTarget shadow = tracer.render_view({scene, camera, quality});
  quality.background = Background::transparent;
  const RenderTarget clear = tracer.render_view({scene, camera, quality});
  EXPECT_EQ(clear.color, shadow.color);
  bool shaded = false;
  for (std::size_t i = 0; i < shadow.alpha.size(); ++i) {
    const float back =
        shadow.color.channels[3 * i] + (1.0f - shadow.alpha[i]) * set.channels[3 * i];
    EXPECT_NEAR(back, shown.channels[3 * i], 1e-5f);
    EXPECT_LE(clear.alpha[i], shadow.alpha[i] + 1e-6f);
    shaded = shaded || (clear.alpha[i] == 0.0f && shadow.alpha[i] > 0.2f);
  }
  EXPECT_TRUE(shaded);
}

/// A sphere of triangles.
Mesh ball_mesh(float radius, int rows) {
  Mesh mesh;
  const int columns = 2 * rows;
  for (int i = 0; i <= rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const double t = std::numbers::pi * i / rows, p = std::numbers::pi * j / rows;
      const Vec3 normal{static_cast<float>(std::sin(t) * std::cos(p)),
                        static_cast<float>(std::cos(t)),
                        static_cast<float>(std::sin(t) * std::sin(p))};
      mesh.positions.push_back(radius * normal);
      mesh.normals.push_back(normal);
    }
  }
  const auto vertex = [&](int i, int j) { return i * columns + j % columns; };
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j)});
      mesh.triangles.push_back({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1)});
    }
  }
  return mesh;
}

TEST(Exposing, ShowsAFineMeshLikeTheSphereThatItIs) {
  Scene smooth = shining_ball(1.0f);
  smooth.materials = {{.albedo = {0.3f, 0.6f, 0.9f}}};
  smooth.sky = test::even_sky(Color::Constant(0.7f));
  smooth.lights = {softbox({2.0f, 4.0f, 3.0f}, Vec3::Zero(), 1.0f, 1.0f, Color::Constant(9.0f))};
  Scene meshed = smooth;
  meshed.solids = {};
  meshed.solids.meshes = {ball_mesh(1.0f, 48)};
  Tracer tracer;
  const Quality quality{.samples_per_pixel = 64};
  const Framebuffer expected = tracer.trace(smooth, straight_on(), quality);
  const Framebuffer found = tracer.trace(meshed, straight_on(), quality);
  double squares = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < found.channels.size(); ++i) {
    const double off = std::abs(static_cast<double>(found.channels[i] - expected.channels[i]));
    squares += off * off;
    largest = std::max(largest, off);
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(found.channels.size())), 0.004);
  EXPECT_LT(largest, 0.1);  // at the outline, which has corners
}

TEST(Exposing, KnowsTheOpenSkyOnEveryNormal) {
  const Sky sky{
      .zenith = {2.0f, 1.0f, 0.5f}, .horizon = {0.3f, 0.8f, 1.0f}, .below = {0.2f, 0.1f, 0.4f}};
  for (const float y : {-1.0f, -0.7f, -0.2f, 0.0f, 0.4f, 0.8f, 1.0f}) {
    const Vec3 normal{std::sqrt(1.0f - y * y), y, 0.0f};
    Eigen::Array3d sum = Eigen::Array3d::Zero();
    constexpr int rays = 1 << 14;
    for (int i = 0; i < rays; ++i)
      sum += sky_radiance(sky, test::cosine_direction(
                                   normal, sample_point(static_cast<std::uint32_t>(i), 9)))
                 .cast<double>();
    const Color known = unoccluded_sky_light(sky, normal);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(known[c], sum[c] / rays, 5e-4) << y;
  }
}

TEST(Exposing, RefusesSharingThatHasNoBounds) {
  const Scene scene = shining_ball(0.6f);
  for (const Quality& quality :
       {Quality{.figure_sharing_pixels = -1}, Quality{.floor_sharing_pixels = 65},
        Quality{.figure_samples_per_ray = 0}, Quality{.samples_shaded_together = 0},
        Quality{.samples_shaded_together = 5}, Quality{.floor_samples_per_ray = 0}})
    EXPECT_THROW(Tracer().trace(scene, straight_on(), quality), std::invalid_argument);
}

TEST(Exposing, AWindowShowsToTheBitWhatTheWholeShowsThere) {
  Scene scene = shining_ball(0.6f);
  scene.has_ground = true;
  scene.solids.spheres[0].centre.y() = 0.5f;
  scene.solids.spheres.push_back({{0.2f, 0.5f, 0.55f}, 0.2f});
  scene.materials[0].albedo = {0.4f, 0.5f, 0.6f};
  scene.sky = test::even_sky(Color::Constant(0.5f));
  scene.lights = {softbox({2.0f, 4.0f, 3.0f}, Vec3::Zero(), 1.0f, 1.0f, Color::Constant(12.0f))};
  Camera camera = straight_on();
  camera.position.y() = 1.0f;
  Camera cropped = camera;
  // The last window begins and ends with a tile, where pixels share with those beside it.
  for (const Window& window : {Window{37, 21, 30, 29}, Window{48, 16, 16, 16}}) {
    cropped.window = window;
    for (const Background background :
         {Background::shown, Background::transparent, Background::shadow}) {
      const Quality quality{.samples_per_pixel = 4, .background = background};
      const RenderTarget whole = Tracer().render_view({scene, camera, quality});
      const RenderTarget part = Tracer().render_view({scene, cropped, quality});
      EXPECT_EQ(part.color, crop(whole.color, window));
      if (background != Background::shown) {
        EXPECT_EQ(part.alpha, crop(whole.alpha, camera.width, window));
      }
    }
    for (const int samples : {1, 2}) {
      const Quality few{.samples_per_pixel = samples};
      EXPECT_EQ(Tracer().trace(scene, cropped, few),
                crop(Tracer().trace(scene, camera, few), window));
    }
  }
  scene.figures[0].opacity = 0.7f;
  for (const Window& window : {Window{32, 32, 16, 16}, Window{48, 32, 16, 16}}) {
    cropped.window = window;
    for (const Quality& quality : {draft_quality(), standard_quality()})
      EXPECT_EQ(Tracer().trace(scene, cropped, quality),
                crop(Tracer().trace(scene, camera, quality), window));
  }
  // So few rays that many pixels look twice as far for others that found something; the rims of
  // tiles lie between one and two reaches beyond the window.
  cropped.window = Window{35, 35, 26, 26};
  for (const int reach : {2, 3}) {
    const Quality sparse{.samples_per_pixel = 4,
                         .figure_sharing_pixels = reach,
                         .floor_sharing_pixels = reach,
                         .figure_samples_per_ray = 150,
                         .floor_samples_per_ray = 150};
    EXPECT_EQ(Tracer().trace(scene, cropped, sparse),
              crop(Tracer().trace(scene, camera, sparse), *cropped.window));
  }
  cropped.window = Window{37, 21, 30, 29};
  const Quality quality{.samples_per_pixel = 4};
  const Layers whole = crop(Tracer().layers(scene, camera, quality), *cropped.window);
  const Layers part = Tracer().layers(scene, cropped, quality);
  EXPECT_EQ(part.beauty.width, 30);
  EXPECT_EQ(part.normal, whole.normal);
  EXPECT_EQ(part.depth, whole.depth);
  EXPECT_EQ(part.motion, whole.motion);
  EXPECT_EQ(part.variance, whole.variance);
  EXPECT_EQ(part.figures.ranks.size(), whole.figures.ranks.size());
  cropped.window->width = 60;
  EXPECT_THROW(frame_of(cropped), std::invalid_argument);
}

}  // namespace
}  // namespace mien::render
