#include "render/light/unshadowed_background.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "render/math/constants.h"
#include "render/math/for_avx2.h"

namespace mien::render {
namespace {

constexpr float over_pi = std::numbers::inv_pi_v<float>;

/// Finds the points of the floor that rays meet, and how much of it has not faded.
MIEN_FOR_AVX2_TOO void find_floor(const Ground& ground, bool has_ground, const CameraFrame& camera,
                                  const LaneRays& rays, LaneBackground& pixels) {
  const bool parallel = camera.parallel;
  const float camera_x = camera.position.x(), camera_z = camera.position.z();
  const float lowest = has_ground ? 0.0f : -infinity;  // directions at and above it miss the floor
  const float start = ground.fade_start, end = ground.fade_end, length = end - start;
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float from_x = rays.origin.x.lane[i], height = rays.origin.y.lane[i];
    const float from_z = rays.origin.z.lane[i], down = rays.direction.y.lane[i];
    const bool meets = (height > 0.0f) & (down < lowest);
    const float s = meets ? -height / down : 0.0f;
    const float x = from_x + s * rays.direction.x.lane[i];
    const float z = from_z + s * rays.direction.z.lane[i];
    const float aside = x - (parallel ? camera_x : from_x);
    const float ahead = z - (parallel ? camera_z : from_z);
    const float across = std::sqrt(aside * aside + ahead * ahead);
    const bool seen = meets & (across < end);
    const float part = (across - start) / length;
    const float faded = part < 0.0f ? 0.0f : part > 1.0f ? 1.0f : part;
    const float share = 1.0f - faded * faded * (3.0f - 2.0f * faded);
    pixels.point.x.lane[i] = seen ? x : from_x;
    pixels.point.y.lane[i] = 0.0f;
    pixels.point.z.lane[i] = seen ? z : from_z;
    pixels.share.lane[i] = seen ? share : 0.0f;
  }
}

/// Widths along x and z of the floor that pixels cover: a step on the image plane moves the point
/// along the floor by the step less what leaves the floor.
MIEN_FOR_AVX2_TOO void find_footprints(const CameraFrame& camera, const LaneRays& rays,
                                       LaneFloats& width_x, LaneFloats& width_z) {
  const bool parallel = camera.parallel;
  const float fx = camera.forward.x(), fy = camera.forward.y(), fz = camera.forward.z();
  const float rx = camera.step_right.x(), ry = camera.step_right.y(), rz = camera.step_right.z();
  const float dx = camera.step_down.x(), dy = camera.step_down.y(), dz = camera.step_down.z();
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float tx = rays.direction.x.lane[i], tz = rays.direction.z.lane[i];
    const float ty = rays.direction.y.lane[i] < 0.0f ? rays.direction.y.lane[i] : -1.0f;
    const float depth = -rays.origin.y.lane[i] / ty * (tx * fx + ty * fy + tz * fz);
    const float scale = parallel ? 1.0f : depth;
    const float lean_x = tx / ty, lean_z = tz / ty;
    width_x.lane[i] = scale * (std::abs(rx - ry * lean_x) + std::abs(dx - dy * lean_x));
    width_z.lane[i] = scale * (std::abs(rz - ry * lean_z) + std::abs(dz - dy * lean_z));
  }
}

/// Returns the proportion of an interval of this width about x that is covered by lines centred on
/// the multiples of a spacing; `line` is their width over the spacing.
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
                                            const LaneFloats& width_x, const LaneFloats& width_z,
                                            float spacing, float line_width) {
  LaneFloats cover;
  const float offset_x = ground.offset_x, offset_z = ground.offset_z;
  const float inverse = 1.0f / spacing, line = line_width / spacing;
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float in_x = covered(point.x.lane[i] - offset_x, width_x.lane[i], inverse, line);
    const float in_z = covered(point.z.lane[i] - offset_z, width_z.lane[i], inverse, line);
    cover.lane[i] = in_x + in_z - in_x * in_z;
  }
  return cover;
}

/// Finds the proportions of the pixels that lines of the floor cover.
void find_lines(const Ground& ground, const CameraFrame& camera, const LaneRays& rays,
                const LaneVectors& point, LaneFloats& lines, LaneFloats& major_lines) {
  LaneFloats width_x, width_z;
  find_footprints(camera, rays, width_x, width_z);
  lines = cover_of_lines(ground, point, width_x, width_z, ground.line_spacing, ground.line_width);
  if (ground.major_every == 0) return;
  major_lines = cover_of_lines(ground, point, width_x, width_z,
                               static_cast<float>(ground.major_every) * ground.line_spacing,
                               2.0f * ground.line_width);
}

