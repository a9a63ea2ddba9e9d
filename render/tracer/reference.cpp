#include "render/tracer/reference.h"

#include <algorithm>
#include <numbers>
#include <optional>

#include "render/image/luminance.h"
#include "render/light/floor.h"
#include "render/light/light.h"
#include "render/light/shading.h"
#include "render/math/constants.h"
#include "render/math/directions.h"
#include "render/tracer/pixel.h"
#include "render/tracer/primary_rays.h"

namespace mien::render {
namespace {

/// What a camera ray shows.
struct CameraHit {
  Color unlit = Color::Zero();  ///< radiance that no shadow ray decides: backdrop, emission
  bool is_figure = false;
  std::optional<Surface> surface;  ///< of a solid
  bool is_lit = false;             ///< a surface or the floor
  Vec3 origin = Vec3::Zero();      ///< of its shadow rays
  Vec3 normal = Vec3::UnitY();
  Color albedo = Color::Zero();

  /// Radiance towards the camera per irradiance from the unit direction `towards`.
  Color reflected(const Vec3& towards) const {
    return surface ? reflectance(*surface, towards) : Color(std::numbers::inv_pi_v<float> * albedo);
  }
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
  void begin(int first, int last, bool with_figure);
  void trace();
  CameraHit hit(int i, const Hits& figure_hits, const Hits& set_hits) const;
  void light_from(const AreaLight& light, int number);
  void light_from_sky();
  void cast(int i, const Vec3& towards, float distance, const Color& radiance);
  void finish_rays();
  void add_radiance(const CameraHit& from, const Color& radiance) {
    (from.is_figure ? figure : background) += radiance;
  }

