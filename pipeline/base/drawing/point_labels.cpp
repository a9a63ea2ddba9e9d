#include "pipeline/base/drawing/point_labels.h"

#include <algorithm>
#include <array>

namespace mien::pipeline {

namespace {

constexpr double label_gap = 1.5;   ///< between a mark and its label, points
constexpr double label_step = 5.0;  ///< between distances that are tried, points

/// Directions from the point to the middle of its label, in the order of preference.
constexpr std::array<Point, 8> label_directions = {{{1.0, 0.0},
                                                    {-1.0, 0.0},
                                                    {0.0, -1.0},
                                                    {0.0, 1.0},
                                                    {1.0, -1.0},
                                                    {1.0, 1.0},
                                                    {-1.0, -1.0},
                                                    {-1.0, 1.0}}};

Box box_beside(const LabelledPoint& point, const Point& direction, double distance) {
  return {point.at.x + direction.x * (distance + 0.5 * point.width) - 0.5 * point.width,
          point.at.y + direction.y * (distance + 0.5 * point.height) - 0.5 * point.height,
          point.width, point.height};
}

bool is_within(const Box& box, const Box& area) {
  return box.x >= area.x && box.y >= area.y && box.right() <= area.right() &&
         box.bottom() <= area.bottom();
}

}  // namespace

std::vector<std::optional<Box>> place_labels(const std::vector<LabelledPoint>& points,
                                             const std::vector<Point>& others, double radius,
                                             const Box& area, double reach) {
  std::vector<Box> taken;
  const auto add_mark = [&](const Point& at) {
    taken.push_back({at.x - radius, at.y - radius, 2.0 * radius, 2.0 * radius});
  };
  for (const LabelledPoint& point : points) add_mark(point.at);
  for (const Point& other : others) add_mark(other);
  std::vector<std::optional<Box>> labels(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (double distance = radius + label_gap; distance <= reach && !labels[i];
         distance += label_step) {
      for (const Point& direction : label_directions) {
        const Box box = box_beside(points[i], direction, distance);
        const auto is_hit = [&](const Box& other) { return overlap(box, other); };
        if (!is_within(box, area) || std::ranges::any_of(taken, is_hit)) continue;
        labels[i] = box;
        break;
      }
    }
    if (labels[i]) taken.push_back(*labels[i]);
  }
  return labels;
}

}  // namespace mien::pipeline
