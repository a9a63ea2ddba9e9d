#include "render/tracer/tracer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "render/block_means.h"
#include "render/patch.h"
#include "render/refusal.h"

namespace mien::render {
namespace {

using test::BlockMeans;
using test::camera_on;
using test::even_sky;
using test::expect_mean;
using test::mean_of_pictures;
using test::radiance_at;

const Color sky_light{0.2f, 0.5f, 1.5f};
const Color albedo{0.3f, 0.6f, 0.9f};

Scene one_sphere() {
  Scene scene;
  scene.has_ground = false;
  scene.materials = {{.albedo = albedo}};
  scene.solids.spheres = {{.centre = {0.0f, 1.0f, 0.0f}, .radius = 1.0f}};
  return scene;
}

TEST(Tracer, ShowsASphereInAFurnaceAsItsAlbedo) {
  Scene scene = one_sphere();
  scene.sky = even_sky(sky_light);
  // With a backdrop of the same light, edges count too.
  scene.sky.backdrop_horizon = scene.sky.backdrop_zenith = albedo * sky_light;
  const Framebuffer framebuffer =
      Tracer().trace(scene, {.width = 64, .height = 48}, {.samples_per_pixel = 8});
  for (std::size_t i = 0; i < framebuffer.channels.size(); ++i) {
    const float expected = (albedo * sky_light)[static_cast<Eigen::Index>(i % 3)];
    EXPECT_NEAR(framebuffer.channels[i], expected, 2e-6f) << "channel " << i;
  }
}

// ∫ (h + (z − h) sin e) cos θ dω over the sky that a point sees, over π.
TEST(Tracer, LightsASphereFromAGradedSky) {
  Scene scene = one_sphere();
  scene.sky.horizon = Color::Constant(0.5f);
  scene.sky.zenith = Color::Constant(2.0f);
  scene.sky.below = Color::Constant(0.25f);
  const auto a = static_cast<double>(albedo.x());
  const test::SampleMean top =
      radiance_at(scene, camera_on({0.0f, 2.0f, 0.0f}, {0.0f, 3.0f, 0.0f}), {}, 4);
  expect_mean(top, a * (0.5 + 1.5 * 2.0 / 3.0), 1e-4, 1e-4);
  const test::SampleMean side =
      radiance_at(scene, camera_on({1.0f, 1.0f, 0.0f}, {3.0f, 0.0f, 0.0f}), {}, 4);
  const double upper = 0.25 + 1.5 * (2.0 / 3.0) / std::numbers::pi;
  expect_mean(side, a * (upper + 0.5 * 0.25), 1e-4, 2e-4);
}

// The form factor of a square right above: four corners of Howell's B-3.
TEST(Tracer, LightsASphereFromARectangle) {
  Scene scene = one_sphere();
  scene.sky = even_sky(Color::Zero());
  scene.lights = {{.centre = {0.0f, 4.0f, 0.0f}, .radiance = Color::Constant(7.0f)}};
  const double x = 0.5 / 2.0, p = std::sqrt(1.0 + x * x);
  const double factor = 4.0 * 2.0 * (x / p) * std::atan(x / p) / (2.0 * std::numbers::pi);
  const double expected = static_cast<double>(albedo.x()) * 7.0 * factor;
  const test::SampleMean top =
      radiance_at(scene, camera_on({0.0f, 2.0f, 0.0f}, {0.0f, 3.0f, 0.0f}), {}, 8);
  expect_mean(top, expected, 1e-4 * expected, 3e-4 * expected);
}

Scene random_figure(unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  const auto place = [&] { return Vec3{uniform(-1, 1), uniform(-0.1f, 2), uniform(-1, 1)}; };
  Scene scene;
  scene.materials = {{.albedo = albedo}, {.albedo = {0.7f, 0.2f, 0.1f}, .specular_f0 = 0.04f}};
  for (int i = 0; i < 6; ++i)
    scene.solids.spheres.push_back({place(), uniform(0.02f, 0.2f), i % 2});
  for (int i = 0; i < 6; ++i)
    scene.solids.round_cones.push_back(
        {place(), place(), uniform(0.01f, 0.2f), uniform(0.01f, 0.2f), i % 2});
  // The second light stands as low as the figure, so that its shadows reach the horizon.
  scene.lights = {softbox({2.0f, 4.0f, 2.0f}, Vec3::UnitY(), 1.5f, 1.0f, Color::Constant(8.0f)),
                  softbox({-3.0f, 1.5f, 1.0f}, Vec3::UnitY(), 0.5f, 2.0f, Color::Constant(3.0f))};
  scene.sky.below = Color::Constant(0.1f);
  scene.has_ground = seed % 4 != 3;
  return scene;
}

Camera random_view(unsigned seed) {
  std::mt19937 random(1000 + seed);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  // Some stand amid the figure, some look past it.
  const float away = seed % 3 == 0 ? 0.6f : 4.0f;
  return {.position = {away * uniform(random), 1.5f + uniform(random), away * uniform(random)},
          .target = {uniform(random), 0.5f, uniform(random)},
          .vertical_field_of_view = 1.0f,
          .width = 75,
          .height = 50};
}

constexpr unsigned trials = 12;

// Also in more samples than go into a batch, where each sample casts rays of its own for the floor.
// Shared shadows are compared where means of samples are exact.
TEST(Tracer, GivesTheSamePictureWhenItTracesTheRaysThatMeetNothingToo) {
  Tracer tracer;
  for (unsigned seed = 0; seed < 2 * trials; ++seed) {
    Scene scene = random_figure(seed);
    if (seed % 2 == 1) scene.figures[0].opacity = 0.8f;
    // More lights, so that sums of their shadows depend on the order.
    scene.lights.push_back(
        softbox({1.0f, 3.0f, -2.0f}, Vec3::Zero(), 1.0f, 1.0f, Color::Constant(5.0f)));
    const Camera camera = random_view(seed);
    for (const auto& [samples, reach] :
         {std::pair{5, 0}, {7, 0}, {16, 0}, {1, 2}, {2, 2}, {16, 2}}) {
      Quality quality{.samples_per_pixel = samples, .floor_sharing_pixels = reach, .seed = seed};
      const Framebuffer quick = tracer.trace(scene, camera, quality);
      quality.exhaustive = true;
      EXPECT_EQ(tracer.trace(scene, camera, quality), quick)
          << "seed " << seed << ", " << samples << " samples, reach " << reach;
    }
  }
}

TEST(Tracer, ShowsTheNearerOfFigureAndStaticSolid) {
  Scene scene;
  scene.has_ground = false;
  scene.materials = {{.albedo = Color::Zero(), .emission = {0.9f, 0.1f, 0.2f}},
                     {.albedo = Color::Zero(), .emission = {0.1f, 0.8f, 0.3f}}};
  scene.static_solids.spheres = {{.centre = Vec3::Zero(), .radius = 0.5f, .material = 0}};
  const Camera camera{
      .position = {0.0f, 0.0f, 6.0f}, .target = Vec3::Zero(), .width = 9, .height = 9};
  Tracer tracer;
  for (const float z : {-1.5f, 1.5f}) {
    scene.solids.spheres = {{.centre = {0.0f, 0.0f, z}, .radius = 0.4f, .material = 1}};
    for (const Quality& quality : {draft_quality(), standard_quality(), reference_quality()}) {
      const Framebuffer picture = tracer.trace(scene, camera, quality);
      const Color shown = Eigen::Map<const Color>(picture.at(4, 4));
      EXPECT_TRUE(shown.isApprox(scene.materials[z > 0.0f ? 1 : 0].emission, 1e-4f)) << z;
    }
  }
}

// Where samples of a pixel are shaded together, and pixels share occlusion of the sky.
TEST(Tracer, GivesTheSameDraftWhenItTracesTheRaysThatMeetNothingToo) {
  Tracer tracer;
  for (unsigned seed = 0; seed < trials; ++seed) {
    const Scene scene = random_figure(seed);
    const Camera camera = random_view(seed);
    Quality quality = draft_quality();
    quality.samples_per_pixel = 1 + static_cast<int>(seed % 2);
    quality.seed = seed;
    const Framebuffer quick = tracer.trace(scene, camera, quality);
    quality.exhaustive = true;
    EXPECT_EQ(tracer.trace(scene, camera, quality), quick) << "seed " << seed;
  }
}

// Thin limbs and a broad light: little is known to be touched, and half shadows are wide.
Scene twigs(unsigned seed) {
  std::mt19937 random(500 + seed);
  std::uniform_real_distribution<float> uniform(-0.5f, 0.5f);
  Scene scene;
  scene.materials = {Material{}};
  for (int i = 0; i < 3; ++i) {
    const Vec3 place{uniform(random), 0.8f + uniform(random), uniform(random)};
    scene.solids.spheres.push_back({place, 0.01f});
    scene.solids.spheres.push_back({place + Vec3{0.2f, 0.1f, 0.1f}, 0.12f});
  }
  scene.sky = even_sky(Color::Zero());
  scene.lights = {{.centre = {0.5f, 2.5f, 0.2f},
                   .half_u = {seed % 3 == 1 ? 0.1f : 1.2f, 0.0f, 0.0f},
                   .half_v = {0.0f, 0.0f, seed % 3 == 0 ? 0.1f : 1.2f},
                   .radiance = Color::Constant(20.0f)}};
  return scene;
}

TEST(Tracer, LosesNoShadowOfThinLimbsToItsShortcuts) {
  Tracer tracer;
  for (const int samples : {1, 2, 3, 8}) {
    for (unsigned seed = 0; seed < 6; ++seed) {
      const Scene scene = twigs(seed);
      const Camera camera{.position = {0.5f, 1.6f, 2.6f},
                          .target = {0.0f, 0.3f, 0.0f},
                          .vertical_field_of_view = 0.8f,
                          .width = 241,
                          .height = 161};
      Quality quality{.samples_per_pixel = samples,
                      .floor_sharing_pixels = samples == 3 ? 0 : 2,
                      .filter_width = 1.0f,
                      .seed = seed};
      const Framebuffer quick = tracer.trace(scene, camera, quality);
      quality.exhaustive = true;
      EXPECT_EQ(tracer.trace(scene, camera, quality), quick)
          << "seed " << seed << ", " << samples << " samples";
    }
  }
}

// Under a light that is broad one way, and both ways.
class FewSamples : public testing::TestWithParam<unsigned> {};

TEST_P(FewSamples, DrawInTheMeanWhatManyShow) {
  Scene scene = twigs(GetParam());
  scene.sky = even_sky(Color::Constant(0.4f));
  scene.lights[0].centre.y() = 4.0f;
  scene.solids.spheres.push_back({{0.0f, 0.5f, 0.0f}, 0.2f});
  const Camera camera{.position = {0.5f, 1.6f, 2.6f},
                      .target = {0.0f, 0.3f, 0.0f},
                      .vertical_field_of_view = 0.7f,
                      .width = 120,
                      .height = 80};
  Quality many = final_quality();
  many.floor_sky_tolerance = 0.0f;
  const BlockMeans expected = mean_of_pictures({scene, camera, many, {}, {}}, 1000, 80);
  for (const int samples : {1, 2}) {
    Quality few = draft_quality();
    few.samples_per_pixel = samples;
    few.floor_sky_tolerance = 0.0f;
    few.figure_sharing_pixels = few.floor_sharing_pixels = 0;  // biased within bounds (contract.h)
    const BlockMeans found = mean_of_pictures({scene, camera, few, {}, {}}, 0, 300);
    const Eigen::ArrayXd error = (found.error.square() + expected.error.square()).sqrt();
    EXPECT_LT(((found.mean - expected.mean).abs() - 4.5 * error).maxCoeff(), 5e-5)
        << samples << " samples";
    EXPECT_GT(error.maxCoeff(), 3e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(Tracer, FewSamples, testing::Values(0u, 2u));

// Pictures that take long enough for every thread to draw some of it.
TEST(Tracer, GivesTheSamePictureWithAnyNumberOfThreads) {
  Tracer one({.threads = 1}), two({.threads = 2}), three({.threads = 3});
  for (unsigned seed = 0; seed < 3; ++seed) {
    const Scene scene = random_figure(seed);
    Camera camera = random_view(seed);
    camera.width = 400;
    camera.height = 300;
    const Framebuffer framebuffer = one.trace(scene, camera, standard_quality());
    EXPECT_EQ(two.trace(scene, camera, standard_quality()), framebuffer) << "seed " << seed;
    EXPECT_EQ(three.trace(scene, camera, standard_quality()), framebuffer) << "seed " << seed;
  }
}

/// A picture put together of its parts.
Framebuffer of_parts(Tracer& tracer, PreparedView ready, const Window& window) {
  Framebuffer framebuffer(window.width, window.height);
  tracer.draw(std::move(ready), [&](const RenderedRegion& part) {
    const Window& pixels = part.pixels;
    for (int y = 0; y < pixels.height; ++y)
      std::copy_n(part.framebuffer.at(pixels.x, pixels.y + y), 3 * pixels.width,
                  framebuffer.at(part.x, part.y + y));
  });
  return framebuffer;
}

// Other scenes before other cameras, so that the sets behind them are made meanwhile, too: some
// with solids, which are drawn for it.
TEST(Tracer, DrawsSeveralFramesOfAFilmAtATime) {
  const auto view = [](std::size_t number) {
    const auto seed = static_cast<unsigned>(number);
    View shown{random_figure(seed), random_view(seed), draft_quality()};
    if (seed % 3 == 1)
      shown.scene.static_solids.spheres = {{.centre = {0.5f, 0.3f, -1.0f}, .radius = 0.3f}};
    return shown;
  };
  for (const int threads : {1, 3}) {
    for (const std::size_t in_flight : {1u, 2u, 4u}) {
      Tracer tracer({.threads = threads});
      std::vector<PreparedView> ready(in_flight);
      std::vector<Framebuffer> framebuffers(trials);
      std::size_t ended = 0;
      const auto begin = [&](std::size_t frame) {
        if (frame == trials) return false;
        EXPECT_LT(frame - ended, in_flight);
        ready[frame % in_flight] = tracer.prepare(view(frame));
        return true;
      };
      const auto draw = [&](std::size_t frame) {
        framebuffers[frame] =
            of_parts(tracer, std::move(ready[frame % in_flight]), window_of(view(frame).camera));
      };
      const auto end = [&](std::size_t frame) { EXPECT_EQ(frame, ended++); };
      tracer.for_frames({begin, draw, end}, static_cast<int>(in_flight));
      ASSERT_EQ(ended, trials);
      for (std::size_t frame = 0; frame < trials; ++frame)
        EXPECT_EQ(framebuffers[frame], Tracer().render_view(view(frame)).color)
            << "frame " << frame << ", " << threads << " threads, " << in_flight << " in flight";
    }
  }
}

TEST(Tracer, HandsOnEachPartOnceWithItsLight) {
  Tracer tracer({.threads = 3});
  Camera camera = random_view(1);
  camera.width = 301;
  camera.height = 200;
  for (const Window& window : {Window{0, 0, 301, 200}, Window{7, 16, 281, 171}}) {
    camera.window = window;
    const View view{random_figure(1), camera, draft_quality()};
    std::vector<std::atomic<int>> times(static_cast<std::size_t>(window.width * window.height));
    tracer.draw(tracer.prepare(view), [&](const RenderedRegion& part) {
      for (int y = part.y; y < part.y + part.pixels.height; ++y)
        for (int x = part.x; x < part.x + part.pixels.width; ++x)
          ++times[static_cast<std::size_t>(y * window.width + x)];
    });
    EXPECT_EQ(std::count(times.begin(), times.end(), 1), std::ssize(times));
    EXPECT_EQ(of_parts(tracer, tracer.prepare(view), window), tracer.render_view(view).color);
  }
}

TEST(Tracer, GivesUpAFilmWhenWorkOnItFails) {
  Tracer tracer({.threads = 2});
  const auto fail = [](std::size_t frame) {
    if (frame == 3) throw std::runtime_error("no room");
  };
  const auto nothing = [](std::size_t) {};
  const auto ten = [](std::size_t frame) { return frame < 10; };
  const auto fail_to_begin = [&](std::size_t frame) {
    fail(frame);
    return true;
  };
  EXPECT_THROW(tracer.for_frames({fail_to_begin, nothing, nothing}, 2), std::runtime_error);
  EXPECT_THROW(tracer.for_frames({ten, fail, nothing}, 2), std::runtime_error);
  EXPECT_THROW(tracer.for_frames({ten, nothing, fail}, 2), std::runtime_error);
  const View view{random_figure(0), random_view(0), draft_quality()};
  EXPECT_THROW(tracer.draw(tracer.prepare(view), [&](const RenderedRegion&) { fail(3); }),
               std::runtime_error);
  EXPECT_EQ(tracer.render_view(view).color, Tracer().render_view(view).color);
}

TEST(Tracer, DrawsNothingThatIsNotReadyOrHasNoBackground) {
  Tracer tracer;
  const auto ignore = [](const RenderedRegion&) {};
  EXPECT_THROW(tracer.draw({}), std::logic_error);
  EXPECT_THROW(tracer.draw({}, ignore), std::logic_error);
  View view{random_figure(0), random_view(0), draft_quality()};
  view.quality.background = Background::transparent;
  EXPECT_THROW(tracer.draw(tracer.prepare(view), ignore), std::logic_error);
}

TEST(Tracer, GivesTheSamePictureWithAnyInstructionSet) {
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this machine has no avx2 instructions";
  Tracer narrow({.instruction_set = "sse2"}), wide({.instruction_set = "avx2"});
  for (unsigned seed = 0; seed < trials; ++seed) {
    const Scene scene = random_figure(seed);
    EXPECT_EQ(narrow.trace(scene, random_view(seed), draft_quality()),
              wide.trace(scene, random_view(seed), draft_quality()))
        << "seed " << seed;
  }
}

TEST(Tracer, GivesAnotherNoisePatternToAnotherSeed) {
  Tracer tracer;
  const Scene scene = random_figure(0);
  EXPECT_NE(tracer.trace(scene, random_view(1), {.seed = 1}),
            tracer.trace(scene, random_view(1), {.seed = 2}));
}

// Under lights alone: of the sky a figure hides a little everywhere.
TEST(Tracer, ShowsNothingOfAFigureFarAway) {
  Tracer tracer;
  for (unsigned seed = 0; seed < 3; ++seed) {
    Scene scene = random_figure(seed);
    scene.sky.zenith = scene.sky.horizon = scene.sky.below = Color::Zero();
    const Camera camera{.width = 75, .height = 50};
    const Framebuffer alone = tracer.trace(scene, camera, {});
    scene.solids.spheres.push_back({.centre = {0.0f, 1.0f, 60.0f}, .radius = 0.5f});
    EXPECT_EQ(tracer.trace(scene, camera, {}), alone) << "seed " << seed;
    scene.solids.spheres.back().centre = {0.0f, 1.0f, 0.0f};
    EXPECT_NE(tracer.trace(scene, camera, {}), alone) << "seed " << seed;
  }
}

TEST(Tracer, ShowsTheBackdropWhereNoFigureStands) {
  Scene scene = one_sphere();
  scene.sky.backdrop_horizon = scene.sky.backdrop_zenith = {0.1f, 0.2f, 0.3f};
  const Framebuffer framebuffer = Tracer().trace(scene, {.width = 96, .height = 54}, {});
  for (int y = 0; y < framebuffer.height; ++y)
    for (const int x : {0, 1, 94, 95}) EXPECT_EQ(framebuffer.at(x, y)[2], 0.3f);
}

TEST(Tracer, RefusesADegenerateSceneByTheNameOfItsMember) {
  Scene scene = one_sphere();
  scene.solids.spheres[0].material = 1;
  try {
    Tracer().trace(scene, {}, {});
    ADD_FAILURE() << "nothing was refused";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "spheres[0].material: out of range");
  }
  EXPECT_THROW(Tracer().trace(one_sphere(), {}, {.samples_per_pixel = 0}), std::invalid_argument);
}

TEST(Tracer, RefusesAnInstructionSetThatEmbreeDoesNotKnow) {
  EXPECT_NE(test::refusal_of([] { Tracer({.instruction_set = "mmx"}); }).find("\"mmx\""),
            std::string::npos);
}

}  // namespace
}  // namespace mien::render
