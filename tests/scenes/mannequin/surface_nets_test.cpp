#include "scenes/mannequin/surface_nets.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "scenes/closed_surface.h"
#include "scenes/mannequin/mannequin.h"
#include "scenes/mannequin/sdf_primitive.h"

namespace mien::scenes {
namespace {

using motion::Vec3;

std::vector<double> planes(double low, double high, int count) {
  std::vector<double> result;
  for (int i = 0; i < count; ++i) result.push_back(low + (high - low) * i / (count - 1));
  return result;
}

Grid cube_grid(double half, int count) {
  const std::vector<double> axis = planes(-half, half, count);
  return {axis, axis, axis};
}

double volume_of(const Surface& surface) {
  double six_volumes = 0.0;
  for (const auto& t : surface.triangles) {
    const auto at = [&](size_t k) { return surface.positions[static_cast<size_t>(t[k])]; };
    six_volumes += at(0).dot(at(1).cross(at(2)));
  }
  return six_volumes / 6.0;
}

TEST(SurfaceNets, OfABallAreABallWithItsNormalsOutward) {
  const Surface ball =
      surface_nets([](const Vec3& p) { return p.norm() - 0.8; }, cube_grid(1.0, 30));
  const mien::test::Topology topology = mien::test::topology_of(ball.triangles);
  EXPECT_EQ(topology.bad_edges, 0);
  EXPECT_EQ(topology.euler, 2);
  for (size_t v = 0; v < ball.positions.size(); ++v) {
    EXPECT_NEAR(ball.positions[v].norm(), 0.8, 1e-6);
    EXPECT_GT(ball.normals[v].dot(ball.positions[v].normalized()), 0.9999);
  }
  const double exact = 4.0 / 3.0 * motion::pi * 0.8 * 0.8 * 0.8;
  EXPECT_NEAR(volume_of(ball) / exact, 1.0, 0.01);
}

TEST(SurfaceNets, OfARingHaveItsHole) {
  const auto ring = [](const Vec3& p) {
    return std::hypot(std::hypot(p.x(), p.z()) - 0.6, p.y()) - 0.2;
  };
  const mien::test::Topology topology =
      mien::test::topology_of(surface_nets(ring, cube_grid(1.0, 32)).triangles);
  EXPECT_EQ(topology.bad_edges, 0);
  EXPECT_EQ(topology.euler, 0);
}

TEST(TheLargestPiece, IsWhatIsLeftOfABallAndCrumbs) {
  const auto ball_and_crumbs = [](const Vec3& p) {
    const double crumbs = std::min((p - Vec3(0.8, 0, 0)).norm(), (p + Vec3(0.8, 0, 0)).norm());
    return std::min(p.norm() - 0.5, crumbs - 0.1);
  };
  const Surface all = surface_nets(ball_and_crumbs, cube_grid(1.0, 41));
  const Surface ball = largest_component(all);
  EXPECT_EQ(mien::test::topology_of(all.triangles).euler, 6);
  EXPECT_EQ(mien::test::topology_of(ball.triangles).euler, 2);
  EXPECT_EQ(mien::test::topology_of(ball.triangles).bad_edges, 0);
  EXPECT_EQ(ball.normals.size(), ball.positions.size());
  for (const Vec3& position : ball.positions) EXPECT_NEAR(position.norm(), 0.5, 1e-6);
}

TEST(SurfaceNets, AreWatertightWhateverTheSignsAre) {
  // Noise at the grid's own spacing: every ambiguous cell occurs, many times.
  for (int trial = 0; trial < 3; ++trial) {
    const auto noise = [trial](const Vec3& p) {
      const auto cell = [](double x) {
        return static_cast<std::uint64_t>(std::lround(x * 10.0) + 64);
      };
      std::mt19937_64 random(cell(p.x()) * 4096 + cell(p.y()) * 64 + cell(p.z()) +
                             1000000u * static_cast<std::uint64_t>(trial));
      const bool at_rim = p.cwiseAbs().maxCoeff() > 0.95;
      const double value = std::uniform_real_distribution<double>(-0.01, 0.01)(random);
      return at_rim ? std::abs(value) + 1e-4 : value;
    };
    const Surface surface = surface_nets(noise, cube_grid(1.0, 21));
    std::map<std::pair<int, int>, int> balance;
    for (const auto& t : surface.triangles) {
      for (size_t i = 0; i < 3; ++i) {
        const int a = t[i];
        const int b = t[(i + 1) % 3];
        balance[std::minmax(a, b)] += a < b ? 1 : -1;
      }
    }
    for (const auto& [edge, count] : balance) EXPECT_EQ(count, 0);
    EXPECT_GT(surface.triangles.size(), 1000u);
  }
}

TEST(Lumps, AreAsFarAwayAsTheyAre) {
  SdfPrimitive cone;
  cone.shape = SdfPrimitive::Shape::round_cone;
  cone.end = Vec3(2.0, 0.0, 0.0);
  cone.start_radius = 0.5;
  cone.end_radius = 0.2;
  EXPECT_NEAR(signed_distance(cone, Vec3(-1.0, 0.0, 0.0)), 0.5, 1e-12);
  EXPECT_NEAR(signed_distance(cone, Vec3(3.0, 0.0, 0.0)), 0.8, 1e-12);
  // The cone touches both balls: its slope is asin(0.3 / 2).
  const double slope = std::asin(0.15);
  const Vec3 normal(std::sin(slope), std::cos(slope), 0.0);
  for (const double t : {0.2, 0.5, 0.8}) {
    const Vec3 on_axis(2.0 * t, 0.0, 0.0);
    const Vec3 surface = on_axis + (0.5 - 0.3 * t) * normal;
    EXPECT_NEAR(signed_distance(cone, surface), 0.0, 1e-12);
    EXPECT_NEAR(signed_distance(cone, surface + 0.3 * normal), 0.3, 1e-12);
  }
  SdfPrimitive egg;
  egg.radii = Vec3(1.0, 0.5, 0.25);
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 1)}) {
    const Vec3 surface = direction / direction.cwiseQuotient(egg.radii).norm();
    EXPECT_NEAR(signed_distance(egg, surface), 0.0, 1e-12);
    EXPECT_LT(signed_distance(egg, 0.9 * surface), 0.0);
    EXPECT_GT(signed_distance(egg, 1.1 * surface), 0.0);
  }
}

TEST(TheSmoothMinimum, IsTheMinimumWhereNothingBlends) {
  EXPECT_DOUBLE_EQ(smooth_minimum(1.0, 2.0, 0.5), 1.0);
  EXPECT_DOUBLE_EQ(smooth_minimum(2.0, 1.0, 0.5), 1.0);
  EXPECT_DOUBLE_EQ(smooth_minimum(1.0, 1.0, 0.4), 0.9);
}

}  // namespace
}  // namespace mien::scenes
