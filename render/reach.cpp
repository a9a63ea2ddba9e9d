#include "render/reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mien::render {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct Ball {
  Vec3 centre;
  float radius;
};

// A chain of balls such that the solid lies in the hulls of neighbours, each hull about as long as
// it is thick: boxes around those are tighter than one box around the whole.
std::vector<Ball> chain(const RoundCone& cone) {
  const float thickness = 2.0f * std::max(std::max(cone.radius_a, cone.radius_b), 1e-3f);
  const int pieces = std::clamp(static_cast<int>(std::ceil(cone.axis.norm() / thickness)), 1, 16);
  std::vector<Ball> balls;
  for (int i = 0; i <= pieces; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(pieces);
    balls.push_back({cone.a + t * cone.axis, cone.radius_a + t * (cone.radius_b - cone.radius_a)});
  }
  return balls;
}

struct Interval {
  float low;
  float high;

  void include(const Interval& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

// Tangents of the angles at which a disc of that radius, `side` off the axis at `depth`, is seen.
Interval seen(float side, float depth, float radius) {
  const float beyond = depth * depth - radius * radius;
  const float half = radius * std::sqrt(side * side + beyond);
  return {(side * depth - half) / beyond, (side * depth + half) / beyond};
}

struct FilmBox {
  Interval x{infinity, -infinity};
  Interval y{infinity, -infinity};
  bool behind = false;  // the camera, all of it
  bool everywhere = false;

  void include(const FilmBox& other) {
    x.include(other.x);
    y.include(other.y);
    everywhere |= other.everywhere || behind != other.behind;
  }
};

FilmBox film_box(const CameraFrame& camera, const Ball& ball) {
  const Vec3 towards = ball.centre - camera.position;
  const float pixel = camera.step_right.norm();
  const float depth = towards.dot(camera.forward);
  const float radius = 1.001f * ball.radius + 1e-4f;
  FilmBox box;
  if (depth <= 1.01f * radius + 1e-3f) {
    // Across the plane of the camera it could be anywhere.
    box.behind = depth <= -radius;
    box.everywhere = !box.behind;
    return box;
  }
  box.x = seen(towards.dot(camera.step_right) / pixel, depth, radius);
  box.y = seen(towards.dot(camera.step_down) / pixel, depth, radius);
  for (float* x : {&box.x.low, &box.x.high}) *x = camera.centre_x + *x / pixel;
  for (float* y : {&box.y.low, &box.y.high}) *y = camera.centre_y + *y / pixel;
  return box;
}

std::array<Vec3, 8> box_corners(const Ball& from, const Ball& to) {
  const Vec3 low = (from.centre.array() - from.radius).min(to.centre.array() - to.radius);
  const Vec3 high = (from.centre.array() + from.radius).max(to.centre.array() + to.radius);
  std::array<Vec3, 8> corners;
  for (unsigned i = 0; i < 8; ++i)
    corners[i] = {i & 1u ? high.x() : low.x(), i & 2u ? high.y() : low.y(),
                  i & 4u ? high.z() : low.z()};
  return corners;
}

constexpr FloorArea nowhere{infinity, -infinity, infinity, -infinity};
constexpr FloorArea anywhere{-infinity, infinity, -infinity, infinity};

// The shadow of a convex body from a convex light lies in the hull of the shadows of its corners
// from the light's corners: for each light point the projection onto the floor keeps lines
// straight, and so it does in the light point for each point of the body.
FloorArea shadow_area(const AreaLight& light, const Ball& from, const Ball& to) {
  FloorArea area = nowhere;
  for (const Vec3& corner : box_corners(from, to)) {
    for (const float u : {-1.0f, 1.0f}) {
      for (const float v : {-1.0f, 1.0f}) {
        const Vec3 lamp = light.centre + u * light.half_u + v * light.half_v;
        const float height = std::max(corner.y(), 0.0f);
        if (lamp.y() <= 1.001f * height + 1e-3f) return anywhere;
        const float stretch = height / (lamp.y() - height);
        const float x = corner.x() + stretch * (corner.x() - lamp.x());
        const float z = corner.z() + stretch * (corner.z() - lamp.z());
        area.x_min = std::min(area.x_min, x);
        area.x_max = std::max(area.x_max, x);
        area.z_min = std::min(area.z_min, z);
        area.z_max = std::max(area.z_max, z);
      }
    }
  }
  return area;
}

}  // namespace

BoundingSphere bounding_sphere(std::span<const RoundCone> cones) {
  if (cones.empty()) return {};
  Eigen::Array3f low = Eigen::Array3f::Constant(infinity);
  Eigen::Array3f high = Eigen::Array3f::Constant(-infinity);
  for (const RoundCone& cone : cones) {
    low = low.min(cone.a.array() - cone.radius_a).min(cone.b().array() - cone.radius_b);
    high = high.max(cone.a.array() + cone.radius_a).max(cone.b().array() + cone.radius_b);
  }
  BoundingSphere sphere{(0.5f * (low + high)).matrix(), 0.0f};
  for (const RoundCone& cone : cones)
    sphere.radius = std::max({sphere.radius, (cone.a - sphere.centre).norm() + cone.radius_a,
                              (cone.b() - sphere.centre).norm() + cone.radius_b});
  sphere.radius = 1.0001f * sphere.radius + 1e-4f;
  return sphere;
}

FilmMask::FilmMask(const Camera& camera, std::span<const RoundCone> cones, float filter_half_width)
    : width_(camera.width),
      touched_(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height)) {
  const CameraFrame frame = frame_of(camera);
  const float margin = filter_half_width + 0.01f;
  const auto first = [&](float edge, int size) {
    return static_cast<int>(std::clamp(std::floor(edge - margin - 0.5f), 0.0f, float(size)));
  };
  const auto past = [&](float edge, int size) {
    return static_cast<int>(std::clamp(std::ceil(edge + margin + 0.5f), 0.0f, float(size)));
  };
  for (const RoundCone& cone : cones) {
    const std::vector<Ball> balls = chain(cone);
    for (std::size_t i = 0; i + 1 < balls.size(); ++i) {
      FilmBox box = film_box(frame, balls[i]);
      box.include(film_box(frame, balls[i + 1]));
      const bool all = box.everywhere;
      const int x_begin = all ? 0 : first(box.x.low, camera.width);
      const int x_end = all ? camera.width : past(box.x.high, camera.width);
      const int y_begin = all ? 0 : first(box.y.low, camera.height);
      const int y_end = all ? camera.height : past(box.y.high, camera.height);
      for (int y = y_begin; y < y_end && x_begin < x_end; ++y)
        std::fill_n(touched_.begin() + std::ptrdiff_t{y} * camera.width + x_begin, x_end - x_begin,
                    std::uint8_t{1});
    }
  }
}

