#include "scenes/face/front_of_head.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace mien::scenes {

namespace {

using motion::Vec3;
using Vec2 = Eigen::Vector2d;

constexpr double lowest_chin = -0.35;  // of the height of the crown above the joint
constexpr double lowest_nose = 0.15;   // of the same
constexpr double highest_nose = 0.7;   // of the same
constexpr double largest_depth = 1.1;  // of the same; what is farther back is hair
constexpr double chin_recess = 0.25;   // of the head's depth
constexpr double face_recess = 0.5;    // of the head's depth
constexpr double middle_share = 0.06;  // half the width of the middle, of the height of the crown
constexpr int rows_to_crown = 90;

constexpr double nothing = -std::numeric_limits<double>::infinity();

Eigen::AlignedBox3d box_of_head(const HeadTriangles& head) {
  Eigen::AlignedBox3d box;
  for (const auto& triangle : head)
    for (const Vec3& corner : triangle) box.extend(corner);
  return box;
}

/// The foremost point of the surface in each cell of a grid, seen from the front.
class DepthMap {
 public:
  DepthMap(const HeadTriangles& head, const Eigen::AlignedBox2d& seen, double step)
      : corner_(seen.min()),
        step_(step),
        columns_(static_cast<int>(seen.sizes().x() / step) + 1),
        rows_(static_cast<int>(seen.sizes().y() / step) + 1),
        depths_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), nothing) {
    for (const auto& triangle : head) draw(triangle);
  }

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double x(int column) const { return corner_.x() + step_ * column; }
  double y(int row) const { return corner_.y() + step_ * row; }
  int column(double x) const { return nearest((x - corner_.x()) / step_, columns_); }
  int row(double y) const { return nearest((y - corner_.y()) / step_, rows_); }
  double at(int column, int row) const { return depths_[index(column, row)]; }

 private:
  static int nearest(double place, int count) {
    return std::clamp(static_cast<int>(std::lround(place)), 0, count - 1);
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  void draw(const std::array<Vec3, 3>& triangle) {
    Eigen::AlignedBox2d box;
    for (const Vec3& at : triangle) box.extend(Vec2(at.head<2>()));
    const Vec2 a = triangle[0].head<2>();
    Eigen::Matrix2d sides;
    sides << triangle[1].head<2>() - a, triangle[2].head<2>() - a;
    if (!(std::abs(sides.determinant()) > 1e-14)) return;
    const Eigen::Matrix2d inverse = sides.inverse();
    for (int r = row(box.min().y()); r <= row(box.max().y()); ++r) {
      for (int c = column(box.min().x()); c <= column(box.max().x()); ++c) {
        const Vec2 share = inverse * (Vec2(x(c), y(r)) - a);
        if (share.minCoeff() < -1e-9 || share.sum() > 1.0 + 1e-9) continue;
        const double z = triangle[0].z() + share.x() * (triangle[1].z() - triangle[0].z()) +
                         share.y() * (triangle[2].z() - triangle[0].z());
        depths_[index(c, r)] = std::max(depths_[index(c, r)], z);
      }
    }
  }

  Vec2 corner_;
  double step_;
  int columns_, rows_;
  std::vector<double> depths_;
};

/// The foremost point of a row near a column.
double profile(const DepthMap& map, int middle, int half_width, int row) {
  double most = nothing;
  for (int c = std::max(0, middle - half_width);
       c <= std::min(map.columns() - 1, middle + half_width); ++c)
    most = std::max(most, map.at(c, row));
  return most;
}

/// The last place from `from` in steps of `step` up to which `holds`.
int last_place(int from, int step, int count, const auto& holds) {
  int place = from;
  while (place + step >= 0 && place + step < count && holds(place + step)) place += step;
  return place;
}

/// The rows of chin and top, and the columns between which the surface is near the nose's depth.
struct OutlineCells {
  int chin, top, right, left;
};

/// None if nothing is in front of the joint.
std::optional<OutlineCells> outline_cells(const DepthMap& map, double crown, double depth,
                                          double& back) {
  const int middle = map.column(0.0);
  const int half_middle = std::max(1, map.column(middle_share * crown) - middle);
  const auto front = [&](int row) { return profile(map, middle, half_middle, row); };
  int nose = map.row(lowest_nose * crown);
  for (int row = nose; row <= map.row(highest_nose * crown); ++row)
    if (front(row) > front(nose)) nose = row;
  if (!(front(nose) > 0.0)) return std::nullopt;
  const double chin_depth = front(nose) - chin_recess * depth;
  back = front(nose) - face_recess * depth;
  OutlineCells cells{nose, nose, middle, middle};
  cells.chin = last_place(nose, -1, map.rows(), [&](int row) { return front(row) >= chin_depth; });
  cells.top = last_place(nose, 1, map.rows(), [&](int row) { return front(row) >= back; });
  for (int row = cells.chin; row <= cells.top; ++row) {
    const auto is_near = [&](int column) { return map.at(column, row) >= back; };
    if (!is_near(middle)) continue;
    cells.right = std::min(cells.right, last_place(middle, -1, map.columns(), is_near));
    cells.left = std::max(cells.left, last_place(middle, 1, map.columns(), is_near));
  }
  return cells;
}

}  // namespace

FrontOfHead front_of_head(const HeadTriangles& head) {
  FrontOfHead front;
  const Eigen::AlignedBox3d box = box_of_head(head);
  if (head.empty() || !(box.max().y() > 0.0) || !(box.max().z() > 0.0)) return front;
  const double crown = box.max().y();
  const double widest = std::min(1.5 * crown, box.sizes().x());
  const Eigen::AlignedBox2d seen(
      Vec2(std::max(box.min().x(), -widest), std::max(box.min().y(), lowest_chin * crown)),
      Vec2(std::min(box.max().x(), widest), crown));
  const DepthMap map(head, seen, crown / rows_to_crown);
  double back = 0.0;
  const std::optional<OutlineCells> cells =
      outline_cells(map, crown, std::min(box.sizes().z(), largest_depth * crown), back);
  if (!cells) return front;
  front.outline = {Vec2(map.x(cells->right), map.y(cells->chin)),
                   Vec2(map.x(cells->left), map.y(cells->top))};
  const Vec2 centre = front.outline.center(), half = 0.5 * front.outline.sizes();
  for (int row = cells->chin; row <= cells->top; ++row) {
    for (int column = cells->right; column <= cells->left; ++column) {
      const Vec2 at(map.x(column), map.y(row));
      if (map.at(column, row) >= back && (at - centre).cwiseQuotient(half).norm() <= 1.0)
        front.face.emplace_back(at.x(), at.y(), map.at(column, row));
    }
  }
  return front;
}

}  // namespace mien::scenes
