#include "render/geometry/shadow_mask.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/geometry/shape_pieces.h"
#include "render/math/constants.h"

namespace mien::render {
namespace {

std::array<Vec3, 8> corners_of(const Box& box) {
  std::array<Vec3, 8> corners;
  for (unsigned i = 0; i < 8; ++i)
    corners[i] = {i & 1u ? box.upper.x() : box.lower.x(), i & 2u ? box.upper.y() : box.lower.y(),
                  i & 4u ? box.upper.z() : box.lower.z()};
  return corners;
}

template <std::size_t count>
Box box_around(const std::array<Ball, count>& balls) {
  Box box{Eigen::Array3f::Constant(infinity), Eigen::Array3f::Constant(-infinity)};
  for (const Ball& ball : balls)
    box = hull(box, {ball.centre.array() - ball.radius, ball.centre.array() + ball.radius});
  return box;
}

constexpr FloorArea nowhere{infinity, -infinity, infinity, -infinity};
constexpr FloorArea anywhere{-infinity, infinity, -infinity, infinity};

// The shadow of a convex body from a convex light lies in the hull of the shadows of its corners
// from the light's corners: for each light point the projection onto the floor keeps lines
// straight, and so it does in the light point for each point of the body. The area has the frame of
// a grid that is turned.
FloorArea shadow_area(const AreaLight& light, const Box& box, float cosine, float sine) {
  FloorArea area = nowhere;
  for (const Vec3& corner : corners_of(box)) {
    for (const float u : {-1.0f, 1.0f}) {
      for (const float v : {-1.0f, 1.0f}) {
        const Vec3 lamp = light.centre + u * light.half_u + v * light.half_v;
        const float height = std::max(corner.y(), 0.0f);
        if (lamp.y() <= 1.001f * height + 1e-3f) return anywhere;
        const float stretch = height / (lamp.y() - height);
        const float x = corner.x() + stretch * (corner.x() - lamp.x());
        const float z = corner.z() + stretch * (corner.z() - lamp.z());
        const float along = cosine * x + sine * z, across = cosine * z - sine * x;
        area.x_min = std::min(area.x_min, along);
        area.x_max = std::max(area.x_max, along);
        area.z_min = std::min(area.z_min, across);
        area.z_max = std::max(area.z_max, across);
      }
    }
  }
  return area;
}

constexpr float rounding = 1e-4f;

bool overlap(const FloorArea& a, const FloorArea& b) {
  return a.x_max + rounding >= b.x_min && a.x_min - rounding <= b.x_max &&
         a.z_max + rounding >= b.z_min && a.z_min - rounding <= b.z_max;
}

/// Whether a solid lies entirely behind the plane of the light, where it cannot occlude it.
bool is_behind(const AreaLight& light, const PreparedCone& solid) {
  constexpr float nearest = 1e-3f;  // metres
  const Vec3 front = light.half_u.cross(light.half_v).normalized();
  return front.dot(solid.a - light.centre) + solid.radius_a < -nearest &&
         front.dot(solid.b() - light.centre) + solid.radius_b < -nearest;
}

}  // namespace

ShadowMask::ShadowMask(const AreaLight& light, const Shapes& shapes) {
  const Vec3& side = light.half_u;
  if (const float length = std::hypot(side.x(), side.z()); length > 0.0f) {
    cosine_ = side.x() / length;
    sine_ = side.z() / length;
  }
  std::vector<FloorArea> areas;
  area_ = nowhere;
  const auto add = [&](const Box& box) {
    const FloorArea area = shadow_area(light, box, cosine_, sine_);
    areas.push_back(area);
    area_.x_min = std::min(area_.x_min, area.x_min);
    area_.x_max = std::max(area_.x_max, area.x_max);
    area_.z_min = std::min(area_.z_min, area.z_min);
    area_.z_max = std::max(area_.z_max, area.z_max);
  };
  for (std::size_t i = 0; i < shapes.cones.size(); ++i) {
    if (shapes.closing_cones.empty() && is_behind(light, shapes.cones[i])) continue;
    visit_cone_pieces(shapes, i, [&](const auto& balls) { add(box_around(balls)); });
  }
  visit_patch_boxes(shapes, add);
  if (areas.empty()) return;
  everywhere_ = !std::isfinite(area_.x_max - area_.x_min + area_.z_max - area_.z_min);
  if (everywhere_) return;
  columns_per_metre_ = cells / std::max(area_.x_max - area_.x_min, 1e-3f);
  rows_per_metre_ = cells / std::max(area_.z_max - area_.z_min, 1e-3f);
  touched_.assign(std::size_t{cells} * cells, 0);
  for (const FloorArea& area : areas) {
    const int first = column(area.x_min), count = column(area.x_max) - first + 1;
    const int last = row(area.z_max);
    for (int z = row(area.z_min); z <= last; ++z)
      std::fill_n(touched_.begin() + z * cells + first, count, std::uint8_t{1});
  }
}

FloorArea ShadowMask::turned(const FloorArea& area) const {
  const float x = 0.5f * (area.x_min + area.x_max), z = 0.5f * (area.z_min + area.z_max);
  const float width = 0.5f * (area.x_max - area.x_min), depth = 0.5f * (area.z_max - area.z_min);
  const float along = cosine_ * x + sine_ * z, across = cosine_ * z - sine_ * x;
  const float reach_along = std::abs(cosine_) * width + std::abs(sine_) * depth;
  const float reach_across = std::abs(cosine_) * depth + std::abs(sine_) * width;
  return {along - reach_along, along + reach_along, across - reach_across, across + reach_across};
}

int ShadowMask::column(float x) const {
  return static_cast<int>(
      std::clamp((x - area_.x_min) * columns_per_metre_, 0.0f, float(cells - 1)));
}

int ShadowMask::row(float z) const {
  return static_cast<int>(std::clamp((z - area_.z_min) * rows_per_metre_, 0.0f, float(cells - 1)));
}

bool ShadowMask::may_shade(const FloorArea& floor) const {
  if (everywhere_) return true;
  const FloorArea area = turned(floor);
  if (!overlap(area, area_)) return false;
  for (int z = row(area.z_min - rounding); z <= row(area.z_max + rounding); ++z)
    for (int x = column(area.x_min - rounding); x <= column(area.x_max + rounding); ++x)
      if (touched_[static_cast<std::size_t>(z * cells + x)] != 0) return true;
  return false;
}

}  // namespace mien::render
