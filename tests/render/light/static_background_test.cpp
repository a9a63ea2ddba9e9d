// What is kept of the set from picture to picture, against drawing everything each time.

#include "render/light/static_background.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "render/tracer/tracer.h"

namespace mien::render {
namespace {

/// An upright wall of two triangles from one place of the floor to another.
Mesh wall(const Vec3& from, const Vec3& to, float height, int material) {
  Mesh mesh;
  const Vec3 up{0.0f, height, 0.0f};
  mesh.positions = {from, to, to + up, from + up};
  mesh.normals.assign(4, (to - from).cross(up).normalized());
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.material = material;
  return mesh;
}

/// A figure between two walls, one of which it shades.
Scene walled_scene() {
  Scene scene;
  scene.materials = {{.albedo = {0.7f, 0.4f, 0.2f}}, {.albedo = {0.5f, 0.5f, 0.6f}}};
  scene.solids.spheres = {{.centre = {0.0f, 0.9f, 0.0f}, .radius = 0.3f}};
  scene.solids.round_cones = {{.start = {0.0f, 0.1f, 0.0f}, .end = {0.0f, 0.8f, 0.0f}}};
  scene.static_solids.meshes = {wall({-2.0f, 0.0f, -0.8f}, {2.0f, 0.0f, -0.8f}, 1.6f, 1),
                                wall({-0.9f, 0.0f, 1.5f}, {-0.9f, 0.0f, -0.8f}, 0.7f, 1)};
  scene.lights = {
      softbox({1.5f, 3.0f, 3.0f}, {0.0f, 0.8f, 0.0f}, 0.8f, 0.8f, Color::Constant(9.0f))};
  return scene;
}

const Camera front_camera{.position = {0.8f, 1.5f, 4.0f},
                          .target = {0.0f, 0.7f, 0.0f},
                          .vertical_field_of_view = 0.6f,
                          .width = 48,
                          .height = 32};

/// Mean and variance of every channel over pictures with different noise.
struct Pictures {
  std::vector<double> mean;
  std::vector<double> variance_of_mean;
};

Pictures pictures_of(const Scene& scene, Quality quality, int seeds) {
  Tracer tracer;
  std::vector<double> sum, squares;
  for (int seed = 0; seed < seeds; ++seed) {
    quality.seed = static_cast<std::uint64_t>(seed) + 1;
    const Framebuffer framebuffer = tracer.trace(scene, front_camera, quality);
    sum.resize(framebuffer.channels.size());
    squares.resize(framebuffer.channels.size());
    for (std::size_t i = 0; i < framebuffer.channels.size(); ++i) {
      const auto value = static_cast<double>(framebuffer.channels[i]);
      sum[i] += value;
      squares[i] += value * value;
    }
  }
  Pictures pictures;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const double mean = sum[i] / seeds;
    const double variance = std::max(0.0, squares[i] / seeds - mean * mean);
    pictures.mean.push_back(mean);
    pictures.variance_of_mean.push_back(variance / (seeds - 1));
  }
  return pictures;
}

/// The largest difference of any channel, in standard errors; differences of less than half a code
/// value of 8 bits do not count.
double largest_deviation(const Pictures& a, const Pictures& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.mean.size(); ++i) {
    const double error = std::sqrt(a.variance_of_mean[i] + b.variance_of_mean[i]);
    const double off = std::max(0.0, std::abs(a.mean[i] - b.mean[i]) - 0.002);
    largest = std::max(largest, off / (error + 1e-6));
  }
  return largest;
}

// 4608 channels, each normal up to the few dozen seeds: 6 standard errors are met by chance less
// than once in ten thousand runs.
constexpr double beyond_chance = 6.0;

