#include "render/light/unshadowed_background.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/math/constants.h"
#include "render/math/for_avx2.h"

namespace mien::render {
namespace {

constexpr float over_pi = std::numbers::inv_pi_v<float>;

/// Widths along x and z of what pixels cover of the floor.
struct LaneFootprints {
  LaneFloats x;
  LaneFloats z;
};

/// How much of the floor lines cover, fine ones and major ones.
struct LaneCovers {
  LaneFloats fine;
  LaneFloats major;
};

/// Points of the image plane as seen from the optical axis, pixels.
struct LaneImagePoints {
  LaneFloats right;
  float down;
};

/// Where the floor is seen that all pixels show, and of which nothing has faded.
MIEN_FOR_AVX2_TOO void find_near_floor(const FloorRow& row, const LaneImagePoints& image,
                                       LaneBackgroundPixels& pixels) {
  const float row_x = row.x, row_z = row.z, from_x = row.from_x, from_z = row.from_z;
  const float step_x = row.step_x, step_z = row.step_z, drop = row.drop, height = row.height;
  const float drop_step = row.drop_step;
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float u = image.right.lane[i];
    const float s = height / (drop + u * drop_step);  // as FloorRow::at
    pixels.point.x.lane[i] = row_x + s * (from_x + u * step_x);
    pixels.point.y.lane[i] = 0.0f;
    pixels.point.z.lane[i] = row_z + s * (from_z + u * step_z);
    pixels.share.lane[i] = 1.0f;
  }
}

/// Where the floor is seen, and how little of it has faded.
MIEN_FOR_AVX2_TOO void find_floor(const Ground& ground, bool has_ground, const CameraFrame& camera,
                                  const FloorRow& row, const LaneImagePoints& image,
                                  LaneBackgroundPixels& pixels) {
  // A step on the film is one at distance 1, or anywhere.
  const float all = camera.parallel ? 0.0f : 1.0f, some = camera.parallel ? 1.0f : 0.0f;
  const float right = camera.step_right.y(), down = image.down * camera.step_down.y();
  const float forward = camera.forward.y(), eye = camera.position.y();
  const float px = camera.position.x(), pz = camera.position.z();
  const float lowest = has_ground ? 0.0f : -infinity;  // of what goes up, or misses the floor
  const float start = ground.fade_start, end = ground.fade_end, length = end - start;
  const float row_x = row.x, row_z = row.z, from_x = row.from_x, from_z = row.from_z;
  const float step_x = row.step_x, step_z = row.step_z, drop = row.drop, height = row.height;
  const float drop_step = row.drop_step;
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float u = image.right.lane[i];
    const float aside = u * right + down;
    const bool meets = (eye + some * aside > 0.0f) & (forward + all * aside < lowest);
    const float s = height / (drop + u * drop_step);  // as FloorRow::at
    const float x = row_x + s * (from_x + u * step_x), z = row_z + s * (from_z + u * step_z);
    const float across = std::sqrt((x - px) * (x - px) + (z - pz) * (z - pz));
    // Where rounding puts the horizon elsewhere for s than for `meets`, x and z are no numbers.
    const bool seen = meets & (across < end);
    const float on = (across - start) / length;
    const float faded = on < 0.0f ? 0.0f : on > 1.0f ? 1.0f : on;
    const float share = 1.0f - faded * faded * (3.0f - 2.0f * faded);
    pixels.point.x.lane[i] = seen ? x : px;
    pixels.point.y.lane[i] = 0.0f;
    pixels.point.z.lane[i] = seen ? z : pz;
    pixels.share.lane[i] = seen ? share : 0.0f;
  }
}

