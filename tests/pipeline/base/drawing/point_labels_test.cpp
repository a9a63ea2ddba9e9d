#include "pipeline/base/drawing/point_labels.h"

#include <random>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

constexpr Box label_area = {10.0, 20.0, 200.0, 150.0};
constexpr double mark_size = 3.0;

Box mark_at(const Point& at) {
  return {at.x - mark_size, at.y - mark_size, 2.0 * mark_size, 2.0 * mark_size};
}

std::vector<LabelledPoint> random_points(int count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share;
  std::vector<LabelledPoint> points;
  for (int i = 0; i < count; ++i)
    points.push_back({{label_area.x + label_area.width * share(random),
                       label_area.y + label_area.height * share(random)},
                      15.0 + 25.0 * share(random),
                      7.0});
  return points;
}

TEST(PointLabels, NeitherOverlapNorLeaveTheArea) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<LabelledPoint> points = random_points(25, seed);
    std::vector<Point> others;
    for (const LabelledPoint& other : random_points(5, 100 + seed)) others.push_back(other.at);
    const auto labels = place_labels(points, others, mark_size, label_area);
    ASSERT_EQ(labels.size(), points.size());
    int placed = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (!labels[i]) continue;
      ++placed;
      EXPECT_EQ(labels[i]->width, points[i].width);
      EXPECT_TRUE(labels[i]->x >= label_area.x && labels[i]->right() <= label_area.right());
      EXPECT_TRUE(labels[i]->y >= label_area.y && labels[i]->bottom() <= label_area.bottom());
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_FALSE(labels[k] && overlap(*labels[i], *labels[k]));
      for (const LabelledPoint& point : points)
        EXPECT_FALSE(overlap(*labels[i], mark_at(point.at)));
      for (const Point& other : others) EXPECT_FALSE(overlap(*labels[i], mark_at(other)));
    }
    EXPECT_GE(placed, 22);
  }
}

TEST(PointLabels, StandBesideAPointAlone) {
  const auto labels = place_labels({{{100.0, 100.0}, 30.0, 8.0}}, {}, mark_size, label_area);
  ASSERT_TRUE(labels[0]);
  EXPECT_NEAR(labels[0]->middle(), 100.0, 1e-9);
  EXPECT_GT(labels[0]->x, 100.0 + mark_size);
  EXPECT_LT(labels[0]->x, 100.0 + mark_size + 5.0);
  // At the right edge there is room on the left only.
  const auto left = place_labels({{{205.0, 100.0}, 30.0, 8.0}}, {}, mark_size, label_area);
  ASSERT_TRUE(left[0]);
  EXPECT_LT(left[0]->right(), 205.0 - mark_size);
}

TEST(PointLabels, AreLeftOutWhereThereIsNoRoom) {
  std::vector<LabelledPoint> points(60, {{100.0, 100.0}, 40.0, 8.0});
  const auto labels = place_labels(points, {}, mark_size, label_area, 30.0);
  EXPECT_TRUE(labels.front());
  EXPECT_FALSE(labels.back());
  EXPECT_FALSE(place_labels({{{100.0, 100.0}, 400.0, 8.0}}, {}, mark_size, label_area)[0]);
}

}  // namespace
}  // namespace mien::pipeline
