#include "render/image/layers.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "render/file_damage.h"
#include "render/image/image_io.h"
#include "render/tracer/tracer.h"

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

TEST(Layers, OfReferenceQualityDifferInTheirLightAlone) {
  Quality reference = reference_quality();
  reference.samples_per_pixel = 16;
  Scene scene = two_balls();
  scene.static_solids.spheres = {{{-1.0f, 0.3f, 0.0f}, 0.3f, 1}};
  const Layers layers = Tracer().layers(scene, camera, reference);
  const Layers standard = Tracer().layers(scene, camera, {});
  EXPECT_EQ(layers.beauty, Tracer().trace(scene, camera, reference));
  EXPECT_NE(layers.beauty, standard.beauty);
  EXPECT_EQ(layers.albedo, standard.albedo);
  EXPECT_EQ(layers.normal, standard.normal);
  EXPECT_EQ(layers.depth, standard.depth);
}

TEST(Layers, CoverEachPixelAsMuchAsItsAlpha) {
  Quality quality{.samples_per_pixel = 16, .background = Background::transparent};
  Tracer tracer;
  const Layers layers = tracer.layers(two_balls(), camera, quality);
  const RenderTarget cut = tracer.render_view({two_balls(), camera, quality});
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

TEST(Layers, TellHowCapsulesTurnTrianglesStretchAndTheGroundGoesBy) {
  Scene now = two_balls();
  now.solids.spheres.clear();
  // A limb that points at the camera's right turns up about its start; a triangle grows from its
  // first corner.
  now.solids.round_cones = {{{-1.0f, 1.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 0.1f, 0.1f, 0, 0}};
  Mesh mesh;
  mesh.positions = {{0.5f, 0.5f, 0.0f}, {1.5f, 0.5f, 0.0f}, {0.5f, 1.5f, 0.0f}};
  mesh.normals.assign(3, Vec3::UnitZ());
  mesh.triangles = {{0, 1, 2}};
  mesh.material = 1;
  mesh.part = 1;
  now.solids.meshes = {mesh};
  Scene next = now;
  const float angle = 0.2f;
  next.solids.round_cones[0].end = {-1.0f + std::cos(angle), 1.0f + std::sin(angle), 0.0f};
  next.solids.meshes[0].positions[1].x() += 0.2f;
  next.ground.offset_z += 0.03f;
  const Layers layers = Tracer().layers(now, camera, {}, &next);
  const auto expect_motion = [&](int x, int y, const Vec3& there) {
    const auto image_point = project(camera, there);
    ASSERT_TRUE(image_point);
    EXPECT_NEAR(layers.motion[2 * place(x, y)], image_point->x() - static_cast<float>(x) - 0.5f,
                0.02f);
    EXPECT_NEAR(layers.motion[2 * place(x, y) + 1], image_point->y() - static_cast<float>(y) - 0.5f,
                0.02f);
  };
  const auto seen_at = [&](int x, int y) {
    const float* point = layers.position.at(x, y);
    return Vec3(point[0], point[1], point[2]);
  };
  int on_limb = 0, on_triangle = 0, on_ground = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Vec3 point = seen_at(x, y);
      const auto id = layers.parts.ranks[covered_ranks * place(x, y)];
      if (id.share > 0.99f && id.id == layer_id("target/head") && point.x() > -0.95f) {
        const Vec3 from = point - Vec3(-1.0f, 1.0f, 0.0f);
        const Vec3 turned = Eigen::AngleAxisf(angle, Vec3::UnitZ()) * from;
        expect_motion(x, y, Vec3(-1.0f, 1.0f, 0.0f) + turned);
        ++on_limb;
      } else if (id.share > 0.99f && id.id == layer_id("created/hand")) {
        expect_motion(x, y, point + Vec3(0.2f * (point.x() - 0.5f), 0.0f, 0.0f));
        ++on_triangle;
      } else if (id.share == 0.0f && layers.normal.at(x, y)[1] == 1.0f) {
        expect_motion(x, y, point + Vec3(0.0f, 0.0f, 0.03f));
        ++on_ground;
      }
    }
  }
  EXPECT_GT(on_limb, 10);
  EXPECT_GT(on_triangle, 10);
  EXPECT_GT(on_ground, 100);
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

TEST(Layers, AreWrittenAsOneFileThatStartsWithTheBeautyAndIsTheSameAtAnotherTime) {
  const Layers layers = Tracer().layers(two_balls(), camera, {.samples_per_pixel = 4});
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) /
                                     (std::to_string(::getpid()) + "-" + "mien-layers-test.exr");
  write_layers(file, layers);
  EXPECT_EQ(read_exr(file), layers.beauty);
  const std::vector<char> bytes = test::bytes_of(file);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // files count in seconds
  write_layers(file, layers);
  EXPECT_EQ(test::bytes_of(file), bytes);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace mien::render
