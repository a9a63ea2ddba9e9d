#include "render/geometry/prepared_cone.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

using Point = Eigen::Vector3d;

/// Distance from the hull of two balls: the least over balls in between, by golden-section search
/// (it is convex in the ball's place).
double distance_from(const RoundCone& round_cone, const Point& point) {
  const Point a = round_cone.start.cast<double>(), b = round_cone.end.cast<double>();
  const auto ra = static_cast<double>(round_cone.start_radius);
  const auto rb = static_cast<double>(round_cone.end_radius);
  const auto from_ball = [&](double t) {
    return (point - a - t * (b - a)).norm() - (ra + t * (rb - ra));
  };
  double low = 0.0, high = 1.0;
  for (int step = 0; step < 60; ++step) {
    const double left = low + 0.381966 * (high - low), right = low + 0.618034 * (high - low);
    from_ball(left) < from_ball(right) ? high = right : low = left;
  }
  return from_ball(0.5 * (low + high));
}

struct Crossing {
  bool hits;
  double nearest;  // the least distance seen, when it misses
  double along;
};

/// Sphere tracing from outside (Hart 1996).
Crossing marched(const RoundCone& round_cone, const Point& origin, const Point& direction) {
  double along = 0.0, nearest = 1e9;
  for (int step = 0; step < 2000 && along < 30.0; ++step) {
    const double distance = distance_from(round_cone, origin + along * direction);
    nearest = std::min(nearest, distance);
    if (distance < 1e-7) return {true, nearest, along};
    along += distance;
  }
  return {false, nearest, along};
}

struct Line {
  float enter, leave;
};

Line line_through(const PreparedCone& cone, const Vec3& origin, const Vec3& direction) {
  Line line;
  const RayLanes ray{&origin.x(),    &origin.y(),    &origin.z(),
                     &direction.x(), &direction.y(), &direction.z()};
  intersect_lines(cone, ray, 1, &line.enter, &line.leave);
  return line;
}

class RandomCone {
 public:
  explicit RandomCone(unsigned seed) : random_(seed) {}
  float uniform(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }
  Vec3 direction() {
    std::normal_distribution<float> normal;
    return Vec3{normal(random_), normal(random_), normal(random_)}.normalized();
  }
  RoundCone round_cone() {
    return {.start = 0.5f * direction(),
            .end = 0.5f * direction(),
            .start_radius = uniform(0.02f, 0.4f),
            .end_radius = uniform(0.02f, 0.4f)};
  }

 private:
  std::mt19937 random_;
};

TEST(PreparedCone, IsMetWhereSphereTracingMeetsIt) {
  RandomCone random(11);
  int hits = 0, misses = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const RoundCone round_cone = random.round_cone();
    const Vec3 origin = 4.0f * random.direction();
    const Vec3 direction = (0.7f * random.direction() - origin).normalized();
    const Crossing expected =
        marched(round_cone, origin.cast<double>(), direction.cast<double>().normalized());
    const Line line = line_through(prepared_cone(round_cone), origin, direction);
    if (expected.hits) {
      ++hits;
      // Where the ray grazes, a little across is much along.
      if (line.enter > line.leave) continue;
      const Point at = (origin + line.enter * direction).cast<double>();
      EXPECT_NEAR(distance_from(round_cone, at), 0.0, 2e-5) << "trial " << trial;
      EXPECT_NEAR(line.enter, expected.along, 5e-3) << "trial " << trial;
    } else if (expected.nearest > 1e-4) {
      ++misses;
      EXPECT_GT(line.enter, line.leave) << "trial " << trial;
    }
  }
  EXPECT_GT(hits, 300);
  EXPECT_GT(misses, 300);
}

TEST(PreparedCone, IsMissedByNoRayThroughItsInside) {
  RandomCone random(12);
  for (int trial = 0; trial < 2000; ++trial) {
    const RoundCone round_cone = random.round_cone();
    const float t = random.uniform(0.0f, 1.0f);
    const float radius =
        round_cone.start_radius + t * (round_cone.end_radius - round_cone.start_radius);
    const Vec3 inside = round_cone.start + t * (round_cone.end - round_cone.start) +
                        random.uniform(0.0f, 0.99f) * radius * random.direction();
    const Vec3 origin = 4.0f * random.direction();
    const Vec3 direction = (inside - origin).normalized();
    const Line line = line_through(prepared_cone(round_cone), origin, direction);
    EXPECT_LE(line.enter, (inside - origin).norm() + 1e-4f) << "trial " << trial;
    EXPECT_GE(line.leave, (inside - origin).norm() - 1e-4f) << "trial " << trial;
  }
}

TEST(PreparedCone, HasTheGradientOfItsDistanceAsNormal) {
  RandomCone random(13);
  int hits = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const RoundCone round_cone = random.round_cone();
    const PreparedCone cone = prepared_cone(round_cone);
    const Vec3 origin = 4.0f * random.direction();
    const Vec3 direction = (0.3f * random.direction() - origin).normalized();
    const Line line = line_through(cone, origin, direction);
    if (line.enter > line.leave) continue;
    ++hits;
    const Vec3 at = origin + line.enter * direction;
    Point gradient;
    for (int i = 0; i < 3; ++i) {
      const Point step = 1e-5 * Point::Unit(i), point = at.cast<double>();
      gradient[i] =
          distance_from(round_cone, point + step) - distance_from(round_cone, point - step);
    }
    EXPECT_LT((normal_at(cone, at).cast<double>() - gradient.normalized()).norm(), 2e-3)
        << "trial " << trial;
  }
  EXPECT_GT(hits, 100);
}

TEST(PreparedCone, IsTheGreaterSphereWhenItHoldsTheOther) {
  const RoundCone round_cone{
      .start = Vec3::Zero(), .end = {0.1f, 0.0f, 0.0f}, .start_radius = 0.5f};
  const Line line = line_through(prepared_cone(round_cone), {-2.0f, 0.0f, 0.0f}, Vec3::UnitX());
  EXPECT_NEAR(line.enter, 1.5f, 1e-6f);
  EXPECT_NEAR(line.leave, 2.5f, 1e-6f);
}

}  // namespace
}  // namespace mien::render
