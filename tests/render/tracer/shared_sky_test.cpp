#include "render/tracer/shared_sky.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include "render/block_means.h"
#include "render/tracer/contract.h"

namespace mien::render {
namespace {

constexpr float lacking = 0.4f;

/// Pixels in a column of a tile, one sample each.
class SharedSkyOfPixels : public testing::Test {
 protected:
  SharedSkyOfPixels() { sky_.begin_tile({32, 48, 16, 32}); }

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
    const int added = sky_.add(sample, surface);
    sky_.occlude(added, Color::Constant(share * lacking));
  }

  /// Share of the light that was subtracted from a pixel.
  float subtracted(int number) {
    return -pixels_[static_cast<std::size_t>(number)].figure[1] / (0.5f * lacking);
  }

  SharedSky sky_;
  std::array<Pixel, 16> pixels_;
};

TEST_F(SharedSkyOfPixels, IsTheMeanOfNeighbours) {
  const Vec3 normal = Vec3::UnitZ();
  for (int k = 0; k < 10; ++k) add(k, 3, normal, k == 2 ? 1.0f : 0.0f);
  sky_.subtract();
  // Pixel 0 has neighbours 0 to 3, pixel 2 has 0 to 5, pixel 5 has 2 to 8, and pixel 6 lacks
  // nothing.
  EXPECT_FLOAT_EQ(subtracted(0), 1.0f / 4.0f);
  EXPECT_FLOAT_EQ(subtracted(2), 1.0f / 6.0f);
  EXPECT_FLOAT_EQ(subtracted(5), 1.0f / 7.0f);
  EXPECT_EQ(subtracted(6), 0.0f);
}

TEST_F(SharedSkyOfPixels, IsOfOneSurface) {
  add(0, 3, Vec3::UnitZ(), 1.0f);
  add(1, 4, Vec3::UnitZ(), 0.0f);
  add(2, 3, Vec3::UnitX(), 0.25f);
  sky_.subtract();
  EXPECT_FLOAT_EQ(subtracted(0), 1.0f);
  EXPECT_EQ(subtracted(1), 0.0f) << "another part";
  EXPECT_FLOAT_EQ(subtracted(2), 0.25f) << "another side of the part";
}

TEST_F(SharedSkyOfPixels, BeginsAnewInEachTile) {
  add(0, 3, Vec3::UnitZ(), 1.0f);
  sky_.begin_tile({32, 48, 16, 32});
  add(1, 3, Vec3::UnitZ(), 0.0f);
  sky_.subtract();
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

/// Largest difference of a block of 10 x 10 pixels of two kinds of pictures beyond 4 standard
/// errors, as a share of the sky's light on the legs.
double bias_of(const View& view, const test::BlockMeans& expected) {
  const test::BlockMeans found = test::mean_of_pictures(view, 0, 150);
  const Eigen::ArrayXd error = (found.error.square() + expected.error.square()).sqrt();
  constexpr double sky_light = 0.5 * 0.4;  // albedo times about the mean radiance
  return ((found.mean - expected.mean).abs() - 4.0 * error).maxCoeff() / sky_light;
}

TEST(SharedSky, KeepsTheMeansOfBlocks) {
  const View shared = legs();
  ASSERT_TRUE(shared.quality.shares_figure_sky);
  View single = shared;
  single.quality.shares_figure_sky = false;
  const test::BlockMeans expected = test::mean_of_pictures(single, 1000, 150);
  EXPECT_LT(bias_of(shared, expected), figure_sky_bias.draft);
  // The test can fail: light of the sky that is dimmer by three times the bound is found.
  View dim = shared;
  const auto share = static_cast<float>(1.0 - 3.0 * figure_sky_bias.draft);
  for (Color* sky : {&dim.scene.sky.zenith, &dim.scene.sky.horizon, &dim.scene.sky.below})
    *sky *= share;
  EXPECT_GT(bias_of(dim, expected), figure_sky_bias.draft);
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

TEST(SharedSky, TakesMostOfTheNoise) {
  View single = legs();
  single.quality.shares_figure_sky = false;
  EXPECT_LT(variance_within(legs()), 0.2 * variance_within(single));
}

}  // namespace
}  // namespace mien::render