/// A step on the film moves the point along the floor, by the step less what leaves the floor.
MIEN_FOR_AVX2_TOO LaneFootprints footprints(const CameraFrame& camera,
                                            const LaneImagePoints& image) {
  const float all = camera.parallel ? 0.0f : 1.0f, some = camera.parallel ? 1.0f : 0.0f;
  const float fx = camera.forward.x(), fy = camera.forward.y(), fz = camera.forward.z();
  const float rx = camera.step_right.x(), ry = camera.step_right.y(), rz = camera.step_right.z();
  const float dx = camera.step_down.x(), dy = camera.step_down.y(), dz = camera.step_down.z();
  const float v = image.down, eye = camera.position.y();
  LaneFootprints prints;
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float u = image.right.lane[i];
    const float tx = fx + all * (u * rx + v * dx), ty = fy + all * (u * ry + v * dy);
    const float tz = fz + all * (u * rz + v * dz);
    const float down = ty < 0.0f ? ty : -1.0f;
    const float scale = some - all * eye / down;
    const float lean_x = tx / down, lean_z = tz / down;
    prints.x.lane[i] = scale * (std::abs(rx - ry * lean_x) + std::abs(dx - dy * lean_x));
    prints.z.lane[i] = scale * (std::abs(rz - ry * lean_z) + std::abs(dz - dy * lean_z));
  }
  return prints;
}

/// Sines of the rays' elevations.
MIEN_FOR_AVX2_TOO LaneFloats elevations(const CameraFrame& camera, const LaneImagePoints& image) {
  const float all = camera.parallel ? 0.0f : 1.0f;
  const float fx = camera.forward.x(), fy = camera.forward.y(), fz = camera.forward.z();
  const float rx = camera.step_right.x(), ry = camera.step_right.y(), rz = camera.step_right.z();
  const float dx = camera.step_down.x(), dy = camera.step_down.y(), dz = camera.step_down.z();
  const float v = image.down;
  LaneFloats up;
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float u = image.right.lane[i];
    const float tx = fx + all * (u * rx + v * dx), ty = fy + all * (u * ry + v * dy);
    const float tz = fz + all * (u * rz + v * dz);
    up.lane[i] = ty / std::sqrt(tx * tx + ty * ty + tz * tz);
  }
  return up;
}

// As line_cover, without branches.
inline float covered(float x, float width, float inverse_spacing, float line) {
  const float wide = width * inverse_spacing;
  const float breadth = wide > 1e-6f ? wide : 1e-6f;
  const float half = 0.5f * line;
  const auto cumulated = [&](float at) {
    const float whole = std::floor(at + 0.5f);
    const float rest = at - whole;
    return whole * line + (rest < -half ? -half : rest > half ? half : rest);
  };
  const float from = x * inverse_spacing - 0.5f * breadth;
  const float cover = (cumulated(from + breadth) - cumulated(from)) / breadth;
  return cover < 0.0f ? 0.0f : cover > 1.0f ? 1.0f : cover;
}

MIEN_FOR_AVX2_TOO LaneFloats cover_of_lines(const Ground& ground, const LaneVectors& point,
                                            const LaneFootprints& print, float spacing,
                                            float width) {
  LaneFloats cover;
  const float offset_x = ground.offset_x, offset_z = ground.offset_z;
  const float inverse = 1.0f / spacing, line = width / spacing;
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float in_x = covered(point.x.lane[i] - offset_x, print.x.lane[i], inverse, line);
    const float in_z = covered(point.z.lane[i] - offset_z, print.z.lane[i], inverse, line);
    cover.lane[i] = in_x + in_z - in_x * in_z;
  }
  return cover;
}

LaneCovers covers_of(const Ground& ground, const LaneVectors& point, const LaneFootprints& print) {
  LaneCovers covers;
  covers.fine = cover_of_lines(ground, point, print, ground.line_spacing, ground.line_width);
  if (ground.major_every != 0)
    covers.major = cover_of_lines(ground, point, print,
                                  static_cast<float>(ground.major_every) * ground.line_spacing,
                                  2.0f * ground.line_width);
  return covers;
}

