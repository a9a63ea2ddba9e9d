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
#include "render/tracer/shadow_rays.h"

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

/// The samples of a pixel, up to eight at a time.
class ReferencePixel {
 public:
  /// Without the figure what is behind it is seen, unshadowed by it.
  ReferencePixel(const PreparedScene& prepared, int x, int y, bool with_figure)
      : prepared_(prepared), with_figure_(with_figure), shadow_rays_(prepared, with_figure) {
    pixel_.x = x;
    pixel_.y = y;
    pixel_.sampler = PixelSampler(prepared.quality.seed, x, y);
  }

  /// Adds samples [first, last).
  void add(int first, int last);

  Color figure = Color::Zero();      ///< sums over the samples: radiance of the figure
  Color background = Color::Zero();  ///< and of the set
  int covered = 0;                   ///< samples that show the figure

 private:
  void hit(const RayPacket& rays, std::size_t sample, const FirstHit& first);
  void light_from(const AreaLight& light, int number);
  void light_from_sky();
  void cast(std::size_t sample, const Vec3& towards, float distance, const Color& radiance) {
    shadow_rays_.push(samples_[sample], surfaces_[sample].origin, towards, distance, radiance,
                      ShadowRays::Condition::visible, *sums_[sample]);
  }

  const PreparedScene& prepared_;
  const bool with_figure_;
  Pixel pixel_;
  std::vector<Sample> samples_;
  std::array<Surface, lanes> surfaces_;  // that the samples show
  std::array<Color*, lanes> sums_;       // of the light that they reflect; null: they show none
  LaneVectors origins_;                  // of the shadow rays
  LaneVectors normals_;
  ShadowRays shadow_rays_;
};

void ReferencePixel::add(int first, int last) {
  samples_.clear();
  for (int i = first; i < last; ++i) samples_.push_back(sample_at(prepared_, pixel_, i));
  const RayPacket rays = camera_rays(prepared_, std::span<const Sample>(samples_));
  const auto first_hit = first_hits(prepared_, rays, with_figure_);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    hit(rays, i, first_hit[i]);
    origins_.set(static_cast<int>(i), surfaces_[i].origin);
    normals_.set(static_cast<int>(i), surfaces_[i].normal);
  }
  for (int k = 0; const AreaLight& light : prepared_.scene.lights) light_from(light, k++);
  light_from_sky();
}

// Finds the surface that a sample shows, and adds the radiance that no shadow ray decides about:
// emission and backdrop.
void ReferencePixel::hit(const RayPacket& rays, std::size_t sample, const FirstHit& first) {
  const Scene& scene = prepared_.scene;
  const int ray = static_cast<int>(sample);
  Surface& surface = surfaces_[sample];
  if (first.exists()) {
    surface = surface_at(prepared_, rays, ray, first);
    sums_[sample] = first.of_figure ? &figure : &background;
    *sums_[sample] += surface.material->emission;
    covered += first.of_figure ? 1 : 0;
    return;
  }
  const std::optional<Vec3> point = floor_point(rays, ray);
  float share = 0.0f;  // of the floor, which fades into the backdrop
  surface = floor_surface(Vec3::Zero(), Color::Zero());
  if (point) {
    const Vec3 eye = prepared_.camera.parallel ? prepared_.camera.position : rays.origin(ray);
    share = visibility(scene.ground, std::hypot(point->x() - eye.x(), point->z() - eye.z()));
    surface = floor_surface(*point, share * albedo_at(scene.ground, *point));
  }
  sums_[sample] = share > 0.0f ? &background : nullptr;
  background += (1.0f - share) * backdrop_radiance(scene.sky, rays.direction(ray));
}

void ReferencePixel::light_from(const AreaLight& light, int number) {
  const std::span<const Sample> samples(samples_);
  const LaneLights chosen =
      sample(light, origins_, points_for(samples, Dimension::FirstLight, number));
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const auto lane = static_cast<int>(i);
    const Vec3 towards = chosen.towards.at(lane);
    const float cosine = normals_.at(lane).dot(towards);
    if (sums_[i] != nullptr && cosine > 0.0f)
      cast(i, towards, chosen.distance[lane],
           (cosine * chosen.share[lane]) * light.radiance * reflectance(surfaces_[i], towards));
  }
  shadow_rays_.finish();
}

// Light from below comes through the floor (Sky), so a ray is occluded by nothing beyond it.
void ReferencePixel::light_from_sky() {
  const LaneVectors directions = cosine_directions(
      normals_, points_for(std::span<const Sample>(samples_), Dimension::FigureSky));
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (sums_[i] == nullptr) continue;
    const Vec3 towards = directions.at(static_cast<int>(i));
    cast(i, towards, distance_to_end(prepared_.scene, surfaces_[i].origin, towards),
         surfaces_[i].albedo * sky_radiance(prepared_.scene.sky, towards));
  }
  shadow_rays_.finish();
}

void draw_pixel(const PreparedScene& prepared, int x, int y, const Canvas& canvas) {
  const int samples = prepared.quality.samples_per_pixel;
  const float share = 1.0f / static_cast<float>(samples);
  const auto add_all = [&](bool with_figure) {
    ReferencePixel pixel(prepared, x, y, with_figure);
    for (int first = 0; first < samples; first += static_cast<int>(lanes))
      pixel.add(first, std::min(first + static_cast<int>(lanes), samples));
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

void draw_reference(const PreparedScene& prepared, const Window& part, const Canvas& canvas) {
  for (int y = part.y; y < part.y_end(); ++y)
    for (int x = part.x; x < part.x_end(); ++x) draw_pixel(prepared, x, y, canvas);
}

}  // namespace mien::render
