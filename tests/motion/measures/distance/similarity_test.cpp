#include "motion/measures/distance/similarity.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "motion/random_recording.h"
#include "motion/skeleton/mirror.h"

namespace mien::motion {
namespace {

std::vector<Vec3> scattered(unsigned seed, int count) {
  std::mt19937_64 random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(test::random_vector(random, 1.0));
  return points;
}

template <class Map>
std::vector<Vec3> mapped_points(const std::vector<Vec3>& points, const Map& map) {
  std::vector<Vec3> result;
  for (const Vec3& point : points) result.push_back(map(point));
  return result;
}

double squares(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return sum;
}

TEST(SimilarityFit, FindsTheSimilarityThatWasApplied) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<Vec3> points = scattered(seed, 3 + static_cast<int>(seed % 7));
    std::mt19937_64 random(seed);
    Similarity truth;
    truth.scale = 0.5 + 0.1 * seed;
    const Vec3 axis = test::random_vector(random, 1.0).normalized();
    truth.rotation = Mat3(Eigen::AngleAxisd(0.15 * seed, axis));
    truth.shift = test::random_vector(random, 3.0);
    const Similarity found = similarity_fit(points, mapped_points(points, truth));
    EXPECT_NEAR(found.scale, truth.scale, 1e-12);
    EXPECT_TRUE(found.rotation.isApprox(truth.rotation, 1e-10)) << seed;
    EXPECT_TRUE(found.shift.isApprox(truth.shift, 1e-10)) << seed;
  }
}

TEST(SimilarityFit, IsNoWorseThanAnyOtherNearIt) {
  const std::vector<Vec3> from = scattered(1, 12);
  const std::vector<Vec3> to = scattered(2, 12);
  const Similarity best = similarity_fit(from, to);
  const double least = squares(mapped_points(from, best), to);
  std::mt19937_64 random(3);
  for (int i = 0; i < 200; ++i) {
    Similarity other = best;
    other.scale += test::random_vector(random, 0.02).x();
    const Vec3 turn = test::random_vector(random, 0.05);
    other.rotation = best.rotation * Mat3(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
    other.shift += test::random_vector(random, 0.02);
    EXPECT_GE(squares(mapped_points(from, other), to), least);
  }
}

TEST(SimilarityFit, NeverMirrors) {
  const std::vector<Vec3> points = scattered(4, 10);
  const Similarity fit = similarity_fit(points, mapped_points(points, mirrored_place));
  EXPECT_NEAR(fit.rotation.determinant(), 1.0, 1e-12);
}

TEST(SimilarityFit, OfPointsAtOnePlaceIsAShift) {
  const std::vector<Vec3> from(4, Vec3(1, 2, 3));
  const Similarity fit = similarity_fit(from, std::vector<Vec3>(4, Vec3(0, 2, 5)));
  EXPECT_EQ(fit.scale, 1.0);
  EXPECT_TRUE(fit(from.front()).isApprox(Vec3(0, 2, 5), 1e-15));
}

TEST(LevelFit, FindsTheMoveThatWasMade) {
  for (const bool mirror : {false, true}) {
    const HorizontalTransform truth{mirror, 2.1, Vec3(0.3, -0.2, 4.0)};
    const std::vector<Vec3> points = scattered(5, 9);
    const HorizontalTransform found = horizontal_fit(points, mapped_points(points, truth), mirror);
    EXPECT_NEAR(found.turn_radians, truth.turn_radians, 1e-12);
    EXPECT_TRUE(found.shift.isApprox(truth.shift, 1e-12));
  }
}

}  // namespace
}  // namespace mien::motion
