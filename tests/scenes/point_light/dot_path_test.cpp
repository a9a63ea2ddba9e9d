#include "scenes/point_light/dot_path.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace mien::scenes {
namespace {

using motion::Vec3;

/// A random walk.
DotPath random_path(unsigned seed, int points) {
  std::mt19937 random(seed);
  std::normal_distribution<double> step(0.0, 0.02);
  DotPath path = {Vec3(0.3, 1.0, -2.0)};
  for (int i = 1; i < points; ++i) {
    path.push_back(path.back() + Vec3(step(random), step(random), step(random)));
  }
  return path;
}

double largest_difference(const DotPath& a, const DotPath& b) {
  double most = a.size() == b.size() ? 0.0 : 1e9;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    most = std::max(most, (a[i] - b[i]).norm());
  }
  return most;
}

TEST(DotPath, EachOfTheseDoneTwiceIsNothing) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const DotPath path = random_path(seed, 50);
    const Vec3 centre(0.1, 0.0, 0.7);
    const Vec3 across = Vec3(0.6, 0.0, -0.8);
    EXPECT_EQ(reversed(reversed(path)), path);
    EXPECT_LT(largest_difference(mirrored(mirrored(path, centre, across), centre, across), path),
              1e-12);
    EXPECT_LT(largest_difference(inverted(inverted(path, 0.9), 0.9), path), 1e-12);
    EXPECT_LT(largest_difference(rotated(rotated(path, centre, 123.0), centre, -123.0), path),
              1e-12);
    EXPECT_EQ(begun_at(begun_at(path, 17), 33), path);
  }
}

TEST(DotPath, AMirrorChangesWhatGoesAcrossAndNothingElse) {
  const Vec3 mirror = mirrored({Vec3(2.0, 1.0, 5.0)}, Vec3(0.5, 0.0, 9.0), Vec3::UnitX()).front();
  EXPECT_LT((mirror - Vec3(-1.0, 1.0, 5.0)).norm(), 1e-12);
}

TEST(DotPath, TurnsCounterClockwiseSeenFromAbove) {
  const Vec3 turned = rotated({Vec3(0.0, 1.0, 1.0)}, Vec3::Zero(), 90.0).front();
  EXPECT_LT((turned - Vec3(1.0, 1.0, 0.0)).norm(), 1e-12);
}

TEST(DotPath, AtConstantSpeedTheSameWayIsGoneEvenly) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const DotPath path = random_path(seed, 80);
    const DotPath even = at_constant_speed(path);
    ASSERT_EQ(even.size(), path.size());
    EXPECT_LT((even.front() - path.front()).norm(), 1e-12);
    EXPECT_LT((even.back() - path.back()).norm(), 1e-12);
    // Where along the path each point lies: it must be on it, and the arc lengths must be even.
    const double step = length_of(path) / static_cast<double>(path.size() - 1);
    double before = 0.0;
    std::size_t segment = 1;
    for (std::size_t f = 0; f + 1 < even.size(); ++f) {
      const double wanted = step * static_cast<double>(f);
      while (before + (path[segment] - path[segment - 1]).norm() < wanted - 1e-12) {
        before += (path[segment] - path[segment - 1]).norm();
        ++segment;
      }
      const Vec3 way = path[segment] - path[segment - 1];
      const Vec3 expected = path[segment - 1] + (wanted - before) / way.norm() * way;
      EXPECT_LT((even[f] - expected).norm(), 1e-9);
    }
  }
}

TEST(DotPath, AStandingDotStandsAtConstantSpeed) {
  const DotPath still(10, Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(at_constant_speed(still), still);
}

TEST(DotPath, BegunLaterItGoesThroughTheSamePlaces) {
  const DotPath path = random_path(3, 40);
  const DotPath later = begun_at(path, 11);
  EXPECT_EQ(later.front(), path[11]);
  EXPECT_NE(later, path);
  for (const Vec3& point : path) {
    EXPECT_EQ(std::count(later.begin(), later.end(), point), 1);
  }
}

}  // namespace
}  // namespace mien::scenes
