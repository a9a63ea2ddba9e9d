#include "render/light/line_shadow.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "render/geometry/shadow_mask.h"
#include "render/light/one_by_one.h"
#include "render/math/constants.h"

namespace mien::render {
namespace {

class LineShadow : public testing::Test {
 protected:
  float uniform(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }

  AreaLight any_light() {
    const Vec3 centre{uniform(-2, 2), uniform(2, 5), uniform(-2, 2)};
    return softbox(centre, {uniform(-1, 1), 0.0f, uniform(-1, 1)}, uniform(0.5f, 3.0f),
                   uniform(0.5f, 2.0f), Color::Ones());
  }

  /// In the floor or above it, thick or thin, sphere, cylinder or cone.
  PreparedCone any_solid(int kind) {
    const float radius = uniform(0.005f, 0.2f);
    const Vec3 start{uniform(-1, 1), uniform(-0.1f, 1.3f), uniform(-1, 1)};
    if (kind == 0) return prepared_cone(Sphere{start, radius});
    Vec3 end = start + Vec3{uniform(-0.6f, 0.6f), uniform(-0.3f, 0.4f), uniform(-0.6f, 0.6f)};
    return prepared_cone(RoundCone{start, end, radius, kind == 1 ? radius : uniform(0.005f, 0.2f)});
  }

  /// A point of the floor in the solid's shadow, or near it.
  Vec3 point_in_shadow(const AreaLight& light, const PreparedCone& solid) {
    const Vec3 from =
        light.centre + uniform(-1.2f, 1.2f) * light.half_u + uniform(-1.0f, 1.0f) * light.half_v;
    const Vec3 through = solid.a + uniform(0, 1) * solid.axis +
                         Vec3{uniform(-0.1f, 0.1f), 0.0f, uniform(-0.1f, 0.1f)};
    const Vec3 down = through - from;
    Vec3 point = from - (from.y() / down.y()) * down;
    point.y() = 0.0f;
    return point;
  }

  std::mt19937 random_{5};
};

bool is_hidden(const PreparedCone& solid, const Vec3& origin, const Vec3& direction) {
  const RayLanes ray{&origin.x(),    &origin.y(),    &origin.z(),
                     &direction.x(), &direction.y(), &direction.z()};
  float enter = 0.0f, leave = 0.0f;
  intersect_lines(solid, ray, 1, &enter, &leave);
  return enter <= leave && leave > 0.0f;
}

TEST_F(LineShadow, HidesWhatRaysToTheLineFindHidden) {
  constexpr int rays = 200;
  constexpr float edge = 0.01f;  // of the line, where rounding decides
  int hidden = 0, wrong = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const AreaLight light = any_light();
    const PreparedCone solid = any_solid(trial % 3);
    if (!has_line_shadows(light, {&solid, 1})) continue;
    LaneVectors points;
    LaneFloats v;
    for (int i = 0; i < static_cast<int>(lanes); ++i) {
      const Vec3 anywhere{uniform(-3, 3), 0.0f, uniform(-3, 3)};
      points.set(i, i % 2 == 0 ? anywhere : point_in_shadow(light, solid));
      v[i] = uniform(0, 1);
    }
    const LightLines lines = lines_across(light, points, v);
    const LineIntervals parts = hidden_part(solid, points, lines).value_or(LineIntervals{});
    for (int i = 0; i < static_cast<int>(lanes); ++i) {
      for (int k = 0; k < rays; ++k) {
        const float t = (static_cast<float>(k) + 0.5f) / rays;
        const Vec3 towards = (lines.start.at(i) + t * lines.along).normalized();
        const bool found = is_hidden(solid, points.at(i), towards);
        hidden += found ? 1 : 0;
        if (std::abs(t - parts.first[i]) < edge || std::abs(t - parts.last[i]) < edge) continue;
        wrong += found != (t > parts.first[i] && t < parts.last[i]) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(hidden, 100000);
  EXPECT_LT(wrong, 50);  // points all but on a solid, where single precision ends
}

TEST_F(LineShadow, GivesTheLightOfAPart) {
  constexpr int steps = 1000;
  for (int trial = 0; trial < 200; ++trial) {
    const AreaLight light = any_light();
    LaneVectors points;
    LaneFloats v;
    points.set(0, {uniform(-3, 3), 0.0f, uniform(-3, 3)});
    v[0] = uniform(0, 1);
    const float first = uniform(0.0f, 0.8f), last = first + 0.2f;
    double sum = 0.0;
    for (int k = 0; k < steps; ++k) {
      const float t = first + (last - first) * (static_cast<float>(k) + 0.5f) / steps;
      const test::LightSample one = test::sample(light, points.at(0), {t, v[0]});
      sum += static_cast<double>(one.perpendicular.x() * std::max(one.towards.y(), 0.0f) / pi);
    }
    const double expected = sum * static_cast<double>(last - first) / steps;
    const LightLines lines = lines_across(light, points, v);
    EXPECT_NEAR(irradiance_of(lines, 0, {first, last}), expected, 1e-3 * expected + 1e-7);
  }
}

TEST_F(LineShadow, CountsWhatTwoSolidsHideOnce) {
  const AreaLight light = softbox({0, 3, 0}, {0, 0, 0.1f}, 2.0f, 1.0f, Color::Ones());
  LaneVectors points;
  const LightLines lines = lines_across(light, points, LaneFloats{});
  std::vector<LineInterval> parts = {{0.6f, 0.7f}, {0.1f, 0.3f}, {0.2f, 0.5f}, {0.25f, 0.3f}};
  EXPECT_FLOAT_EQ(irradiance_of_union(lines, 0, parts),
                  irradiance_of(lines, 0, {0.1f, 0.5f}) + irradiance_of(lines, 0, {0.6f, 0.7f}));
  std::vector<LineInterval> none;
  EXPECT_EQ(irradiance_of_union(lines, 0, none), 0.0f);
}

TEST_F(LineShadow, IsNotForSolidsBesideTheLight) {
  const AreaLight light = softbox({0, 2, 0}, {0, 0, 0.1f}, 1.0f, 1.0f, Color::Ones());
  const PreparedCone below = prepared_cone(Sphere{{0, 1, 0}, 0.2f});
  const PreparedCone beside = prepared_cone(Sphere{{3, 2, 0}, 0.2f});
  EXPECT_TRUE(has_line_shadows(light, {&below, 1}));
  EXPECT_FALSE(has_line_shadows(light, {&beside, 1}));
  const PreparedCone above = prepared_cone(Sphere{{0, 3, 0}, 0.2f});
  EXPECT_TRUE(has_line_shadows(light, {&above, 1}));
  EXPECT_TRUE(is_behind(light, above));
  EXPECT_FALSE(is_behind(light, beside) || is_behind(light, below));
  const AreaLight sunken = softbox({0, 0.3f, 3}, {0, 0.3f, 0}, 1.0f, 1.0f, Color::Ones());
  EXPECT_FALSE(has_line_shadows(sunken, {&below, 1}));
}

}  // namespace
}  // namespace mien::render
