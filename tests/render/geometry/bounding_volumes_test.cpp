#include "render/geometry/bounding_volumes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "render/geometry/embree_scene.h"
#include "render/math/constants.h"

namespace mien::render {
namespace {

TEST(MayMeet, HoldsForEveryRayTowardsAPointInTheSphere) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> share(-1.0f, 1.0f);
  const auto point = [&](float reach) {
    return Vec3(reach * share(random), reach * share(random), reach * share(random));
  };
  int missed = 0;
  for (int i = 0; i < 100'000; ++i) {
    const float reach = std::exp2(7.0f * share(random));  // 8 mm … 128 m
    const BoundingSphere sphere{point(5.0f), std::exp2(4.0f * share(random))};
    Vec3 within = point(1.0f);
    if (within.norm() > 1.0f) within.normalize();  // often at the very rim
    const Vec3 origin = point(reach);
    const Vec3 target = sphere.centre + sphere.radius * within;
    EXPECT_TRUE(may_intersect(sphere, origin, (target - origin).normalized()));
    missed += may_intersect(sphere, origin, point(1.0f).normalized()) ? 0 : 1;
  }
  EXPECT_GT(missed, 20'000);  // it does rule rays out
}

TEST(PixelMask, KnowsOfStretchesOfARowWhatItKnowsOfTheirPixels) {
  Solids solids;
  solids.spheres = {{{-0.5f, 1.0f, 0.0f}, 0.1f}, {{0.6f, 1.1f, 0.0f}, 0.15f}};
  Shapes shapes;
  shapes.cones = prepared_cones(solids);
  const Camera camera{.width = 64, .height = 48};
  const PixelMask mask(camera, shapes, 1.0f);
  int met = 0, between = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int begin = 0; begin < camera.width; ++begin) {
      bool any = false;
      for (int end = begin + 1; end <= camera.width; ++end) {
        any |= mask.may_intersect(end - 1, y);
        EXPECT_EQ(mask.may_intersect_row(begin, end, y), any) << begin << " … " << end << ", " << y;
        met += any ? 1 : 0;
        between += !any && mask.may_intersect_row(0, begin, y) && mask.may_intersect_row(end, 64, y)
                       ? 1
                       : 0;
      }
    }
  }
  EXPECT_GT(met, 1000);
  EXPECT_GT(between, 300);
}

/// The faces of a box, twelve triangles at a time.
std::vector<Triangle> faces_of(const Vec3& low, const Vec3& high) {
  const auto corner = [&](int bits) -> Vec3 {
    return {(bits & 1) != 0 ? high.x() : low.x(), (bits & 2) != 0 ? high.y() : low.y(),
            (bits & 4) != 0 ? high.z() : low.z()};
  };
  std::vector<Triangle> faces;
  for (int axis = 0; axis < 3; ++axis) {
    const int across = 1 << axis, along = 1 << ((axis + 1) % 3), up = 1 << ((axis + 2) % 3);
    for (const int side : {0, across}) {
      faces.push_back({corner(side), corner(side | along), corner(side | up)});
      faces.push_back({corner(side | along | up), corner(side | along), corner(side | up)});
    }
  }
  return faces;
}

/// Mean area that shapes cover when looked at from random directions, by parallel rays.
double mean_silhouette(const Shapes& shapes) {
  const EmbreeDevice device("");
  const EmbreeScene scene(device, shapes);
  const BoundingSphere bounds = bounding_sphere(shapes);
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  std::uniform_real_distribution<float> even(-1.0f, 1.0f);
  constexpr int packets = 50'000;
  int hits = 0;
  for (int k = 0; k < packets; ++k) {
    const Vec3 direction = Vec3(normal(random), normal(random), normal(random)).normalized();
    const Vec3 right = direction.unitOrthogonal(), up = direction.cross(right);
    RayPacket rays;
    while (rays.count < packet_size)
      rays.push(bounds.centre +
                    bounds.radius * (even(random) * right + even(random) * up - 2.0f * direction),
                direction, infinity);
    hits += std::popcount(scene.occluded(rays));
  }
  const double side = 2.0 * static_cast<double>(bounds.radius);
  return side * side * hits / (static_cast<double>(packets) * packet_size);
}

double sum_of_silhouettes(const std::vector<FigurePiece>& pieces) {
  double sum = 0.0;
  for (const FigurePiece& piece : pieces) sum += static_cast<double>(piece.silhouette);
  return sum;
}

TEST(FigurePieces, HaveTheSilhouettesOfConvexSolids) {
  Solids ball, cone;
  ball.spheres = {{{0.3f, 1.0f, -0.2f}, 0.4f}};
  cone.round_cones = {{{0.0f, 0.2f, 0.0f}, {0.3f, 1.0f, 0.2f}, 0.1f, 0.06f}};
  Shapes round, tapering, box;
  round.cones = prepared_cones(ball);
  tapering.cones = prepared_cones(cone);
  box.triangles = faces_of({-0.5f, 0.0f, -0.1f}, {0.5f, 0.4f, 0.2f});
  for (Shapes* shapes : {&round, &tapering, &box}) {
    shapes->figures.assign(shapes->cones.size() + shapes->triangles.size(), 0);
    const double expected = mean_silhouette(*shapes);
    EXPECT_NEAR(sum_of_silhouettes(pieces_of(*shapes)), expected, 0.02 * expected);
  }
}

TEST(FigurePieces, ContainAllShapes) {
  Shapes shapes;
  Solids solids;
  solids.round_cones = {{{0.0f, 0.2f, 0.0f}, {0.3f, 1.0f, 0.2f}, 0.1f, 0.06f}};
  shapes.cones = prepared_cones(solids);
  for (int i = 0; i < 10; ++i) {
    const Vec3 low{0.1f * static_cast<float>(i), 1.0f, -0.3f};
    const std::vector<Triangle> faces = faces_of(low, low + Vec3(0.2f, 0.1f, 0.3f));
    shapes.triangles.insert(shapes.triangles.end(), faces.begin(), faces.end());
  }
  const std::vector<FigurePiece> pieces = pieces_of(shapes);
  EXPECT_GT(pieces.size(), 4u);
  const auto contained = [&](const Vec3& point) {
    return std::any_of(pieces.begin(), pieces.end(), [&](const FigurePiece& piece) {
      return (point - piece.sphere.centre).norm() <= 1.0001f * piece.sphere.radius;
    });
  };
  for (const Triangle& face : shapes.triangles)
    EXPECT_TRUE(contained(face.a) && contained(face.b) && contained(face.c));
  const PreparedCone& cone = shapes.cones[0];
  for (int i = 0; i <= 20; ++i) {
    const float t = 0.05f * static_cast<float>(i);
    const float radius = cone.radius_a + t * (cone.radius_b - cone.radius_a);
    const Vec3 aside = cone.axis.unitOrthogonal();
    EXPECT_TRUE(contained(cone.a + t * cone.axis + radius * aside)) << t;
  }
}

TEST(MayMeet, IsFalseWithoutAFigure) {
  EXPECT_FALSE(may_intersect({}, {0.0f, 1.0f, 2.0f}, {0.0f, 0.0f, -1.0f}));
}

}  // namespace
}  // namespace mien::render