TEST(StaticBackground, GivesTheMeanThatTracingAllOfItEachTimeGives) {
  const Scene reused = walled_scene();
  Scene whole = reused;
  for (const Mesh& mesh : reused.static_solids.meshes) whole.solids.meshes.push_back(mesh);
  whole.static_solids = {};
  Quality quality{.samples_per_pixel = 16, .static_samples = 64};
  quality.figure_sharing_pixels = quality.floor_sharing_pixels = 0;
  const Pictures quick = pictures_of(reused, quality, 48);
  quality.floor_sky_tolerance = 0.0f;
  const Pictures brute = pictures_of(whole, quality, 48);
  EXPECT_LT(largest_deviation(quick, brute), beyond_chance);

  // The test can fail: a lamp a twentieth dimmer, or no shadow on the wall, is seen.
  Scene dim = reused;
  dim.lights[0].radiance *= 0.95f;
  EXPECT_GT(largest_deviation(pictures_of(dim, quality, 16), brute), beyond_chance);
  Scene shadowless = reused;
  shadowless.solids.round_cones.clear();
  EXPECT_GT(largest_deviation(pictures_of(shadowless, quality, 16), brute), beyond_chance);
}

TEST(StaticBackground, IsTheSameWhetherItIsKeptOrMadeAnew) {
  const Scene scene = walled_scene();
  Scene other = scene;
  other.static_solids.meshes[0].positions[2].y() += 0.3f;
  Tracer kept, fresh;
  const Quality quality{.samples_per_pixel = 4, .static_samples = 8};
  const Framebuffer first = kept.trace(scene, front_camera, quality);
  const Framebuffer changed = kept.trace(other, front_camera, quality);
  EXPECT_NE(changed, first);
  EXPECT_EQ(changed, fresh.trace(other, front_camera, quality));
  EXPECT_EQ(kept.trace(scene, front_camera, quality), first);

  // All of the quality that shows in it counts, and so does what meshes are painted with.
  Quality coarse = quality;
  coarse.floor_sky_tolerance = 0.5f;
  coarse.floor_sky_noise = 0.05f;
  EXPECT_EQ(kept.trace(scene, front_camera, coarse), Tracer().trace(scene, front_camera, coarse));
  Scene painted = scene;
  Texture texture{1, 1, {Color::Constant(0.9f)}};
  painted.textures = {&texture};
  painted.materials[1].texture = 0;
  for (Mesh& mesh : painted.static_solids.meshes)
    mesh.uv.assign(mesh.positions.size(), {0.5f, 0.5f});
  const Framebuffer light = kept.trace(painted, front_camera, quality);
  texture.texels = {Color::Constant(0.1f)};
  const Framebuffer dark = kept.trace(painted, front_camera, quality);
  EXPECT_NE(dark, light);
  EXPECT_EQ(dark, Tracer().trace(painted, front_camera, quality));
}

/// A change of what a picture is drawn from.
using PictureChange = std::function<void(Scene&, Camera&, Quality&)>;

