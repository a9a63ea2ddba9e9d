#include "render/layers.h"

#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "render/image_io.h"
#include "render/tracer.h"

namespace mien::render {
namespace {

// The example of the Cryptomatte specification.
TEST(LayerId, IsTheOneThatCryptomatteGives) {
  EXPECT_EQ(layer_id("bunny"), 0x13851a76u);
  EXPECT_EQ(layer_id("default"), 0x42c9679fu);
}

Scene two_balls() {
  Scene scene;
  scene.materials = {{.albedo = {0.8f, 0.2f, 0.1f}}, {.albedo = {0.1f, 0.3f, 0.9f}}};
  scene.figures = {{"target"}, {"created"}};
  scene.parts = {{"head", 0}, {"hand", 1}};
  scene.solids.spheres = {{{0.0f, 1.0f, 0.0f}, 0.5f, 0, 0}, {{0.9f, 1.0f, -0.5f}, 0.4f, 1, 1}};
  return scene;
}

const Camera camera{
    .position = {0.0f, 1.0f, 5.0f}, .target = {0.0f, 1.0f, 0.0f}, .width = 64, .height = 48};

std::size_t place(int x, int y) { return static_cast<std::size_t>(y * camera.width + x); }

TEST(Layers, TellWhatIsSeenAndWhere) {
  const Layers layers = Tracer().layers(two_balls(), camera, {});
  EXPECT_EQ(layers.beauty, Tracer().trace(two_balls(), camera, {}));
  // The middle of the film looks at the nearest point of the first ball.
  const std::size_t middle = place(32, 24);
  EXPECT_NEAR(layers.depth[middle], 4.5f, 0.01f);
  EXPECT_NEAR(layers.position.at(32, 24)[2], 0.5f, 0.01f);
  EXPECT_NEAR(layers.normal.at(32, 24)[2], 1.0f, 0.01f);
  EXPECT_NEAR(layers.albedo.at(32, 24)[0], 0.8f, 1e-5f);
  EXPECT_EQ(layers.parts.ranks[covered_ranks * middle].id, layer_id("target/head"));
  EXPECT_NEAR(layers.parts.ranks[covered_ranks * middle].share, 1.0f, 1e-5f);
  EXPECT_EQ(layers.figures.ranks[covered_ranks * middle].id, layer_id("target"));
  // Above, the backdrop; below, the floor.
  EXPECT_TRUE(std::isinf(layers.depth[place(32, 0)]));
  EXPECT_EQ(layers.normal.at(2, 46)[1], 1.0f);
  EXPECT_EQ(layers.samples[place(32, 0)], 0.0f);
  EXPECT_GT(layers.samples[middle], 0.0f);
}

TEST(Layers, CoverEachPixelAsMuchAsItsAlpha) {
  Quality quality{.samples_per_pixel = 16, .background = Background::transparent};
  Tracer tracer;
  const Layers layers = tracer.layers(two_balls(), camera, quality);
  const Exposure cut = tracer.expose(two_balls(), camera, quality);
  bool both = false;
  for (std::size_t i = 0; i < cut.alpha.size(); ++i) {
    float sum = 0.0f;
    int kinds = 0;
    for (std::size_t k = 0; k < covered_ranks; ++k) {
      const Coverage& coverage = layers.figures.ranks[covered_ranks * i + k];
      sum += coverage.share;
      kinds += coverage.share > 0.0f ? 1 : 0;
    }
    EXPECT_NEAR(sum, cut.alpha[i], 1e-5f);
    both = both || kinds == 2;
  }
  EXPECT_TRUE(both);  // where one ball's rim is before the other
}

TEST(Layers, TellWhereEachPointGoes) {
  const Scene now = two_balls();
  Scene next = now;
  for (Sphere& sphere : next.solids.spheres) sphere.centre.x() += 0.2f;
  const Layers still = Tracer().layers(now, camera, {}, &now);
  const Layers moving = Tracer().layers(now, camera, {}, &next);
  const auto expected = project(camera, {0.2f, 1.0f, 0.5f})->x() - 32.0f;
  EXPECT_NEAR(moving.motion[2 * place(32, 24)], expected, 0.05f);
  EXPECT_NEAR(moving.motion[2 * place(32, 24) + 1], 0.0f, 0.01f);
  EXPECT_NEAR(moving.motion[2 * place(4, 44)], 0.0f, 1e-3f);  // the floor stays
  for (const float step : still.motion) EXPECT_NEAR(step, 0.0f, 2e-3f);

  Camera beside = camera;
  beside.position.x() += 0.1f;
  beside.target.x() += 0.1f;
  const Layers passed = Tracer().layers(now, camera, {}, nullptr, &beside);
  const float* floor = passed.position.at(4, 44);
  const auto there = project(beside, {floor[0], floor[1], floor[2]});
  EXPECT_NEAR(passed.motion[2 * place(4, 44)], there->x() - 4.5f, 1e-3f);
  EXPECT_NEAR(passed.motion[2 * place(32, 0)], 0.0f, 0.01f);  // the backdrop is far off
}

TEST(Layers, KnowWhereNoiseIs) {
  Scene scene = two_balls();
  scene.lights = {
      softbox({2.0f, 4.0f, 2.0f}, {0.0f, 1.0f, 0.0f}, 2.0f, 2.0f, Color::Constant(8.0f))};
  const Layers layers = Tracer().layers(scene, camera, {.samples_per_pixel = 4});
  EXPECT_EQ(layers.variance[place(32, 0)], 0.0f);
  float largest = 0.0f;
  for (const float variance : layers.variance) largest = std::max(largest, variance);
  EXPECT_GT(largest, 1e-6f);
}

TEST(Layers, AreWrittenAsOneFileThatStartsWithTheBeauty) {
  const Layers layers = Tracer().layers(two_balls(), camera, {.samples_per_pixel = 4});
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) /
                                     (std::to_string(::getpid()) + "-" + "mien-layers-test.exr");
  write_layers(file, layers);
  EXPECT_EQ(read_exr(file), layers.beauty);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace mien::render
