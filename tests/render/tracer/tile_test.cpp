// What the figure takes away from the floor, against references that share no code with it.

#include "render/tracer/tile.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "render/patch.h"
#include "render/tracer/contract.h"

namespace mien::render {
namespace {

using test::camera_on;
using test::expect_mean;
using test::mean_radiance_at;
using test::radiance_at;

const Vec3 aside{4.0f, 3.0f, 0.0f};

Scene bare_floor(float albedo) {
  Scene scene;
  scene.materials = {Material{}};
  scene.ground.albedo = Color::Constant(albedo);
  scene.ground.line_spacing = 0.0f;
  scene.sky = test::even_sky(Color::Constant(1.0f));
  return scene;
}

// A sphere wholly above the horizon is seen by a floor element under (R/d)² cos θ of the sky.
TEST(FloorSky, BesideASphereLacksTheSpheresFormFactor) {
  for (const float x : {0.3f, 0.7f, 1.0f, 2.0f, 4.0f}) {
    Scene scene = bare_floor(0.5f);
    scene.solids.spheres = {{.centre = {0.0f, 0.6f, 0.0f}, .radius = 0.6f}};
    const double distance = std::hypot(static_cast<double>(x), 0.6);
    const double hidden = std::pow(0.6 / distance, 3);
    const test::SampleMean found =
        radiance_at(scene, camera_on({x, 0.0f, 0.0f}, aside),
                    {.samples_per_pixel = 4, .floor_sky_tolerance = 0.0f}, 8);
    SCOPED_TRACE(x);
    expect_mean(found, 0.5 * (1.0 - hidden), 0.02 * hidden, 0.002 * hidden);
    // And where it is known at the corners of cells, interpolated in between.
    Camera few = camera_on({x, 0.0f, 0.0f}, aside);
    few.width = few.height = 12;
    const test::SampleMean interpolated =
        mean_radiance_at(scene, few, {.samples_per_pixel = 1}, 400);
    expect_mean(interpolated, 0.5 * (1.0 - hidden), 0.0015, 0.0003);
  }
}

std::vector<Sphere> sparse_figure() {
  return {{{0.0f, 1.7f, 0.1f}, 0.12f},  {{0.1f, 1.2f, 0.0f}, 0.18f},  {{0.5f, 1.3f, 0.2f}, 0.07f},
          {{-0.5f, 0.9f, 0.1f}, 0.08f}, {{0.15f, 0.5f, 0.0f}, 0.1f},  {{-0.2f, 0.4f, 0.2f}, 0.1f},
          {{0.3f, 0.08f, 0.1f}, 0.06f}, {{-0.3f, 0.1f, -0.2f}, 0.07f}};
}

/// Share of the sky's irradiance that spheres hide from a floor point, by 1000 × 1000 directions
/// spread over the disc that the hemisphere projects to. The sky is `horizon` + `rise`·sin
/// elevation.
double hidden_sky(const std::vector<Sphere>& spheres, const Vec3& point, double horizon,
                  double rise) {
  constexpr int n = 1000;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    const double radius = std::sqrt((i + 0.5) / n), height = std::sqrt(1.0 - radius * radius);
    for (int j = 0; j < n; ++j) {
      const double angle = 2.0 * std::numbers::pi * (j + 0.5) / n;
      const Eigen::Vector3d towards{radius * std::cos(angle), height, radius * std::sin(angle)};
      for (const Sphere& sphere : spheres) {
        const Eigen::Vector3d centre = (sphere.centre - point).cast<double>();
        const double along = centre.dot(towards), r = static_cast<double>(sphere.radius);
        if (along > 0.0 && centre.squaredNorm() - along * along < r * r) {
          sum += horizon + rise * height;
          break;
        }
      }
    }
  }
  return sum / (n * n);
}

// From close by, where all the sky is sampled, to so far off that few pixels send a ray.
TEST(FloorSky, IsUnbiasedHoweverFewRaysItIsWorth) {
  Scene scene = bare_floor(0.8f);
  scene.sky.zenith = Color::Constant(2.0f);
  scene.sky.horizon = Color::Constant(0.5f);
  scene.solids.spheres = sparse_figure();
  for (const float x : {0.4f, 1.5f, 2.5f, 4.0f, 6.0f}) {
    const Vec3 point{x, 0.0f, 0.3f};
    const double hidden = hidden_sky(scene.solids.spheres, point, 0.5, 1.5);
    const double whole = 0.5 + 1.5 * 2.0 / 3.0;
    const test::SampleMean found = radiance_at(
        scene, camera_on(point, aside), {.samples_per_pixel = 16, .floor_sky_tolerance = 0.0f}, 40);
    SCOPED_TRACE(x);
    expect_mean(found, 0.8 * (whole - hidden), 0.8 * 0.05 * hidden, 0.8 * 0.01 * hidden);
  }
}

// All over the floor near a figure, in cells of every size: interpolation is off by less than a
// thousandth of the sky's light.
TEST(FloorSky, IsInterpolatedWithoutVisibleError) {
  Scene scene = bare_floor(0.8f);
  scene.solids.spheres = sparse_figure();
  std::mt19937 random(5);
  std::uniform_real_distribution<float> place(-2.5f, 2.5f);
  for (int trial = 0; trial < 40; ++trial) {
    const Vec3 point{place(random), 0.0f, place(random)};
    const double hidden = hidden_sky(scene.solids.spheres, point, 1.0, 0.0);
    Camera few = camera_on(point, aside);
    few.width = few.height = 6;
    Quality quality{.samples_per_pixel = 16};
    quality.floor_sky_noise = 0.001f;
    const test::SampleMean found = mean_radiance_at(scene, few, quality, 100);
    SCOPED_TRACE(point.transpose());
    expect_mean(found, 0.8 * (1.0 - hidden), 0.0005, 0.8 * 0.001);
  }
}

/// How far apart the pixels of one film are.
double range_of(const Framebuffer& framebuffer) {
  const auto [low, high] =
      std::minmax_element(framebuffer.channels.begin(), framebuffer.channels.end());
  return static_cast<double>(*high - *low);
}

/// How the floor looks beside two balls of 5 cm that lie on it, at points around them, interpolated
/// and by rays of each pixel, which are known to be unbiased.
struct BesideAFoot {
  double worst = 0.0;                ///< largest difference of means of many pictures
  double off = 0.0;                  ///< mean difference
  double smooth = 0.0, grain = 0.0;  ///< range of 8 × 8 pixels
};

BesideAFoot beside_a_foot(const Quality& quality) {
  Scene scene = bare_floor(0.8f);
  scene.solids.spheres = sparse_figure();
  scene.solids.spheres.push_back({{0.0f, 0.05f, 0.0f}, 0.05f});
  scene.solids.spheres.push_back({{0.08f, 0.05f, 0.0f}, 0.05f});
  Quality grainy = quality;
  grainy.floor_sky_smooth = false;
  BesideAFoot found;
  constexpr int points = 24;
  for (int k = 0; k < points; ++k) {
    const float angle = 0.26f * static_cast<float>(k);
    const float away = 0.07f + 0.003f * static_cast<float>(k);
    const Vec3 point{0.04f + 1.5f * away * std::cos(angle), 0.0f, away * std::sin(angle)};
    Camera camera = camera_on(point, aside);
    camera.width = camera.height = 8;
    found.smooth += range_of(Tracer().trace(scene, camera, quality)) / points;
    found.grain += range_of(Tracer().trace(scene, camera, grainy)) / points;
    const double difference = mean_radiance_at(scene, camera, quality, 40).mean() -
                              mean_radiance_at(scene, camera, grainy, 60).mean();
    found.worst = std::max(found.worst, std::abs(difference));
    found.off += difference / points;
  }
  return found;
}

// Where points are not close enough to be sure, the sky is interpolated all the same: the floor has
// next to no grain. It is off there by more than anywhere else.
TEST(FloorSky, IsSmoothBesideFeetAndNotFarFromWhatItIs) {
  constexpr double sky_light = 0.8;  // of the even sky of radiance 1, times the albedo
  const BesideAFoot draft = beside_a_foot(draft_quality());
  EXPECT_LT(draft.smooth, 0.1 * draft.grain);
  EXPECT_GT(draft.grain, 0.1);
  EXPECT_LT(draft.worst, floor_sky_bias.draft * sky_light);
  EXPECT_NEAR(draft.off, 0.0, 0.02);
  const BesideAFoot video = beside_a_foot(standard_quality());
  EXPECT_LT(video.smooth, 0.2 * video.grain);
  EXPECT_GT(video.grain, 0.1);
  EXPECT_LT(video.worst, floor_sky_bias.standard * sky_light);
  EXPECT_NEAR(video.off, 0.0, 0.005);
  const BesideAFoot print = beside_a_foot(final_quality());
  EXPECT_LT(print.smooth, 0.5 * print.grain);
  EXPECT_LT(print.worst, floor_sky_bias.final * sky_light);
  EXPECT_NEAR(print.off, 0.0, 0.0015);
}

// Each pixel with shadow rays that it shares with no other.
const Quality own{.floor_sharing_pixels = 0};

TEST(FloorLight, IsNoneWhereTheFigureHidesTheLight) {
  Scene scene = bare_floor(0.5f);
  scene.sky = {};
  scene.sky.zenith = scene.sky.horizon = Color::Zero();
  scene.lights = {{.centre = {0.0f, 4.0f, 0.0f}, .radiance = Color::Constant(20.0f)}};
  const Camera camera = camera_on(Vec3::Zero(), {3.0f, 0.3f, 0.0f});
  const double lit = radiance_at(scene, camera, {}, 1).mean();
  scene.solids.spheres = {{.centre = {0.0f, 1.2f, 0.0f}, .radius = 1.0f}};
  expect_mean(radiance_at(scene, camera, own, 8), 0.0, 1e-3 * lit, 1e-3 * lit);
}

// A ball on the line to the light's middle, small enough that the light's rim shows round it: its
// shadow on the light's plane is a disc, and the rest of the light is what arrives.
TEST(FloorLight, IsWhatTheFigureLeavesOfTheLight) {
  Scene scene = bare_floor(0.5f);
  scene.sky.zenith = scene.sky.horizon = Color::Zero();
  scene.lights = {{.centre = {0.0f, 4.0f, 0.0f}, .radiance = Color::Constant(20.0f)}};
  scene.solids.spheres = {{.centre = {0.0f, 1.0f, 0.0f}, .radius = 0.08f}};
  // The cone that touches the ball; a disc of half angle α right above has form factor sin² α.
  const double hidden = 0.08 * 0.08;
  Scene unhidden = scene;
  unhidden.solids.spheres.clear();
  const Camera camera = camera_on(Vec3::Zero(), {3.0f, 1.0f, 0.0f});
  const double whole = radiance_at(unhidden, camera, {}, 1).mean();
  const double expected = whole - 0.5 * 20.0 * hidden;
  EXPECT_LT(expected, 0.8 * whole);
  expect_mean(radiance_at(scene, camera, own, 16), expected, 1e-3 * whole, 1e-3 * whole);
}

}  // namespace
}  // namespace mien::render
