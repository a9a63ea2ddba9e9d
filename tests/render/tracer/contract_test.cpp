// The fast renderer against camera and shadow rays alone, over whole pictures.

#include "render/tracer/contract.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "render/block_means.h"

namespace mien::render {
namespace {

using test::BlockMeans;
using test::mean_of_pictures;

/// A figure of two legs and a trunk that stands on the floor, a ball beside it, under two lights.
Scene standing_figure() {
  Scene scene;
  scene.materials = {{.albedo = {0.6f, 0.5f, 0.4f}},
                     {.albedo = {0.3f, 0.4f, 0.7f}, .specular_f0 = 0.04f}};
  scene.solids.round_cones = {{{0.12f, 0.05f, 0.05f}, {0.08f, 0.9f, 0.0f}, 0.05f, 0.07f, 0},
                              {{-0.12f, 0.05f, -0.1f}, {-0.08f, 0.9f, 0.0f}, 0.05f, 0.07f, 0},
                              {{0.0f, 0.95f, 0.0f}, {0.0f, 1.4f, 0.02f}, 0.12f, 0.14f, 1},
                              {{0.15f, 1.35f, 0.0f}, {0.35f, 0.9f, 0.2f}, 0.04f, 0.03f, 0}};
  scene.solids.spheres = {{{0.0f, 1.65f, 0.0f}, 0.11f, 1}, {{0.5f, 0.1f, 0.4f}, 0.1f, 0}};
  scene.lights = {
      softbox({2.0f, 3.5f, 2.0f}, {0.0f, 0.8f, 0.0f}, 1.2f, 0.9f, Color::Constant(9.0f)),
      softbox({-2.5f, 2.0f, 0.5f}, {0.0f, 0.8f, 0.0f}, 0.4f, 0.4f, Color::Constant(6.0f))};
  scene.sky.zenith = Color::Constant(0.5f);
  scene.sky.horizon = Color::Constant(0.35f);
  scene.sky.below = Color::Constant(0.1f);
  scene.ground.line_spacing = 0.5f;
  return scene;
}

const Camera watching{.position = {1.6f, 1.3f, 3.2f},
                      .target = {0.1f, 0.75f, 0.0f},
                      .vertical_field_of_view = 0.65f,
                      .width = 80,
                      .height = 60};

struct Case {
  std::string name;
  View view;
};

std::vector<Case> cases() {
  const View standing{standing_figure(), watching, {}, {}, {}};
  std::vector<Case> all = {{"standing", standing}};
  View close = standing;
  close.camera.position = {0.5f, 0.5f, 1.1f};
  close.camera.target = {0.1f, 0.1f, 0.1f};
  all.push_back({"feet", close});
  View blurred = standing;
  blurred.closing = blurred.scene;
  for (RoundCone& cone : blurred.closing->solids.round_cones) cone.end.x() += 0.1f;
  all.push_back({"blurred", blurred});
  View panned = standing;
  panned.closing_camera = panned.camera;
  panned.closing_camera->target.x() += 0.1f;
  all.push_back({"camera moves", panned});
  View faded = standing;
  faded.scene.figures[0].opacity = 0.6f;
  all.push_back({"overlay", faded});
  View walled = standing;
  walled.scene.static_solids.round_cones = {
      {{-0.8f, 0.2f, -0.8f}, {0.9f, 0.2f, -0.7f}, 0.2f, 0.15f, 0}};
  all.push_back({"static solid", walled});
  return all;
}

struct NamedQuality {
  const char* name;
  Quality quality;
  double floor_sky;  ///< the contract's bound
  int pictures;      ///< for the mean
};

std::vector<NamedQuality> qualities() {
  return {{"draft", draft_quality(), floor_sky_bias.draft, 120},
          {"standard", standard_quality(), floor_sky_bias.standard, 40}};
}

/// How two means compare.
struct Agreement {
  double worst;       ///< largest difference beyond the bound, in standard errors
  double chi_square;  ///< mean squared difference of blocks, in standard errors
  double resolution;  ///< largest standard error
};

Agreement agreement_of(const BlockMeans& found, const BlockMeans& expected, double bound) {
  // What floats round, and what is without noise.
  constexpr double rounding = 2e-5;
  const Eigen::ArrayXd error = (found.error.square() + expected.error.square()).sqrt() + rounding;
  const Eigen::ArrayXd difference = (found.mean - expected.mean).abs();
  return {((difference - bound).max(0.0) / error).maxCoeff(), (difference / error).square().mean(),
          error.maxCoeff()};
}

BlockMeans reference_means(const View& view) {
  View reference = view;
  reference.quality = reference_quality();
  reference.quality.samples_per_pixel = 16;
  return mean_of_pictures(reference, 1000, 60);
}

BlockMeans fast_means(const View& view, const NamedQuality& how, bool interpolates) {
  View fast = view;
  fast.quality = how.quality;
  if (!interpolates) fast.quality.floor_sky_tolerance = 0.0f;
  return mean_of_pictures(fast, 0, how.pictures);
}

// 48 blocks in each of 12 pictures: 5 standard errors of 40 and more seeds are met by chance in
// less than one run in a thousand.
constexpr double beyond_chance = 5.0;

/// Of the light of the sky on the floor of standing_figure (its sky and albedo).
constexpr double floor_sky_light = 0.45 * 0.5;

class Contract : public testing::TestWithParam<std::size_t> {};

TEST_P(Contract, HoldsPerBlock) {
  const Case now = cases()[GetParam()];
  const BlockMeans expected = reference_means(now.view);
  for (const NamedQuality& how : qualities()) {
    SCOPED_TRACE(now.name + std::string(", ") + how.name);
    const Agreement unbiased =
        agreement_of(fast_means(now.view, how, false), expected, floor_light_bias.standard);
    EXPECT_LT(unbiased.worst, beyond_chance);
    EXPECT_LT(unbiased.resolution, 0.004);
    const Agreement whole =
        agreement_of(fast_means(now.view, how, true), expected, how.floor_sky * floor_sky_light);
    EXPECT_LT(whole.worst, beyond_chance);
  }
}

INSTANTIATE_TEST_SUITE_P(Tracer, Contract, testing::Range(std::size_t{0}, cases().size()),
                         [](const auto& tested) {
                           std::string name = cases()[tested.param].name;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

// The differences of blocks scatter as their standard errors say: their squares have mean 1.
TEST(ContractStatistics, DifferencesScatterAsTheirErrors) {
  const View view = cases().front().view;
  const Agreement found =
      agreement_of(fast_means(view, qualities().back(), false), reference_means(view), 0.0);
  EXPECT_LT(found.chi_square, 1.7);
  EXPECT_GT(found.chi_square, 0.2);
}

// The tests can fail: a light that is dimmer by twice the bound of the floor's light is found, and
// so is a shadow that is missing.
TEST(ContractStatistics, APlantedBiasIsFound) {
  const View view = cases().front().view;
  const BlockMeans expected = reference_means(view);
  View dim = view;
  dim.scene.lights[0].radiance *= 0.98f;
  const Agreement dimmed =
      agreement_of(fast_means(dim, qualities().back(), false), expected, floor_light_bias.standard);
  EXPECT_GT(dimmed.worst, beyond_chance);
  View less = view;
  less.scene.solids.spheres.pop_back();
  const Agreement shadowless = agreement_of(fast_means(less, qualities().back(), true), expected,
                                            floor_sky_bias.standard * floor_sky_light);
  EXPECT_GT(shadowless.worst, beyond_chance);
}

TEST(ContractStatistics, BoundsOnlyWhatIsBiased) {
  for (const ContractRow& row : contract) {
    SCOPED_TRACE(row.quantity);
    const bool bounded = row.bound.draft > 0.0 && row.bound.standard > 0.0 && row.bound.final > 0.0;
    EXPECT_EQ(bounded, row.accuracy == Accuracy::biased);
    EXPECT_LE(row.bound.final, row.bound.standard);
    EXPECT_LE(row.bound.standard, row.bound.draft);
    EXPECT_FALSE(row.test.empty());
  }
}

}  // namespace
}  // namespace mien::render