/// One channel of what the set shows; `light` is the irradiance of the lights alone.
MIEN_FOR_AVX2_TOO void show_channel(const Scene& scene, int channel, const LaneFloats& elevation,
                                    const LaneCovers& covers, const LaneFloats& light,
                                    const LaneFloats& share, LaneFloats& radiance,
                                    LaneFloats& visible_albedo) {
  const Sky& sky = scene.sky;
  const Ground& ground = scene.ground;
  const float horizon = sky.backdrop_horizon[channel];
  const float rise = sky.backdrop_zenith[channel] - horizon;
  const float plain = ground.albedo[channel], line = ground.line_albedo[channel];
  const float major = ground.major_albedo[channel];
  const float from_sky = sky_irradiance_on_floor(sky)[channel];
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float up = elevation.lane[i];
    const float sine = up < 0.0f ? 0.0f : up > 1.0f ? 1.0f : up;
    const float backdrop = horizon + sine * rise;
    const float fine = plain + covers.fine.lane[i] * (line - plain);
    const float albedo = share.lane[i] * (fine + covers.major.lane[i] * (major - fine));
    visible_albedo.lane[i] = albedo;
    radiance.lane[i] =
        (1.0f - share.lane[i]) * backdrop + albedo * over_pi * (from_sky + light.lane[i]);
  }
}

MIEN_FOR_AVX2_TOO void add_light(const LaneFloats& share, const Color& radiance,
                                 LaneColors& light) {
  const float red = radiance[0], green = radiance[1], blue = radiance[2];
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    light.red.lane[i] += share.lane[i] * red;
    light.green.lane[i] += share.lane[i] * green;
    light.blue.lane[i] += share.lane[i] * blue;
  }
}

constexpr int node_distance = static_cast<int>(lanes);
constexpr float smooth_share = 0.05f;  // of a light's height, between nodes

/// Lagrange's polynomials of third degree at 0, ⅛ … ⅞ of the way from the second of four nodes to
/// the third.
struct Cubic {
  LaneFloats weight[4];

  constexpr Cubic() {
    for (unsigned i = 0; i < lanes; ++i) {
      const float t = static_cast<float>(i) / static_cast<float>(lanes);
      weight[0].lane[i] = -t * (t - 1.0f) * (t - 2.0f) / 6.0f;
      weight[1].lane[i] = (t + 1.0f) * (t - 1.0f) * (t - 2.0f) / 2.0f;
      weight[2].lane[i] = -(t + 1.0f) * t * (t - 2.0f) / 2.0f;
      weight[3].lane[i] = (t + 1.0f) * t * (t - 1.0f) / 6.0f;
    }
  }
};
constexpr Cubic cubic;

MIEN_FOR_AVX2_TOO LaneFloats interpolated(const float* nodes) {
  LaneFloats light;
  const float a = nodes[0], b = nodes[1], c = nodes[2], d = nodes[3];
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i)
    light.lane[i] = a * cubic.weight[0].lane[i] + b * cubic.weight[1].lane[i] +
                    c * cubic.weight[2].lane[i] + d * cubic.weight[3].lane[i];
  return light;
}

/// Irradiance of a light at every eighth pixel of a row, from pixel −8 to some beyond its end.
std::vector<float> nodes_of(const FloorLight& light, const FloorRow& row, int width) {
  std::vector<float> nodes;
  while (static_cast<int>(nodes.size()) < width / node_distance + 4) {
    LaneVectors points;
    for (int i = 0; i < static_cast<int>(lanes); ++i) {
      const int number = static_cast<int>(nodes.size()) + i;
      const FloorPlace place = row.at((number - 1) * node_distance);
      points.set(i, {place.x, 0.0f, place.z});
    }
    const LaneFloats found = light_on_floor(light, points);
    nodes.insert(nodes.end(), found.lane, found.lane + lanes);
  }
  return nodes;
}

