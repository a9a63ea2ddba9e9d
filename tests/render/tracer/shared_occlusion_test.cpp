#include "render/tracer/shared_occlusion.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include "render/block_means.h"
#include "render/math/constants.h"
#include "render/tracer/contract.h"

namespace mien::render {
namespace {

constexpr float lacking = 0.4f;

/// Pixels in a column of a tile, one sample each.
class SharedOcclusionOfPixels : public testing::Test {
 protected:
  SharedOcclusionOfPixels() { shared_.begin_tile({32, 48, 16, 32}); }

  /// Adds a sample; of the light `lacking` it lacks that share.
  void add(int number, int part, const Vec3& normal, float share) {
    Pixel& pixel = pixels_[static_cast<std::size_t>(number)];
    pixel.x = 34;
    pixel.y = 16 + number;
    Sample sample;
    sample.pixel = &pixel;
    Surface surface;
    surface.normal = normal;
    surface.albedo = Color::Constant(0.5f);
    surface.part = part;
    const int added = shared_.add_figure(sample, surface);
    shared_.occlude(added, Color::Constant(share * lacking));
  }

  /// Adds a sample of the floor, of two pixels' albedo.
  void add_floor(int number, float share) {
    for (Pixel* pixel : {&pixels_[static_cast<std::size_t>(number)],
                         &partners_[static_cast<std::size_t>(number)]}) {
      pixel->x = pixel == &pixels_[static_cast<std::size_t>(number)] ? 34 : 35;
      pixel->y = 16 + number;
    }
    Sample sample;
    sample.pixel = &pixels_[static_cast<std::size_t>(number)];
    sample.pixel->floor_albedo = Color::Constant(0.5f);
    sample.partner = &partners_[static_cast<std::size_t>(number)];
    sample.partner->floor_albedo = Color::Constant(0.25f);
    sample.partner_weight = 1.0f;
    shared_.occlude(shared_.add_floor(sample), Color::Constant(share * lacking));
  }

  /// Share of the light that was subtracted from a pixel.
  float subtracted(int number) {
    return -pixels_[static_cast<std::size_t>(number)].figure[1] / (0.5f * lacking);
  }