/// One channel of what the set shows; `light` is the irradiance of the lights alone.
MIEN_FOR_AVX2_TOO void show_channel(const Scene& scene, int channel, const LaneFloats& elevation,
                                    const LaneFloats& lines, const LaneFloats& major_lines,
                                    const LaneFloats& light, const LaneFloats& share,
                                    LaneFloats& radiance, LaneFloats& visible_albedo) {
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
    const float fine = plain + lines.lane[i] * (line - plain);
    const float albedo = share.lane[i] * (fine + major_lines.lane[i] * (major - fine));
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
constexpr std::array<LaneFloats, 4> cubic_weights() {
  std::array<LaneFloats, 4> weight{};
  for (unsigned i = 0; i < lanes; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(lanes);
    weight[0].lane[i] = -t * (t - 1.0f) * (t - 2.0f) / 6.0f;
    weight[1].lane[i] = (t + 1.0f) * (t - 1.0f) * (t - 2.0f) / 2.0f;
    weight[2].lane[i] = -(t + 1.0f) * t * (t - 2.0f) / 2.0f;
    weight[3].lane[i] = (t + 1.0f) * t * (t - 1.0f) / 6.0f;
  }
  return weight;
}
constexpr std::array<LaneFloats, 4> cubic = cubic_weights();

MIEN_FOR_AVX2_TOO LaneFloats interpolated(const float* nodes) {
  LaneFloats light;
  const float a = nodes[0], b = nodes[1], c = nodes[2], d = nodes[3];
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i)
    light.lane[i] =
        a * cubic[0].lane[i] + b * cubic[1].lane[i] + c * cubic[2].lane[i] + d * cubic[3].lane[i];
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
    const LaneFloats found = irradiance(light, points);
    nodes.insert(nodes.end(), found.lane, found.lane + lanes);
  }
  return nodes;
}

/// Height of the lowest point of a light above the floor.
float lowest_height(const FloorLight& light) {
  float lowest = infinity;
  for (const Vec3& corner : light.corners) lowest = std::min(lowest, corner.y());
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

// `light_at` gives the irradiance of a light, of radiance 1, at the points of the floor.
template <class LightAt>
LaneBackground UnshadowedBackground::shown(const LaneRays& rays, const LightAt& light_at) const {
  LaneBackground pixels;
  find_floor(scene_.ground, scene_.has_ground, camera_, rays, pixels);
  LaneColors light;
  const bool any = std::any_of(pixels.share.lane, pixels.share.lane + lanes,
                               [](float share) { return share > 0.0f; });
  for (std::size_t k = 0; any && k < lights_.size(); ++k)
    add_light(light_at(k, pixels.point), scene_.lights[k].radiance, light);
  LaneFloats lines, major;
  if (scene_.ground.line_spacing > 0.0f)
    find_lines(scene_.ground, camera_, rays, pixels.point, lines, major);
  const LaneFloats& elevation = rays.direction.y;
  LaneColors &shown = pixels.radiance, &albedo = pixels.visible_albedo;
  const auto show = [&](int channel, const LaneFloats& from_lights, LaneFloats& radiance,
                        LaneFloats& visible) {
    show_channel(scene_, channel, elevation, lines, major, from_lights, pixels.share, radiance,
                 visible);
  };
  show(0, light.red, shown.red, albedo.red);
  show(1, light.green, shown.green, albedo.green);
  show(2, light.blue, shown.blue, albedo.blue);
  return pixels;
}

LaneBackground UnshadowedBackground::along(const LaneRays& rays) const {
  return shown(rays, [&](std::size_t light, const LaneVectors& points) {
    return irradiance(lights_[light], points);
  });
}

UnshadowedRow::UnshadowedRow(const UnshadowedBackground& background, int y, int width)
    : background_(background), y_(static_cast<float>(y) + 0.5f), nodes_(background.lights_.size()) {
  const CameraFrame& camera = background.camera_;
  const FloorRow row(camera, y);
  if (!background.scene_.has_ground || camera.parallel || !row.is_in_order() || row.drop <= 0.0f ||
      row.height <= 0.0f)
    return;
  const float step = row.height / row.drop * std::hypot(row.step_x, row.step_z);
  for (std::size_t k = 0; k < nodes_.size(); ++k)
    if (static_cast<float>(node_distance) * step <= smooth_share * background.heights_[k])
      nodes_[k] = nodes_of(background.lights_[k], row, width);
}

// Irradiance is not smooth where the floor passes behind the light.
LaneFloats UnshadowedRow::light_at(std::size_t light, int x, const LaneVectors& points) const {
  if (!nodes_[light].empty()) {
    const float* nodes = &nodes_[light][static_cast<std::size_t>(x / node_distance)];
    if (nodes[0] > 0.0f && nodes[1] > 0.0f && nodes[2] > 0.0f && nodes[3] > 0.0f)
      return interpolated(nodes);
  }
  return irradiance(background_.lights_[light], points);
}

LaneBackground UnshadowedRow::pixels(int x) const {
  LaneFloats columns, row;
  for (int i = 0; i < static_cast<int>(lanes); ++i) {
    columns[i] = static_cast<float>(x + i) + 0.5f;
    row[i] = y_;
  }
  return background_.shown(
      camera_rays(background_.camera_, columns, row),
      [&](std::size_t light, const LaneVectors& points) { return light_at(light, x, points); });
}

}  // namespace mien::render
