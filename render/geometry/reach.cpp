#include "render/geometry/reach.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/math/constants.h"

namespace mien::render {
namespace {

struct Ball {
  Vec3 centre;
  float radius;
};

// A solid as pieces, each within the hull of a few balls. A round cone becomes a chain whose pieces
// are about as long as they are thick: boxes around those are tighter than one box around the
// whole. What moves fills the hull of where it comes from and where it goes to.
template <class Visit>
void visit_pieces(const RoundCone& cone, const RoundCone* closing, Visit visit) {
  const float thickness = 2.0f * std::max(std::max(cone.radius_a, cone.radius_b), 1e-3f);
  const int pieces = std::clamp(static_cast<int>(std::ceil(cone.axis.norm() / thickness)), 1, 16);
  const auto ball = [&](const RoundCone& of, int i) {
    const float t = static_cast<float>(i) / static_cast<float>(pieces);
    return Ball{of.a + t * of.axis, of.radius_a + t * (of.radius_b - of.radius_a)};
  };
  for (int i = 0; i < pieces; ++i) {
    if (closing == nullptr) {
      visit(std::array{ball(cone, i), ball(cone, i + 1)});
    } else {
      // Between the two the solid may be a sphere of the larger radius anywhere on its axis.
      std::array balls{ball(cone, i), ball(cone, i + 1), ball(*closing, i), ball(*closing, i + 1)};
      const float radius =
          std::max({cone.radius_a, cone.radius_b, closing->radius_a, closing->radius_b});
      for (Ball& each : balls) each.radius = radius;
      visit(balls);
    }
  }
}

template <class Visit>
void visit_pieces(const Triangle& triangle, const Triangle* closing, Visit visit) {
  const std::array balls{Ball{triangle.a, 0.0f}, Ball{triangle.b, 0.0f}, Ball{triangle.c, 0.0f}};
  if (closing == nullptr) return visit(balls);
  visit(std::array{balls[0], balls[1], balls[2], Ball{closing->a, 0.0f}, Ball{closing->b, 0.0f},
                   Ball{closing->c, 0.0f}});
}

template <class Visit>
void visit_pieces(const Shapes& shapes, Visit visit) {
  for (std::size_t i = 0; i < shapes.cones.size(); ++i)
    visit_pieces(shapes.cones[i], shapes.closing_cones.empty() ? nullptr : &shapes.closing_cones[i],
                 visit);
  for (std::size_t i = 0; i < shapes.triangles.size(); ++i)
    visit_pieces(shapes.triangles[i],
                 shapes.closing_triangles.empty() ? nullptr : &shapes.closing_triangles[i], visit);
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
  if (camera.parallel) {
    box.behind = depth <= -radius;
    const float x = camera.centre_x + towards.dot(camera.step_right) / (pixel * pixel);
    const float y = camera.centre_y + towards.dot(camera.step_down) / (pixel * pixel);
    box.x = {x - radius / pixel, x + radius / pixel};
    box.y = {y - radius / pixel, y + radius / pixel};
    return box;
  }
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

// Points whose hull holds a piece.
struct HullPoints {
  std::array<Vec3, 8> points;
  std::size_t count = 0;
};

template <std::size_t count>
HullPoints hull_points(const std::array<Ball, count>& balls) {
  HullPoints hull;
  if (balls[0].radius == 0.0f) {
    for (const Ball& ball : balls) hull.points[hull.count++] = ball.centre;
    return hull;
  }
  Eigen::Array3f low = Eigen::Array3f::Constant(infinity), high = -low;
  for (const Ball& ball : balls) {
    low = low.min(ball.centre.array() - ball.radius);
    high = high.max(ball.centre.array() + ball.radius);
  }
  for (unsigned i = 0; i < 8; ++i)
    hull.points[hull.count++] = {i & 1u ? high.x() : low.x(), i & 2u ? high.y() : low.y(),
                                 i & 4u ? high.z() : low.z()};
  return hull;
}

constexpr FloorArea nowhere{infinity, -infinity, infinity, -infinity};
constexpr FloorArea anywhere{-infinity, infinity, -infinity, infinity};

// The shadow of a convex body from a convex light lies in the hull of the shadows of its corners
// from the light's corners: for each light point the projection onto the floor keeps lines
// straight, and so it does in the light point for each point of the body.
FloorArea shadow_area(const AreaLight& light, const HullPoints& hull) {
  FloorArea area = nowhere;
  for (std::size_t i = 0; i < hull.count; ++i) {
    const Vec3& corner = hull.points[i];
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

BoundingSphere bounding_sphere(const Shapes& shapes) {
  if (shapes.empty()) return {};
  Eigen::Array3f low = Eigen::Array3f::Constant(infinity), high = -low;
  visit_pieces(shapes, [&](const auto& balls) {
    for (const Ball& ball : balls) {
      low = low.min(ball.centre.array() - ball.radius);
      high = high.max(ball.centre.array() + ball.radius);
    }
  });
  BoundingSphere sphere{(0.5f * (low + high)).matrix(), 0.0f};
  visit_pieces(shapes, [&](const auto& balls) {
    for (const Ball& ball : balls)
      sphere.radius = std::max(sphere.radius, (ball.centre - sphere.centre).norm() + ball.radius);
  });
  sphere.radius = 1.0001f * sphere.radius + 1e-4f;
  return sphere;
}

bool may_meet(const BoundingSphere& sphere, const Vec3& origin, const Vec3& direction) {
  const Vec3 towards = sphere.centre - origin;
  const float along = towards.dot(direction);
  const float squared = towards.squaredNorm();
  const float aside = squared - along * along;  // squared
  const float rounding = 1e-5f * squared;
  return sphere.radius >= 0.0f && along > -1.001f * sphere.radius - rounding &&
         aside <= 1.001f * sphere.radius * sphere.radius + rounding;
}

std::vector<BoundingSphere> bounding_spheres(const Shapes& shapes) {
  // A piece of a round cone is as thick as it is long; of triangles, which come in the order of the
  // surface, so many at a time make a patch.
  constexpr std::size_t patch = 64;
  std::vector<BoundingSphere> spheres;
  Eigen::Array3f low = Eigen::Array3f::Constant(infinity), high = -low;
  std::size_t gathered = 0;
  const auto close = [&] {
    if (gathered == 0) return;
    spheres.push_back({(0.5f * (low + high)).matrix(), 0.5f * (high - low).matrix().norm()});
    low.setConstant(infinity);
    high.setConstant(-infinity);
    gathered = 0;
  };
  visit_pieces(shapes, [&](const auto& balls) {
    const bool of_triangle = balls[0].radius == 0.0f;
    if (!of_triangle) close();
    for (const Ball& ball : balls) {
      low = low.min(ball.centre.array() - ball.radius);
      high = high.max(ball.centre.array() + ball.radius);
    }
    if (++gathered == patch || !of_triangle) close();
  });
  close();
  return spheres;
}

FilmMask::FilmMask(const Camera& camera, const Shapes& shapes, float filter_half_width)
    : width_(camera.width),
      touched_(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height)) {
  if (camera.aperture_radius > 0.0f && !shapes.empty()) {
    // What is out of focus may show anywhere.
    std::fill(touched_.begin(), touched_.end(), std::uint8_t{1});
    return;
  }
  const CameraFrame frame = frame_of(camera);
  const float margin = filter_half_width + 0.01f;
  const auto first = [&](float edge, int size) {
    return static_cast<int>(std::clamp(std::floor(edge - margin - 0.5f), 0.0f, float(size)));
  };
  const auto past = [&](float edge, int size) {
    return static_cast<int>(std::clamp(std::ceil(edge + margin + 0.5f), 0.0f, float(size)));
  };
  visit_pieces(shapes, [&](const auto& balls) {
    FilmBox box = film_box(frame, balls[0]);
    for (std::size_t i = 1; i < balls.size(); ++i) box.include(film_box(frame, balls[i]));
    const bool all = box.everywhere;
    const int x_begin = all ? 0 : first(box.x.low, camera.width);
    const int x_end = all ? camera.width : past(box.x.high, camera.width);
    const int y_begin = all ? 0 : first(box.y.low, camera.height);
    const int y_end = all ? camera.height : past(box.y.high, camera.height);
    for (int y = y_begin; y < y_end && x_begin < x_end; ++y)
      std::fill_n(touched_.begin() + std::ptrdiff_t{y} * camera.width + x_begin, x_end - x_begin,
                  std::uint8_t{1});
  });
}

bool FilmMask::may_meet_row(int x_begin, int x_end, int y) const {
  const auto row = touched_.begin() + std::ptrdiff_t{y} * width_;
  return std::find(row + x_begin, row + x_end, std::uint8_t{1}) != row + x_end;
}

ShadowMask::ShadowMask(const AreaLight& light, const Shapes& shapes) {
  std::vector<FloorArea> areas;
  area_ = nowhere;
  visit_pieces(shapes, [&](const auto& balls) {
    const FloorArea area = shadow_area(light, hull_points(balls));
    areas.push_back(area);
    area_.x_min = std::min(area_.x_min, area.x_min);
    area_.x_max = std::max(area_.x_max, area.x_max);
    area_.z_min = std::min(area_.z_min, area.z_min);
    area_.z_max = std::max(area_.z_max, area.z_max);
  });
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
