#include "render/tracer/reference.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "render/light/floor.h"
#include "render/light/light.h"
#include "render/light/shading.h"
#include "render/math/constants.h"
#include "render/tracer/camera_rays.h"
#include "render/tracer/samples.h"

namespace mien::render {
namespace {

/// Whether lines of this width, centred on the multiples of a spacing along x and z, cover a point.
bool is_on_line(float x, float z, float spacing, float width) {
  const auto covers = [&](float at) {
    return std::abs(at - spacing * std::round(at / spacing)) <= 0.5f * width;
  };
  return covers(x) || covers(z);
}

/// Albedo of the floor at a point.
Color albedo_at(const Ground& ground, const Vec3& point) {
  if (ground.line_spacing <= 0.0f) return ground.albedo;
  const float x = point.x() - ground.offset_x, z = point.z() - ground.offset_z;
  if (ground.major_every != 0 &&
      is_on_line(x, z, static_cast<float>(ground.major_every) * ground.line_spacing,
                 2.0f * ground.line_width))
    return ground.major_albedo;
  return is_on_line(x, z, ground.line_spacing, ground.line_width) ? ground.line_albedo
                                                                  : ground.albedo;
}

/// Proportion of the floor's light that has not faded at a horizontal distance, metres.
float visibility(const Ground& ground, float distance) {
  const float part = (distance - ground.fade_start) / (ground.fade_end - ground.fade_start);
  const float x = std::clamp(part, 0.0f, 1.0f);
  return 1.0f - x * x * (3.0f - 2.0f * x);
}

/// What a camera ray shows.
struct CameraHit {
  Color unlit = Color::Zero();  ///< radiance that no shadow ray decides: backdrop, emission
  bool is_figure = false;
  bool is_lit = false;  ///< a solid or the floor
  Surface surface;      ///< if it is lit
};

/// The samples of a pixel, up to eight at a time.
class ReferencePixel {
 public:
  ReferencePixel(const PreparedScene& prepared, int x, int y) : prepared_(prepared) {
    pixel_.x = x;
    pixel_.y = y;
    pixel_.sampler = PixelSampler(prepared.quality.seed, x, y);
  }

  /// Adds samples [first, last). Without the figure what is behind it is seen, unshadowed by it.
  void add(int first, int last, bool with_figure);

  Color figure = Color::Zero();      ///< sums over the samples: radiance of the figure
  Color background = Color::Zero();  ///< and of the set
  int covered = 0;                   ///< samples that show the figure

 private:
  CameraHit hit(const RayPacket& rays, int ray, const FirstHit& first) const;
  void light_from(const AreaLight& light, int number);
  void light_from_sky();
  void cast(std::size_t lit, const Vec3& towards, float distance, const Color& radiance);
  void finish_rays();
  void add_radiance(const CameraHit& from, const Color& radiance) {
    (from.is_figure ? figure : background) += radiance;
  }

  const PreparedScene& prepared_;
  Pixel pixel_;
  bool with_figure_ = true;
  std::vector<Sample> samples_;
  std::array<CameraHit, lanes> hits_;
  LaneVectors origins_;  // of the shadow rays
  LaneVectors normals_;
  RayPacket shadow_rays_;
  std::array<std::size_t, lanes> lit_;  // of each shadow ray: the sample that it lights
  std::array<Color, lanes> carried_;    // and the radiance that it adds if nothing occludes it
};

void ReferencePixel::add(int first, int last, bool with_figure) {
  with_figure_ = with_figure;
  samples_.clear();
  for (int i = first; i < last; ++i) samples_.push_back(sample_at(prepared_, pixel_, i));
  const RayPacket rays = camera_rays(prepared_, std::span<const Sample>(samples_));
  const auto first_hit = first_hits(prepared_, rays, with_figure);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const CameraHit& now = hits_[i] = hit(rays, static_cast<int>(i), first_hit[i]);
    origins_.set(static_cast<int>(i), now.surface.origin);
    normals_.set(static_cast<int>(i), now.surface.normal);
    add_radiance(now, now.unlit);
    covered += now.is_figure ? 1 : 0;
  }
  for (int k = 0; const AreaLight& light : prepared_.scene.lights) light_from(light, k++);
  light_from_sky();
}

CameraHit ReferencePixel::hit(const RayPacket& rays, int ray, const FirstHit& first) const {
  const Scene& scene = prepared_.scene;
  if (first.exists()) {
    const Surface surface = surface_at(prepared_, rays, ray, first);
    return {surface.material->emission, first.of_figure, true, surface};
  }
  const Color backdrop = backdrop_radiance(scene.sky, rays.direction(ray));
  const std::optional<Vec3> point = floor_point(rays, ray);
  if (!point) return {backdrop, false, false, floor_surface(Vec3::Zero(), Color::Zero())};
  const Vec3 eye = prepared_.camera.parallel ? prepared_.camera.position : rays.origin(ray);
  const float share =
      visibility(scene.ground, std::hypot(point->x() - eye.x(), point->z() - eye.z()));
  return {(1.0f - share) * backdrop, false, share > 0.0f,
          floor_surface(*point, share * albedo_at(scene.ground, *point))};
}

void ReferencePixel::light_from(const AreaLight& light, int number) {
  const std::span<const Sample> samples(samples_);
  const LaneLights chosen =
      sample(light, origins_, points_for(samples, Dimension::FirstLight, number));
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const auto lane = static_cast<int>(i);
    const Vec3 towards = chosen.towards.at(lane);
    const float cosine = normals_.at(lane).dot(towards);
    if (hits_[i].is_lit && cosine > 0.0f)
      cast(i, towards, chosen.distance[lane],
           (cosine * chosen.share[lane]) * light.radiance * reflectance(hits_[i].surface, towards));
  }
  finish_rays();
}