/// Height of the lowest point of a light above the floor.
float lowest_height(const FloorLight& light) {
  float lowest = infinity;
  for (int i = 0; i < light.count(); ++i) lowest = std::min(lowest, light.corner(i).y());
  return lowest;
}

}  // namespace

UnshadowedBackground::UnshadowedBackground(const Scene& scene, const CameraFrame& camera)
    : scene_(scene), camera_(camera) {
  for (const AreaLight& light : scene.lights) {
    lights_.emplace_back(light);
    heights_.push_back(lowest_height(lights_.back()));
  }
}

// Distances along a straight line are greatest at its ends.
UnshadowedRow::UnshadowedRow(const UnshadowedBackground& set, int y, int width)
    : set_(set),
      row_(set.camera_, y),
      down_(static_cast<float>(y) + 0.5f - set.camera_.centre_y),
      is_unfaded_(set.scene_.has_ground && !set.camera_.parallel && row_.is_in_order() &&
                  row_.drop > 0.0f && row_.height > 0.0f),
      nodes_(set.lights_.size()) {
  if (!is_unfaded_) return;
  const auto distance = [&](int column) {
    const FloorPlace place = row_.at(column);
    return std::hypot(place.x - row_.x, place.z - row_.z);
  };
  // More than rounding can be.
  is_unfaded_ = 1.0001f * std::max(distance(0), distance(width + node_distance)) <=
                set.scene_.ground.fade_start;
  const float step = row_.height / row_.drop * std::hypot(row_.step_x, row_.step_z);
  for (std::size_t k = 0; k < nodes_.size(); ++k)
    if (static_cast<float>(node_distance) * step <= smooth_share * set.heights_[k])
      nodes_[k] = nodes_of(set.lights_[k], row_, width);
}

// Where a light ends to shine it does not end smoothly.
LaneFloats UnshadowedRow::light_at(std::size_t light, int x, const LaneVectors& points) const {
  if (!nodes_[light].empty()) {
    const float* nodes = &nodes_[light][static_cast<std::size_t>(x / node_distance)];
    if (nodes[0] > 0.0f && nodes[1] > 0.0f && nodes[2] > 0.0f && nodes[3] > 0.0f)
      return interpolated(nodes);
  }
  return light_on_floor(set_.lights_[light], points);
}

LaneBackgroundPixels UnshadowedRow::pixels(int x) const {
  const Scene& scene = set_.scene_;
  LaneImagePoints image{{}, down_};
  for (int i = 0; i < static_cast<int>(lanes); ++i)
    image.right[i] = static_cast<float>(x + i) + 0.5f - row_.centre;
  LaneBackgroundPixels pixels;
  bool any = is_unfaded_;
  LaneFloats up;
  if (is_unfaded_) {
    find_near_floor(row_, image, pixels);
  } else {
    find_floor(scene.ground, scene.has_ground, set_.camera_, row_, image, pixels);
    up = elevations(set_.camera_, image);
    for (const float share : pixels.share.lane) any |= share > 0.0f;
  }
  const bool lined = scene.ground.line_spacing > 0.0f;
  pixels.plain = is_unfaded_ && !lined;
  LaneCovers covers;
  LaneColors light;
  if (any && lined) covers = covers_of(scene.ground, pixels.point, footprints(set_.camera_, image));
  for (std::size_t k = 0; any && k < nodes_.size(); ++k)
    add_light(light_at(k, x, pixels.point), scene.lights[k].radiance, light);
  LaneColors &shown = pixels.radiance, &albedo = pixels.visible_albedo;
  show_channel(scene, 0, up, covers, light.red, pixels.share, shown.red, albedo.red);
  show_channel(scene, 1, up, covers, light.green, pixels.share, shown.green, albedo.green);
  show_channel(scene, 2, up, covers, light.blue, pixels.share, shown.blue, albedo.blue);
  return pixels;
}

}  // namespace mien::render