  SharedOcclusion shared_;
  std::array<Pixel, 16> pixels_;
  std::array<Pixel, 16> partners_;
};

TEST_F(SharedOcclusionOfPixels, IsTheMeanOfNeighbours) {
  const Vec3 normal = Vec3::UnitZ();
  for (int k = 0; k < 10; ++k) add(k, 3, normal, k == 2 ? 1.0f : 0.0f);
  shared_.subtract();
  // Pixel 0 has neighbours 0 to 3, pixel 2 has 0 to 5, pixel 5 has 2 to 8, and pixel 6 lacks
  // nothing.
  EXPECT_FLOAT_EQ(subtracted(0), 1.0f / 4.0f);
  EXPECT_FLOAT_EQ(subtracted(2), 1.0f / 6.0f);
  EXPECT_FLOAT_EQ(subtracted(5), 1.0f / 7.0f);
  EXPECT_EQ(subtracted(6), 0.0f);
}

TEST_F(SharedOcclusionOfPixels, IsOfOneSurface) {
  add(0, 3, Vec3::UnitZ(), 1.0f);
  add(1, 4, Vec3::UnitZ(), 0.0f);
  add(2, 3, Vec3::UnitX(), 0.25f);
  shared_.subtract();
  EXPECT_FLOAT_EQ(subtracted(0), 1.0f);
  EXPECT_EQ(subtracted(1), 0.0f) << "another part";
  EXPECT_FLOAT_EQ(subtracted(2), 0.25f) << "another side of the part";
}

// On the floor, within 2 rows; at the rim of the tile less, so that means shift little.
TEST_F(SharedOcclusionOfPixels, OfTheFloorHasItsOwnReachAndEachPixelsAlbedo) {
  for (int k : {5, 0, 1, 2, 3, 4, 6, 7}) add_floor(k, k == 2 ? 1.0f : 0.0f);
  add(8, 0, Vec3::UnitY(), 1.0f);
  shared_.subtract();
  const auto floor = [&](int number) {
    return -pixels_[static_cast<std::size_t>(number)].set[1] / (0.5f * lacking);
  };
  EXPECT_EQ(floor(0), 0.0f) << "1 row at the rim";
  EXPECT_FLOAT_EQ(floor(1), 1.0f / 3.0f);
  EXPECT_FLOAT_EQ(floor(2), 1.0f / 5.0f);
  EXPECT_FLOAT_EQ(floor(4), 1.0f / 5.0f);
  EXPECT_EQ(floor(5), 0.0f);
  EXPECT_FLOAT_EQ(-partners_[4].set[1] / (0.25f * lacking), 1.0f / 5.0f);
  EXPECT_EQ(subtracted(4), 0.0f) << "nothing of the figure's light";
  EXPECT_EQ(floor(7), 0.0f) << "a figure's light beside it";
}

TEST_F(SharedOcclusionOfPixels, BeginsAnewInEachTile) {
  add(0, 3, Vec3::UnitZ(), 1.0f);
  shared_.begin_tile({32, 48, 16, 32});
  add(1, 3, Vec3::UnitZ(), 0.0f);
  shared_.subtract();
  EXPECT_EQ(subtracted(0), 0.0f);
  EXPECT_EQ(subtracted(1), 0.0f);
}

/// Two legs side by side, close up, before an empty background: most of the light comes from the
/// sky, of which they hide much from each other.
View legs() {
  Scene scene;
  scene.materials = {{.albedo = {0.6f, 0.5f, 0.4f}}};
  scene.has_ground = false;
  scene.solids.round_cones = {{{0.06f, 0.05f, 0.05f}, {0.08f, 0.9f, 0.0f}, 0.05f, 0.07f, 0},
                              {{-0.06f, 0.05f, -0.05f}, {-0.08f, 0.9f, 0.0f}, 0.05f, 0.07f, 0}};
  scene.sky.zenith = Color::Constant(0.5f);
  scene.sky.horizon = scene.sky.below = Color::Constant(0.35f);
  const Camera camera{.position = {0.9f, 0.8f, 1.6f},
                      .target = {0.0f, 0.5f, 0.0f},
                      .vertical_field_of_view = 0.5f,
                      .width = 160,
                      .height = 120};
  return {scene, camera, draft_quality(), {}, {}};
}

/// A ball of triangles above the floor, close up, under a small and a wide light.
View ball_of_triangles() {
  constexpr int around = 24, latitudes = 13;
  Mesh mesh;
  for (int row = 0; row < latitudes; ++row) {
    const float polar = pi * static_cast<float>(row) / (latitudes - 1);
    for (int k = 0; k < around; ++k) {
      const float angle = 2.0f * pi * static_cast<float>(k) / around;
      const Vec3 unit{std::sin(polar) * std::cos(angle), std::cos(polar),
                      std::sin(polar) * std::sin(angle)};
      mesh.positions.push_back(Vec3{0.0f, 0.12f, 0.0f} + 0.1f * unit);
      mesh.normals.push_back(unit);
    }
  }
  for (int row = 0; row + 1 < latitudes; ++row)
    for (int k = 0; k < around; ++k) {
      const int a = row * around + k, b = row * around + (k + 1) % around;
      mesh.triangles.push_back({a, b, b + around});
      mesh.triangles.push_back({a, b + around, a + around});
    }
  Scene scene;
  scene.materials = {{.albedo = {0.6f, 0.5f, 0.4f}}};
  scene.solids.meshes = {mesh};
  scene.lights = {
      softbox({1.0f, 2.0f, 0.6f}, {0.0f, 0.1f, 0.0f}, 0.2f, 0.2f, Color::Constant(60.0f)),
      softbox({-1.5f, 2.0f, 0.5f}, {0.0f, 0.1f, 0.0f}, 1.2f, 1.2f, Color::Constant(2.0f))};
  scene.sky.zenith = scene.sky.horizon = scene.sky.below = Color::Constant(0.05f);
  scene.ground.line_spacing = 0.0f;
  const Camera camera{.position = {0.5f, 0.9f, 1.6f},
                      .target = {-0.1f, 0.05f, -0.05f},
                      .vertical_field_of_view = 0.35f,
                      .width = 160,
                      .height = 120};
  return {scene, camera, draft_quality(), {}, {}};
}

/// Largest difference of a block of 10 x 10 pixels of two kinds of pictures beyond 4 standard
/// errors, as a share of some light.
double bias_of(const View& view, const test::BlockMeans& expected, double light) {
  const test::BlockMeans found = test::mean_of_pictures(view, 0, 150);
  const Eigen::ArrayXd error = (found.error.square() + expected.error.square()).sqrt();
  return ((found.mean - expected.mean).abs() - 4.0 * error).maxCoeff() / light;
}

TEST(SharedOcclusion, KeepsTheMeansOfBlocks) {
  const View shared = legs();
  ASSERT_TRUE(shared.quality.shares_occlusion);
  View single = shared;
  single.quality.shares_occlusion = false;
  const test::BlockMeans expected = test::mean_of_pictures(single, 1000, 150);
  constexpr double sky_light = 0.5 * 0.4;  // albedo times about the mean radiance
  EXPECT_LT(bias_of(shared, expected, sky_light), figure_sky_bias.draft);
  // The test can fail: light of the sky that is dimmer by three times the bound is found.
  View dim = shared;
  const auto share = static_cast<float>(1.0 - 3.0 * figure_sky_bias.draft);
  for (Color* sky : {&dim.scene.sky.zenith, &dim.scene.sky.horizon, &dim.scene.sky.below})
    *sky *= share;
  EXPECT_GT(bias_of(dim, expected, sky_light), figure_sky_bias.draft);
}

TEST(SharedOcclusion, KeepsTheMeansOfTheFloorsShadows) {
  const View shared = ball_of_triangles();
  View single = shared;
  single.quality.shares_occlusion = false;
  const test::BlockMeans expected = test::mean_of_pictures(single, 1000, 150);
  const double lit = expected.mean.maxCoeff();
  EXPECT_LT(bias_of(shared, expected, lit), floor_shadow_bias.draft);
  // The test can fail: the shadow of a ball that is smaller by a tenth is found.
  View small = shared;
  for (Vec3& position : small.scene.solids.meshes[0].positions)
    position = Vec3{0.0f, 0.12f, 0.0f} + 0.9f * (position - Vec3{0.0f, 0.12f, 0.0f});
  EXPECT_GT(bias_of(small, expected, lit), floor_shadow_bias.draft);
}

/// Mean variance, over pictures of different noise, of the pixels that show nothing but the figure.
double variance_within(View view) {
  constexpr int pictures = 40;
  view.quality.background = Background::transparent;
  Eigen::ArrayXd sum, squares, covered;
  Tracer tracer;
  for (int k = 0; k < pictures; ++k) {
    view.quality.seed = static_cast<std::uint64_t>(k);
    const RenderTarget target = tracer.render_view(view);
    const auto count = static_cast<Eigen::Index>(target.alpha.size());
    if (k == 0) sum = squares = covered = Eigen::ArrayXd::Zero(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto light = static_cast<double>(target.color.channels[3 * static_cast<size_t>(i)]);
      sum[i] += light;
      squares[i] += light * light;
      covered[i] += target.alpha[static_cast<size_t>(i)] == 1.0f ? 1.0 : 0.0;
    }
  }
  const Eigen::ArrayXd variance = squares / pictures - (sum / pictures).square();
  const Eigen::ArrayXd whole = (covered == pictures).select(Eigen::ArrayXd::Ones(sum.size()), 0.0);
  EXPECT_GT(whole.sum(), 1000.0);
  return (variance * whole).sum() / whole.sum();
}

TEST(SharedOcclusion, TakesMostOfTheNoise) {
  View single = legs();
  single.quality.shares_occlusion = false;
  EXPECT_LT(variance_within(legs()), 0.2 * variance_within(single));
}

}  // namespace
}  // namespace mien::render
