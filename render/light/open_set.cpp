#include "render/light/open_set.h"

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

MIEN_FOR_AVX2_TOO void find_floor(const Ground& ground, bool has_ground, const CameraFrame& camera,
                                  const LaneVectors& origins, const LaneVectors& directions,
                                  LaneSetPixels& pixels, LaneFootprints& prints) {
  // A step on the film is one at distance 1, or anywhere.
  const float all = camera.parallel ? 0.0f : 1.0f, some = camera.parallel ? 1.0f : 0.0f;
  const float fx = camera.forward.x(), fy = camera.forward.y(), fz = camera.forward.z();
  const float rx = camera.step_right.x(), ry = camera.step_right.y(), rz = camera.step_right.z();
  const float dx = camera.step_down.x(), dy = camera.step_down.y(), dz = camera.step_down.z();
  const float px = camera.position.x(), pz = camera.position.z();
  const float lowest = has_ground ? 0.0f : -infinity;  // of what goes up, or misses the floor
  const float start = ground.fade_start, length = ground.fade_end - ground.fade_start;
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float tx = directions.x.lane[i], ty = directions.y.lane[i], tz = directions.z.lane[i];
    const float height = origins.y.lane[i];
    const bool meets = (height > 0.0f) & (ty < lowest);
    const float down = meets ? ty : -1.0f;
    const float distance = meets ? -height / down : 0.0f;
    const float x = origins.x.lane[i] + distance * tx, z = origins.z.lane[i] + distance * tz;
    const float across = std::sqrt((x - px) * (x - px) + (z - pz) * (z - pz));
    const float on = (across - start) / length;
    const float faded = on < 0.0f ? 0.0f : on > 1.0f ? 1.0f : on;
    const float share = 1.0f - faded * faded * (3.0f - 2.0f * faded);
    pixels.point.x.lane[i] = x;
    pixels.point.y.lane[i] = 0.0f;
    pixels.point.z.lane[i] = z;
    pixels.share.lane[i] = meets ? share : 0.0f;
    // A step on the film moves the point along the floor, by the step less what leaves the floor.
    const float scale = some + all * (distance * (tx * fx + ty * fy + tz * fz));
    const float lean_x = tx / down, lean_z = tz / down;
    prints.x.lane[i] = scale * (std::abs(rx - ry * lean_x) + std::abs(dx - dy * lean_x));
    prints.z.lane[i] = scale * (std::abs(rz - ry * lean_z) + std::abs(dz - dy * lean_z));
  }
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
  if (ground.line_spacing <= 0.0f) return covers;
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

}  // namespace

OpenSet::OpenSet(const Scene& scene, const CameraFrame& camera) : scene_(scene), camera_(camera) {
  for (const AreaLight& light : scene.lights) lights_.emplace_back(light);
}

LaneSetPixels OpenSet::pixels(int x, int y) const {
  LaneFloats film_x, film_y;
  for (int i = 0; i < static_cast<int>(lanes); ++i) {
    film_x[i] = static_cast<float>(x + i) + 0.5f;
    film_y[i] = static_cast<float>(y) + 0.5f;
  }
  LaneVectors origins, directions;
  eye_rays(camera_, film_x, film_y, origins, directions);
  LaneSetPixels pixels;
  LaneFootprints prints;
  find_floor(scene_.ground, scene_.has_ground, camera_, origins, directions, pixels, prints);
  bool any = false;
  for (const float share : pixels.share.lane) any |= share > 0.0f;
  LaneCovers covers;
  LaneColors light;
  if (any) {
    covers = covers_of(scene_.ground, pixels.point, prints);
    for (std::size_t k = 0; k < lights_.size(); ++k) {
      const LaneFloats share = light_on_floor(lights_[k], pixels.point);
      const Color& radiance = scene_.lights[k].radiance;
      for (int i = 0; i < static_cast<int>(lanes); ++i) {
        light.red[i] += share[i] * radiance[0];
        light.green[i] += share[i] * radiance[1];
        light.blue[i] += share[i] * radiance[2];
      }
    }
  }
  const LaneFloats& up = directions.y;
  LaneColors &shown = pixels.radiance, &albedo = pixels.visible_albedo;
  show_channel(scene_, 0, up, covers, light.red, pixels.share, shown.red, albedo.red);
  show_channel(scene_, 1, up, covers, light.green, pixels.share, shown.green, albedo.green);
  show_channel(scene_, 2, up, covers, light.blue, pixels.share, shown.blue, albedo.blue);
  return pixels;
}

}  // namespace mien::render