// A tracer keeps backgrounds by what they depend on: if a change were left out of that, its picture
// would be that before the change.
TEST(StaticBackground, IsMadeAnewAfterEveryChangeThatItShows) {
  const Texture stripes{2, 1, {Color(0.9f, 0.8f, 0.7f), Color(0.2f, 0.3f, 0.4f)}};
  const Texture dark{2, 1, {Color(0.1f, 0.8f, 0.7f), Color(0.2f, 0.3f, 0.4f)}};
  const Texture bumps{1, 1, {Color(0.7f, 0.4f, 0.9f)}};
  Scene scene = walled_scene();
  scene.textures = {&stripes, &bumps};
  scene.materials[1].texture = 0;
  scene.materials[1].normal_map = 1;
  scene.materials[1].specular_f0 = 0.05f;
  scene.ground.major_every = 2;
  for (Mesh& mesh : scene.static_solids.meshes)
    mesh.uv = {{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}};
  scene.static_solids.spheres = {{.centre = {1.2f, 0.3f, 0.4f}, .radius = 0.3f, .material = 1}};
  scene.static_solids.round_cones = {
      {.start = {-1.4f, 0.2f, 0.6f}, .end = {-1.4f, 0.8f, 0.3f}, .material = 1}};
  Camera camera = front_camera;
  camera.width = 24;
  camera.height = 16;
  const Quality quality{.samples_per_pixel = 1, .static_samples = 2, .floor_sky_noise = 0.05f};
  const auto of_material = [](auto member, auto value) -> PictureChange {
    return [=](Scene& s, Camera&, Quality&) { s.materials[1].*member = value; };
  };
  const auto of_ground = [](auto member, auto value) -> PictureChange {
    return [=](Scene& s, Camera&, Quality&) { s.ground.*member = value; };
  };
  const auto of_sky = [](Color Sky::*member) -> PictureChange {
    return [=](Scene& s, Camera&, Quality&) { s.sky.*member = Color(0.3f, 0.1f, 0.2f); };
  };
  const auto of_camera = [](auto member, auto value) -> PictureChange {
    return [=](Scene&, Camera& c, Quality&) { c.*member = value; };
  };
  const auto of_quality = [](auto member, auto value) -> PictureChange {
    return [=](Scene&, Camera&, Quality& q) { q.*member = value; };
  };
  const std::vector<PictureChange> changes = {
      of_material(&Material::albedo, Color(0.1f, 0.2f, 0.3f)),
      of_material(&Material::specular_f0, 0.0f),
      of_material(&Material::roughness, 0.3f),
      of_material(&Material::emission, Color(0.1f, 0.2f, 0.3f)),
      of_material(&Material::texture, -1),
      of_material(&Material::normal_map, -1),
      of_material(&Material::normal_scale, 0.3f),
      [&](Scene& s, Camera&, Quality&) { s.textures[0] = &dark; },
      [](Scene& s, Camera&, Quality&) { s.static_solids.meshes[0].material = 0; },
      [](Scene& s, Camera&, Quality&) { s.static_solids.meshes[0].positions[2].y() = 1.2f; },
      [](Scene& s, Camera&, Quality&) { s.static_solids.meshes[0].normals[1].x() = 0.5f; },
      [](Scene& s, Camera&, Quality&) {
        s.static_solids.meshes[0].uv[1] = {0.4f, 0.0f};
      },
      [](Scene& s, Camera&, Quality&) { s.static_solids.meshes[0].triangles.pop_back(); },
      [](Scene& s, Camera&, Quality&) { s.static_solids.spheres[0].radius = 0.2f; },
      [](Scene& s, Camera&, Quality&) { s.static_solids.spheres[0].material = 0; },
      [](Scene& s, Camera&, Quality&) { s.static_solids.round_cones[0].end_radius = 0.1f; },
      [](Scene& s, Camera&, Quality&) { s.static_solids.round_cones[0].end.y() = 0.5f; },
      [](Scene& s, Camera&, Quality&) { s.figures[0].opacity = 0.5f; },
      [](Scene& s, Camera&, Quality&) { s.lights[0].radiance[1] = 2.0f; },
      [](Scene& s, Camera&, Quality&) { s.lights[0].half_u *= 0.5f; },
      [](Scene& s, Camera&, Quality&) { s.lights.clear(); },
      [](Scene& s, Camera&, Quality&) { s.has_ground = false; },
      of_ground(&Ground::albedo, Color(0.1f, 0.2f, 0.3f)),
      of_ground(&Ground::line_albedo, Color(0.1f, 0.2f, 0.3f)),
      of_ground(&Ground::line_spacing, 0.7f),
      of_ground(&Ground::line_width, 0.1f),
      of_ground(&Ground::major_every, 3),
      of_ground(&Ground::major_albedo, Color(0.1f, 0.2f, 0.6f)),
      of_ground(&Ground::offset_x, 0.3f),
      of_ground(&Ground::offset_z, 0.3f),
      of_ground(&Ground::fade_start, 2.0f),
      of_ground(&Ground::fade_end, 12.0f),
      of_sky(&Sky::zenith),
      of_sky(&Sky::horizon),
      of_sky(&Sky::below),
      of_sky(&Sky::backdrop_horizon),
      of_sky(&Sky::backdrop_zenith),
      of_camera(&Camera::position, Vec3(0.8f, 1.6f, 4.0f)),
      of_camera(&Camera::target, Vec3(0.1f, 0.7f, 0.0f)),
      of_camera(&Camera::up, Vec3(0.1f, 1.0f, 0.0f)),
      of_camera(&Camera::vertical_field_of_view, 0.7f),
      of_camera(&Camera::parallel_height, 2.0f),
      of_camera(&Camera::shift_x, 2.0f),
      of_camera(&Camera::shift_y, 2.0f),
      of_camera(&Camera::aperture_radius, 0.05f),
      of_camera(&Camera::focus_distance, 2.0f),
      of_camera(&Camera::window, std::optional(Window{4, 4, 12, 8})),
      of_quality(&Quality::samples_per_pixel, 2),
      of_quality(&Quality::sky_rays, 4),
      of_quality(&Quality::samples_shaded_together, 1),
      of_quality(&Quality::figure_sharing_pixels, 0),
      of_quality(&Quality::figure_shares_lights, true),
      of_quality(&Quality::floor_sharing_pixels, 0),
      of_quality(&Quality::figure_samples_per_ray, 1),
      of_quality(&Quality::floor_samples_per_ray, 1),
      of_quality(&Quality::static_samples, 5),
      of_quality(&Quality::floor_sky_noise, 0.02f),
      of_quality(&Quality::floor_sky_tolerance, 0.0f),
      of_quality(&Quality::floor_sky_cell, 0.01f),
      of_quality(&Quality::floor_sky_smooth, false),
      of_quality(&Quality::filter_width, 3.0f),
      of_quality(&Quality::background, Background::shadow),
      of_quality(&Quality::shutter, 0.5f),
      of_quality(&Quality::seed, std::uint64_t{5}),
      of_quality(&Quality::seed, std::uint64_t{1} << 40),
      of_quality(&Quality::reference, true)};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    View changed{scene, camera, quality, {}, {}};
    changes[i](changed.scene, changed.camera, changed.quality);
    Tracer kept({.threads = 1});
    kept.trace(scene, camera, quality);
    EXPECT_EQ(kept.render_view(changed).color, Tracer({.threads = 1}).render_view(changed).color)
        << i;
  }
}

