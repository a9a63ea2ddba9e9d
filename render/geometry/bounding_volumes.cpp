#include "render/geometry/bounding_volumes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/geometry/shape_pieces.h"
#include "render/math/constants.h"

namespace mien::render {
namespace {

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

/// Of the box around balls.
template <class Balls>
BoundingSphere sphere_around(const Balls& balls) {
  Eigen::Array3f low = Eigen::Array3f::Constant(infinity), high = -low;
  for (const Ball& ball : balls) {
    low = low.min(ball.centre.array() - ball.radius);
    high = high.max(ball.centre.array() + ball.radius);
  }
  return {(0.5f * (low + high)).matrix(), 0.5f * (high - low).matrix().norm()};
}

float area(const Triangle& triangle) {
  return 0.5f * (triangle.b - triangle.a).cross(triangle.c - triangle.a).norm();
}

/// A quarter of the surface, as of any convex solid (Cauchy).
float silhouette(const PreparedCone& cone) {
  const float a = cone.radius_a, b = cone.radius_b;
  return 0.25f * pi * ((a + b) * cone.axis.norm() + 2.0f * (a * a + b * b));
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

bool may_intersect(const BoundingSphere& sphere, const Vec3& origin, const Vec3& direction) {
  const Vec3 towards = sphere.centre - origin;
  const float along = towards.dot(direction);
  const float squared = towards.squaredNorm();
  const float aside = squared - along * along;  // squared
  const float rounding = 1e-5f * squared;
  return sphere.radius >= 0.0f && along > -1.001f * sphere.radius - rounding &&
         aside <= 1.001f * sphere.radius * sphere.radius + rounding;
}

std::vector<FigurePiece> pieces_of(const Shapes& shapes) {
  std::vector<FigurePiece> pieces;
  for (std::size_t i = 0; i < shapes.cones.size(); ++i) {
    const std::size_t first = pieces.size();
    visit_cone_pieces(shapes, i, [&](const auto& balls) {
      pieces.push_back({sphere_around(balls), 0.0f});
    });
    const float each = silhouette(shapes.cones[i]) / static_cast<float>(pieces.size() - first);
    for (std::size_t k = first; k < pieces.size(); ++k) pieces[k].silhouette = each;
  }
  // Triangles are near each other if they are in the list (Mesh::triangles).
  constexpr std::size_t together = 64;
  std::vector<Ball> corners;
  float surface = 0.0f;
  std::size_t number = 0;
  visit_triangle_pieces(shapes, [&](const auto& balls) {
    corners.insert(corners.end(), balls.begin(), balls.end());
    surface += area(shapes.triangles[number++]);
    if (number % together != 0 && number != shapes.triangles.size()) return;
    pieces.push_back({sphere_around(corners), 0.25f * surface});
    corners.clear();
    surface = 0.0f;
  });
  return pieces;
}

PixelMask::PixelMask(const Camera& camera, const Shapes& shapes, float filter_half_width)
    : words_across_((camera.width + bits - 1) / bits),
      words_(static_cast<std::size_t>(words_across_) * static_cast<std::size_t>(camera.height)) {
  if (camera.aperture_radius > 0.0f && !shapes.empty()) {
    // What is out of focus may show anywhere.
    for (int y = 0; y < camera.height; ++y) touch(0, camera.width, y);
    return;
  }
  const CameraFrame frame = frame_of(camera);
  // Pixel i has rays through i + ½ ± the half width.
  const float margin = filter_half_width + 0.02f;
  const auto first = [&](float edge, int size) {
    return static_cast<int>(std::clamp(std::ceil(edge - margin - 0.5f), 0.0f, float(size)));
  };
  const auto past = [&](float edge, int size) {
    return static_cast<int>(std::clamp(std::floor(edge + margin + 0.5f), 0.0f, float(size)));
  };
  visit_pieces(shapes, [&](const auto& balls) {
    FilmBox box = film_box(frame, balls[0]);
    for (std::size_t i = 1; i < balls.size(); ++i) box.include(film_box(frame, balls[i]));
    const bool all = box.everywhere;
    const int x_begin = all ? 0 : first(box.x.low, camera.width);
    const int x_end = all ? camera.width : past(box.x.high, camera.width);
    const int y_begin = all ? 0 : first(box.y.low, camera.height);
    const int y_end = all ? camera.height : past(box.y.high, camera.height);
    for (int y = y_begin; y < y_end; ++y) touch(x_begin, x_end, y);
  });
}

namespace {

/// Bits x_begin … x_end − 1 of the word whose bit 0 is at x = first.
std::uint64_t bits_between(int x_begin, int x_end, int first) {
  const int low = std::max(x_begin - first, 0), high = std::min(x_end - first, 64);
  if (low >= high) return 0;
  return (~std::uint64_t{0} >> (64 - (high - low))) << low;
}

}  // namespace

void PixelMask::touch(int x_begin, int x_end, int y) {
  const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(words_across_);
  for (int k = x_begin / bits; k * bits < x_end; ++k)
    words_[row + static_cast<std::size_t>(k)] |= bits_between(x_begin, x_end, k * bits);
}

bool PixelMask::may_intersect_row(int x_begin, int x_end, int y) const {
  for (int k = x_begin / bits; k * bits < x_end; ++k)
    if ((word(k, y) & bits_between(x_begin, x_end, k * bits)) != 0) return true;
  return false;
}

}  // namespace mien::render