  const PreparedScene& prepared_;
  Pixel pixel_;
  bool with_figure_ = true;
  Samples samples_;
  RayPacket camera_rays_;
  std::array<CameraHit, lanes> hits_;
  RayPacket shadow_rays_;
  std::array<int, lanes> lit_;        // of each shadow ray: the sample that it lights
  std::array<Color, lanes> carried_;  // and the radiance that it adds if nothing occludes it
};

void ReferencePixel::add(int first, int last, bool with_figure) {
  begin(first, last, with_figure);
  trace();
  const Scene& scene = prepared_.scene;
  for (std::size_t k = 0; k < scene.lights.size(); ++k)
    light_from(scene.lights[k], static_cast<int>(k));
  light_from_sky();
}

void ReferencePixel::begin(int first, int last, bool with_figure) {
  with_figure_ = with_figure;
  samples_.count = 0;
  for (int i = first; i < last; ++i) {
    Sample& sample = samples_.next();
    sample.pixel = &pixel_;
    sample.index = i;
    if (prepared_.closing_solids != nullptr || prepared_.closing_camera)
      sample.time = prepared_.quality.shutter * pixel_.sampler.point(Dimension::Time, i).u;
    sample.present = present_figures(pixel_.sampler, prepared_.opacities, i);
  }
}

// The camera ray ends at the floor, which hides solids below it.
void ReferencePixel::trace() {
  LaneVectors origins, directions;
  primary_rays(prepared_, samples_, origins, directions);
  camera_rays_.count = 0;
  for (int i = 0; i < samples_.count; ++i) {
    const std::optional<float> floor = prepared_.scene.has_ground
                                           ? distance_to_floor(origins.at(i), directions.at(i))
                                           : std::nullopt;
    camera_rays_.push(origins.at(i), directions.at(i), floor.value_or(infinity), samples_[i].time,
                      samples_[i].present);
  }
  Hits figure_hits, set_hits;
  std::fill_n(figure_hits.shape, packet_size, -1);
  std::fill_n(set_hits.shape, packet_size, -1);
  if (with_figure_) figure_hits = prepared_.figure.intersect(camera_rays_);
  if (prepared_.static_solids != nullptr)
    set_hits = prepared_.static_solids->intersect(camera_rays_);
  for (int i = 0; i < samples_.count; ++i) {
    const CameraHit& now = hits_[static_cast<std::size_t>(i)] = hit(i, figure_hits, set_hits);
    add_radiance(now, now.unlit);
    covered += now.is_figure ? 1 : 0;
  }
}

CameraHit ReferencePixel::hit(int i, const Hits& figure_hits, const Hits& set_hits) const {
  const Scene& scene = prepared_.scene;
  const CameraRay ray{camera_rays_.origin(i), camera_rays_.direction(i)};
  const bool shows_set = set_hits.shape[i] >= 0;
  const bool shows_figure =
      figure_hits.shape[i] >= 0 && (!shows_set || figure_hits.distance[i] <= set_hits.distance[i]);
  CameraHit found;
  if (shows_figure || shows_set) {
    const Hits& hits = shows_figure ? figure_hits : set_hits;
    const Vec3 point = ray.origin + hits.distance[i] * ray.direction;
    found.is_figure = shows_figure;
    found.surface = shows_figure ? surface_at(scene, prepared_.solids, prepared_.closing_solids,
                                              prepared_.figure.shapes(), hits.shape[i], point,
                                              ray.direction, samples_[i].time)
                                 : surface_at(scene, scene.static_solids, nullptr,
                                              prepared_.static_solids->shapes(), hits.shape[i],
                                              point, ray.direction, 0.0f);
    found.unlit = found.surface->material->emission;
    found.origin = found.surface->origin;
    found.normal = found.surface->normal;
    found.albedo = found.surface->albedo;
    found.is_lit = true;
    return found;
  }
  found.unlit = backdrop_radiance(scene.sky, ray.direction);
  if (!scene.has_ground) return found;
  const std::optional<FloorPoint> floor =
      visible_floor(scene.ground, camera_of(prepared_, samples_[i]), ray);
  if (!floor) return found;
  found.unlit *= 1.0f - floor->share;
  found.albedo = floor->share * albedo_at(scene.ground, floor->point);
  found.origin = floor->point;
  found.is_lit = true;
  return found;
}

void ReferencePixel::light_from(const AreaLight& light, int number) {
  for (int i = 0; i < samples_.count; ++i) {
    const CameraHit& lit = hits_[static_cast<std::size_t>(i)];
    if (!lit.is_lit) continue;
    const LightSample chosen = sample(
        light, lit.origin, pixel_.sampler.point(Dimension::FirstLight, number, samples_[i].index));
    const float cosine = lit.normal.dot(chosen.towards);
    if (cosine > 0.0f)
      cast(i, chosen.towards, chosen.distance,
           cosine * chosen.perpendicular * lit.reflected(chosen.towards));
  }
  finish_rays();
}

// Light from below comes through the floor (Sky), so a ray is occluded by nothing beyond it.
void ReferencePixel::light_from_sky() {
  const Scene& scene = prepared_.scene;
  for (int i = 0; i < samples_.count; ++i) {
    const CameraHit& lit = hits_[static_cast<std::size_t>(i)];
    if (!lit.is_lit) continue;
    const Vec3 towards =
        cosine_direction(lit.normal, pixel_.sampler.point(Dimension::FigureSky, samples_[i].index));
    const std::optional<float> floor =
        scene.has_ground ? distance_to_floor(lit.origin, towards) : std::nullopt;
    cast(i, towards, floor.value_or(infinity), lit.albedo * sky_radiance(scene.sky, towards));
  }
  finish_rays();
}

void ReferencePixel::cast(int i, const Vec3& towards, float distance, const Color& radiance) {
  if ((radiance == 0.0f).all()) return;
  const auto ray = static_cast<std::size_t>(shadow_rays_.count);
  lit_[ray] = i;
  carried_[ray] = radiance;
  shadow_rays_.push(hits_[static_cast<std::size_t>(i)].origin, towards, distance, samples_[i].time,
                    samples_[i].present);
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
    add_radiance(hits_[static_cast<std::size_t>(lit_[ray])], carried_[ray]);
  }
  shadow_rays_.count = 0;
}

/// Share of the luminance of the set behind the figure that its shadow takes away.
float shadow_alpha(const Color& left, const Color& whole) {
  const float all = relative_luminance(whole);
  return all > 0.0f ? std::clamp(1.0f - relative_luminance(left) / all, 0.0f, 1.0f) : 0.0f;
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