ShadowMask::ShadowMask(const AreaLight& light, std::span<const RoundCone> cones) {
  std::vector<FloorArea> areas;
  area_ = nowhere;
  for (const RoundCone& cone : cones) {
    const std::vector<Ball> balls = chain(cone);
    for (std::size_t i = 0; i + 1 < balls.size(); ++i) {
      const FloorArea area = shadow_area(light, balls[i], balls[i + 1]);
      areas.push_back(area);
      area_.x_min = std::min(area_.x_min, area.x_min);
      area_.x_max = std::max(area_.x_max, area.x_max);
      area_.z_min = std::min(area_.z_min, area.z_min);
      area_.z_max = std::max(area_.z_max, area.z_max);
    }
  }
  if (areas.empty()) return;
  everywhere_ = !std::isfinite(area_.x_max - area_.x_min + area_.z_max - area_.z_min);
  if (everywhere_) return;
  columns_per_metre_ = cells / std::max(area_.x_max - area_.x_min, 1e-3f);
  rows_per_metre_ = cells / std::max(area_.z_max - area_.z_min, 1e-3f);
  touched_.assign(std::size_t{cells} * cells, 0);
  for (const FloorArea& area : areas)
    for (int z = row(area.z_min); z <= row(area.z_max); ++z)
      for (int x = column(area.x_min); x <= column(area.x_max); ++x)
        touched_[static_cast<std::size_t>(z * cells + x)] = 1;
}

int ShadowMask::column(float x) const {
  return static_cast<int>(
      std::clamp((x - area_.x_min) * columns_per_metre_, 0.0f, float(cells - 1)));
}

int ShadowMask::row(float z) const {
  return static_cast<int>(std::clamp((z - area_.z_min) * rows_per_metre_, 0.0f, float(cells - 1)));
}

bool ShadowMask::may_shade(const FloorArea& area) const {
  if (everywhere_) return true;
  constexpr float rounding = 1e-4f;
  if (area.x_max + rounding < area_.x_min || area.x_min - rounding > area_.x_max ||
      area.z_max + rounding < area_.z_min || area.z_min - rounding > area_.z_max)
    return false;
  for (int z = row(area.z_min - rounding); z <= row(area.z_max + rounding); ++z)
    for (int x = column(area.x_min - rounding); x <= column(area.x_max + rounding); ++x)
      if (touched_[static_cast<std::size_t>(z * cells + x)] != 0) return true;
  return false;
}

}  // namespace mien::render