TEST(StaticBackground, ServesAPairOfCamerasByTurns) {
  const Scene scene = walled_scene();
  Camera right = front_camera;
  right.position.x() += 0.06f;
  const Quality quality{.samples_per_pixel = 4, .static_samples = 8};
  const Framebuffer left_alone = Tracer().trace(scene, front_camera, quality);
  const Framebuffer right_alone = Tracer().trace(scene, right, quality);
  Tracer both;
  for (int turn = 0; turn < 3; ++turn) {
    EXPECT_EQ(both.trace(scene, front_camera, quality), left_alone);
    EXPECT_EQ(both.trace(scene, right, quality), right_alone);
  }
}

// What one set was made of serves the next.
TEST(StaticBackground, ShowsNothingOfTheSetsBeforeIt) {
  const Quality quality{.samples_per_pixel = 2, .static_samples = 4};
  const Scene walled = walled_scene();
  Scene open = walled;
  open.static_solids = {};
  Camera narrow = front_camera;
  narrow.width = 40;
  Tracer one;
  for (int k = 0; k < 8; ++k) {
    const Scene& scene = k % 3 == 1 ? walled : open;
    Camera moved = k % 4 == 3 ? narrow : front_camera;
    moved.position.x() += 0.1f * static_cast<float>(k);
    EXPECT_EQ(one.trace(scene, moved, quality), Tracer().trace(scene, moved, quality)) << k;
  }
}

TEST(StaticBackground, StaysWholeWhenTheFigureIsSeenThrough) {
  Scene scene = walled_scene();
  const Quality quality{.samples_per_pixel = 4, .static_samples = 8};
  const Framebuffer solid = Tracer().trace(scene, front_camera, quality);
  scene.figures[0].opacity = 0.0f;
  const Framebuffer vanished = Tracer().trace(scene, front_camera, quality);
  scene.figures[0].opacity = 1.0f;
  scene.solids = {};
  // Where the figure would be, the walls are drawn with fewer samples.
  const auto light = [](const Framebuffer& framebuffer) {
    return std::accumulate(framebuffer.channels.begin(), framebuffer.channels.end(), 0.0);
  };
  const double alone = light(Tracer().trace(scene, front_camera, quality));
  EXPECT_NEAR(light(vanished), alone, 0.002 * alone);
  EXPECT_GT(std::abs(light(solid) - alone), 0.01 * alone);
}

}  // namespace
}  // namespace mien::render