// Light from below comes through the floor (Sky), so a ray is occluded by nothing beyond it.
void ReferencePixel::light_from_sky() {
  const Scene& scene = prepared_.scene;
  const LaneVectors directions = cosine_directions(
      normals_, points_for(std::span<const Sample>(samples_), Dimension::FigureSky));
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (!hits_[i].is_lit) continue;
    const Vec3 towards = directions.at(static_cast<int>(i));
    const Surface& surface = hits_[i].surface;
    const std::optional<float> floor =
        scene.has_ground ? distance_to_floor(surface.origin, towards) : std::nullopt;
    cast(i, towards, floor.value_or(infinity), surface.albedo * sky_radiance(scene.sky, towards));
  }
  finish_rays();
}

void ReferencePixel::cast(std::size_t lit, const Vec3& towards, float distance,
                          const Color& radiance) {
  if ((radiance == 0.0f).all()) return;
  const auto ray = static_cast<std::size_t>(shadow_rays_.count);
  lit_[ray] = lit;
  carried_[ray] = radiance;
  shadow_rays_.push(hits_[lit].surface.origin, towards, distance, samples_[lit].time,
                    samples_[lit].present);
}

void ReferencePixel::finish_rays() {
  if (shadow_rays_.count == 0) return;
  std::uint32_t occluded = 0;
  if (with_figure_) occluded |= prepared_.figure.occluded(shadow_rays_);
  if (prepared_.static_solids != nullptr)
    occluded |= prepared_.static_solids->occluded(shadow_rays_);
  for (int k = 0; k < shadow_rays_.count; ++k) {
    if (((occluded >> k) & 1u) != 0) continue;
    const auto ray = static_cast<std::size_t>(k);
    add_radiance(hits_[lit_[ray]], carried_[ray]);
  }
  shadow_rays_.count = 0;
}

void draw_pixel(const PreparedScene& prepared, int x, int y, const Canvas& canvas) {
  const int samples = prepared.quality.samples_per_pixel;
  const float share = 1.0f / static_cast<float>(samples);
  const auto add_all = [&](bool with_figure) {
    ReferencePixel pixel(prepared, x, y);
    for (int first = 0; first < samples; first += static_cast<int>(lanes))
      pixel.add(first, std::min(first + static_cast<int>(lanes), samples), with_figure);
    return pixel;
  };
  const ReferencePixel pixel = add_all(true);
  const bool shown = prepared.quality.background == Background::shown;
  const Color color = share * (shown ? Color(pixel.figure + pixel.background) : pixel.figure);
  std::copy_n(color.data(), 3, canvas.color(x, y));
  if (shown) return;
  float& alpha = canvas.alpha(x, y);
  alpha = share * static_cast<float>(pixel.covered);
  if (prepared.quality.background == Background::shadow)
    alpha = std::max(alpha, shadow_alpha(pixel.background, add_all(false).background));
}

}  // namespace

void draw_reference(const PreparedScene& prepared, const Tile& part, const Canvas& canvas) {
  for (int y = part.y_begin; y < part.y_end; ++y)
    for (int x = part.x_begin; x < part.x_end; ++x) draw_pixel(prepared, x, y, canvas);
}

}  // namespace mien::render
