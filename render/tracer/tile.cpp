#include "render/tracer/tile.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "render/image/luminance.h"
#include "render/light/unshadowed_background.h"
#include "render/tracer/camera_rays.h"
#include "render/tracer/lighting.h"
#include "render/tracer/pixel_plan.h"
#include "render/tracer/reference.h"
#include "render/tracer/samples.h"

namespace mien::render {
namespace {

constexpr int piece_width = 16 * tile_size;

/// Renders tiles. Each goes through these steps: its background is written, if it is shown and
/// known beforehand; camera rays of the pixels that may show a solid are traced; the points that
/// they show are lit by shadow rays; the sums of all samples are written.
class TileRenderer {
 public:
  explicit TileRenderer(const PreparedScene& prepared)
      : prepared_(prepared),
        samples_(prepared.quality.samples_per_pixel),
        // If every sample renders its own background, none is written before.
        writes_background_(prepared.quality.background == Background::shown &&
                           !prepared.is_per_sample() && !prepared.quality.exhaustive),
        shares_floor_(prepared.quality.floor_sharing_pixels > 0),
        planner_(prepared),
        unshadowed_(prepared.scene, prepared.camera),
        lighting_(prepared) {}

  void draw(const Window& part, const Canvas& canvas);

 private:
  /// The last samples that show the figure, of one pixel and surface.
  struct Pending {
    Sample sample{.count = 0};                      // the first of them
    FirstHit hit;                                   // its hit
    std::array<Vec3, most_shaded_together> points;  // that they show
    Vec3 directions = Vec3::Zero();                 // sum of the directions of their rays
  };

  void draw_band(const Window& band, const Canvas& canvas);
  void draw_tile(const Window& tile, bool is_known, const Canvas& canvas);
  void plan_pixels(const Window& rows, bool is_known, const Canvas& canvas);
  void add_pixel(int x, int y, const PixelPlan& plan, const std::optional<Color>& background);
  void trace();
  template <class Work>
  void for_eights(std::span<const Sample> samples, const Work& work);
  void trace_batch(std::span<const Sample> samples);
  void show_floor(std::span<const Sample> samples);
  void add_figure(const Sample& sample, const RayPacket& rays, int ray, const FirstHit& hit);
  void finish_pending();
  bool joins_pending(const Sample& sample, const FirstHit& hit) const;
  void add_background(const Sample& sample, const RayPacket& rays, int ray, const FirstHit& hit);
  void add_floor(const Sample& sample, const Vec3& point);
  void add_own_background(std::span<const Sample> samples, const RayPacket& rays);
  void light();
  void resolve(const Canvas& canvas);
  void write(int x, int y, const Color& figure, const Color& background, float covered,
             const Canvas& canvas) const;
  Color shared_floor_shadow(int x, int y) const {
    return prepared_.background.floor_albedo(x, y) * prepared_.shared_occlusion.on_floor(x, y);
  }

  const PreparedScene& prepared_;
  const int samples_;  // per pixel
  const bool writes_background_;
  const bool shares_floor_;  // shadows on the floor are shared
  PixelPlanner planner_;
  const UnshadowedBackground unshadowed_;
  Lighting lighting_;
  std::vector<std::uint8_t> is_known_;  // per tile of a band: its background is written, complete
  std::vector<Pixel> pixels_;           // of the tile; must not move
  std::vector<Sample> traced_samples_;  // that may show a solid
  std::vector<Sample> floor_samples_;   // that show the floor only
  std::vector<Sample> own_samples_;     // of a batch, that render their own background
  std::vector<ShadingPoint> figure_points_;
  Pending pending_;
  std::vector<ShadingPoint> set_points_;     // of static solids, not rendered before
  std::vector<ShadingPoint> shadow_points_;  // of the static background
  std::vector<ShadingPoint> floor_points_;   // of the unshadowed floor
};

void TileRenderer::draw(const Window& part, const Canvas& canvas) {
  for (int y = part.y; y < part.y_end(); y += tile_size)
    draw_band(intersection(part, {part.x, y, part.width, tile_size}), canvas);
}

void TileRenderer::draw_band(const Window& band, const Canvas& canvas) {
  const int tiles = (band.width + tile_size - 1) / tile_size;
  is_known_.assign(static_cast<std::size_t>(tiles), writes_background_ ? 1 : 0);
  if (writes_background_) planner_.write_background(band, canvas, is_known_);
  for (int k = 0; k < tiles; ++k) {
    const int x = band.x + k * tile_size;
    draw_tile(intersection(band, {x, band.y, tile_size, band.height}),
              is_known_[static_cast<std::size_t>(k)] != 0, canvas);
  }
}

void TileRenderer::draw_tile(const Window& tile, bool is_known, const Canvas& canvas) {
  planner_.begin_tile(tile);
  if (is_known && planner_.shows_background_only()) return;
  pixels_.clear();
  pixels_.reserve(tile_size * tile_size);
  // Some rows at a time, which is enough for full packets.
  const int rows = std::clamp(16 / samples_, 1, tile_size);
  for (int y = tile.y; y < tile.y_end(); y += rows) {
    plan_pixels(intersection(tile, {tile.x, y, tile.width, rows}), is_known, canvas);
    trace();
    light();
  }
  lighting_.finish();
  resolve(canvas);
}

void TileRenderer::plan_pixels(const Window& rows, bool is_known, const Canvas& canvas) {
  for (int y = rows.y; y < rows.y_end(); ++y) {
    const auto& plans = planner_.plan_row(y);
    for (int x = rows.x; x < rows.x_end(); ++x) {
      const PixelPlan& plan = plans[static_cast<std::size_t>(x - rows.x)];
      if (is_known && plan.shows_background_only()) continue;
      const std::optional<Color> background =
          is_known ? Eigen::Map<const Color>(canvas.color(x, y)) : planner_.background_at(x, y);
      if (plan.kind == PixelKind::background && background &&
          (plan.shadow_lights == 0 || shares_floor_)) {
        const Color shadow =
            plan.shadow_lights != 0 ? shared_floor_shadow(x, y) : Color(Color::Zero());
        write(x, y, Color::Zero(), *background - shadow, 0.0f, canvas);
      } else {
        add_pixel(x, y, plan, background);
      }
    }
  }
}

// `background` is nothing where rays find how much of the sky the figure occludes from the floor.
void TileRenderer::add_pixel(int x, int y, const PixelPlan& plan,
                             const std::optional<Color>& background) {
  Pixel& pixel = pixels_.emplace_back();
  pixel.x = x;
  pixel.y = y;
  pixel.kind = plan.kind;
  pixel.sampler = prepared_.sampler.for_pixel(x, y);
  pixel.shadow_lights = shares_floor_ ? 0 : plan.shadow_lights;
  pixel.background =
      background.value_or(Eigen::Map<const Color>(prepared_.background.radiance.at(x, y)));
  pixel.floor_albedo = prepared_.background.floor_albedo(x, y);
  if (shares_floor_ && plan.shadow_lights != 0) pixel.floor_shadow = shared_floor_shadow(x, y);
  if (!background && plan.kind != PixelKind::per_sample)
    pixel.floor_sky = planner_.floor_sky_rays(x, y);
  if (plan.kind != PixelKind::background) {
    for (int i = 0; i < samples_; ++i) traced_samples_.push_back(sample_at(prepared_, pixel, i));
    return;
  }
  pixel.background_samples = samples_;
  pixel.floor_samples = samples_;
  const int needed = pixel.shadow_lights != 0 ? samples_ : pixel.floor_sky.rays;
  for (int i = 0; i < needed; ++i) floor_samples_.push_back(sample_at(prepared_, pixel, i));
}

void TileRenderer::trace() {
  for_eights(traced_samples_, [&](std::span<const Sample> batch) { trace_batch(batch); });
  for_eights(floor_samples_, [&](std::span<const Sample> batch) { show_floor(batch); });
  traced_samples_.clear();
  floor_samples_.clear();
}

// Calls `work` with up to eight samples at a time, and lights the points that were found before
// they outgrow the caches: between pixels.
template <class Work>
void TileRenderer::for_eights(std::span<const Sample> samples, const Work& work) {
  constexpr std::size_t many = 256;
  std::size_t count = 0;  // since the last points were lit
  for (std::size_t i = 0; i < samples.size(); i += lanes) {
    const std::size_t here = std::min<std::size_t>(lanes, samples.size() - i);
    work(samples.subspan(i, here));
    count += here;
    const std::size_t next = i + here;
    if (count < many || next == samples.size() || samples[next - 1].pixel == samples[next].pixel)
      continue;
    light();
    count = 0;
  }
}

void TileRenderer::show_floor(std::span<const Sample> samples) {
  const RayPacket rays = camera_rays(prepared_, samples);
  for (int ray = 0; ray < rays.count; ++ray)
    if (const std::optional<Vec3> point = floor_point(rays, ray))
      add_floor(samples[static_cast<std::size_t>(ray)], *point);
}

void TileRenderer::trace_batch(std::span<const Sample> samples) {
  const RayPacket rays = camera_rays(prepared_, samples);
  const auto hits = first_hits(prepared_, rays);
  RayPacket own_rays;
  own_samples_.clear();
  for (int ray = 0; ray < rays.count; ++ray) {
    const auto i = static_cast<std::size_t>(ray);
    const Sample& sample = samples[i];
    if (hits[i].exists() && hits[i].of_figure) {
      add_figure(sample, rays, ray, hits[i]);
    } else if (sample.pixel->kind == PixelKind::traced) {
      add_background(sample, rays, ray, hits[i]);
    } else if (hits[i].exists()) {
      set_points_.push_back({sample, surface_at(prepared_, rays, ray, hits[i])});
    } else {
      own_samples_.push_back(sample);
      own_rays.push(rays.origin(ray), rays.direction(ray), rays.reach[ray]);
    }
  }
  if (own_rays.count > 0) add_own_background(own_samples_, own_rays);
}

void TileRenderer::add_figure(const Sample& sample, const RayPacket& rays, int ray,
                              const FirstHit& hit) {
  ++sample.pixel->covered;
  const Vec3 direction = rays.direction(ray);
  if (joins_pending(sample, hit)) {
    ++pending_.sample.count;
    pending_.directions += direction;
  } else {
    finish_pending();
    pending_.sample = sample;
    pending_.hit = hit;
    pending_.directions = direction;
  }
  pending_.points[static_cast<std::size_t>(pending_.sample.count) - 1] =
      rays.origin(ray) + hit.distance * direction;
}

// Evaluates the surface that the pending samples show at the mean of their points: on surfaces that
// hardly bend within a pixel, that is the mean of their surfaces. Their shadow rays leave from the
// points themselves, because the mean may lie below the surface.
void TileRenderer::finish_pending() {
  const Sample& sample = pending_.sample;
  if (sample.count == 0) return;
  const auto count = static_cast<std::size_t>(sample.count);
  Vec3 mean = pending_.points[0];
  for (std::size_t k = 1; k < count; ++k) mean += pending_.points[k];
  mean /= static_cast<float>(count);
  ShadingPoint point{sample, surface_at(prepared_, pending_.hit, mean,
                                        pending_.directions.normalized(), sample.time)};
  const Vec3 off_surface = point.surface.origin - mean;
  point.surface.origin = pending_.points[0] + off_surface;
  for (std::size_t k = 1; k < count; ++k)
    point.more_origins[k - 1] = pending_.points[k] + off_surface;
  figure_points_.push_back(point);
  pending_.sample.count = 0;
}

bool TileRenderer::joins_pending(const Sample& sample, const FirstHit& hit) const {
  const int together = prepared_.quality.samples_shaded_together;
  const Sample& first = pending_.sample;
  const bool moves = prepared_.is_per_sample() || prepared_.closing_solids != nullptr;
  return together > 1 && !moves && first.count > 0 && first.pixel == sample.pixel &&
         first.index / together == sample.index / together && first.present == sample.present &&
         are_of_one_surface(prepared_, pending_.hit, hit);
}

void TileRenderer::add_background(const Sample& sample, const RayPacket& rays, int ray,
                                  const FirstHit& hit) {
  ++sample.pixel->background_samples;
  if (hit.exists()) {
    ShadingPoint solid{sample, surface_at(prepared_, rays, ray, hit)};
    solid.sky = sky_rays_of(prepared_.bounds, solid.surface.origin, solid.surface.normal, samples_,
                            sample.pixel->sampler);
    shadow_points_.push_back(solid);
  } else if (const std::optional<Vec3> point = floor_point(rays, ray)) {
    ++sample.pixel->floor_samples;
    add_floor(sample, *point);
  }
}

// Adds a point of the floor of the static background.
void TileRenderer::add_floor(const Sample& sample, const Vec3& point) {
  const Pixel& pixel = *sample.pixel;
  if (pixel.shadow_lights == 0 && sample.index >= pixel.floor_sky.rays) return;
  ShadingPoint floor{sample, floor_surface(point, pixel.floor_albedo)};
  floor.lights = pixel.shadow_lights;
  floor.sky = pixel.floor_sky;
  shadow_points_.push_back(floor);
}

// Light that is occluded is subtracted later from what rays show where there is no solid. Where all
// rays of a pixel start at one point, the background is what its centre shows. Footprints of grid
// lines, and the fading of an orthographic view, are those of the camera when the shutter opens.
void TileRenderer::add_own_background(std::span<const Sample> samples, const RayPacket& rays) {
  LaneRays shown;
  for (int i = 0; i < rays.count; ++i) {
    const Pixel& pixel = *samples[static_cast<std::size_t>(i)].pixel;
    const CameraRay ray = prepared_.is_per_sample()
                              ? CameraRay{rays.origin(i), rays.direction(i)}
                              : prepared_.camera.ray(static_cast<float>(pixel.x) + 0.5f,
                                                     static_cast<float>(pixel.y) + 0.5f);
    shown.origin.set(i, ray.origin);
    shown.direction.set(i, ray.direction);
  }
  const LaneBackground background = unshadowed_.along(shown);
  for (int i = 0; i < rays.count; ++i) {
    const Sample& sample = samples[static_cast<std::size_t>(i)];
    sample.pixel->known_set += background.radiance.at(i);
    const std::optional<Vec3> point = floor_point(rays, i);
    if (!point || background.share[i] <= 0.0f) continue;
    ShadingPoint floor{sample, floor_surface(*point, background.visible_albedo.at(i))};
    floor.sky = {samples_, 1.0f};
    floor_points_.push_back(floor);
  }
}

void TileRenderer::light() {
  finish_pending();
  lighting_.shade(figure_points_, true);
  lighting_.shade(set_points_, false);
  lighting_.subtract_shadow(shadow_points_);
  lighting_.subtract_all_shadows(floor_points_);
  for (auto* points : {&figure_points_, &set_points_, &shadow_points_, &floor_points_})
    points->clear();
}

void TileRenderer::resolve(const Canvas& canvas) {
  const float share = 1.0f / static_cast<float>(samples_);
  for (const Pixel& pixel : pixels_) {
    const Color background =
        (share * static_cast<float>(pixel.background_samples)) * pixel.background +
        share * (pixel.known_set + pixel.set -
                 static_cast<float>(pixel.floor_samples) * pixel.floor_shadow);
    write(pixel.x, pixel.y, share * (pixel.known_figure + pixel.figure), background,
          share * static_cast<float>(pixel.covered), canvas);
  }
}

// Writes what a pixel shows: the radiance of the figure, that of the set with its shadow, and the
// share of the pixel that the figure covers.
void TileRenderer::write(int x, int y, const Color& figure, const Color& background, float covered,
                         const Canvas& canvas) const {
  const Background kind = prepared_.quality.background;
  const bool shown = kind == Background::shown;
  const Color color = shown ? Color(background + figure) : figure;
  std::copy_n(color.data(), 3, canvas.color(x, y));
  if (shown) return;
  const Eigen::Map<const Color> whole(prepared_.background.radiance.at(x, y));
  canvas.alpha(x, y) = kind == Background::transparent
                           ? covered
                           : std::max(covered, shadow_alpha(background, whole));
}

}  // namespace

float shadow_alpha(const Color& left, const Color& whole) {
  const float all = relative_luminance(whole);
  return all > 0.0f ? std::clamp(1.0f - relative_luminance(left) / all, 0.0f, 1.0f) : 0.0f;
}

void draw(const PreparedScene& prepared, const Window& part, const Canvas& canvas) {
  if (prepared.quality.reference) return draw_reference(prepared, part, canvas);
  TileRenderer(prepared).draw(part, canvas);
}

void draw_pieces(
    const PreparedScene& prepared, const Window& part,
    const std::function<void(const Window& piece, const Framebuffer& framebuffer)>& drawn) {
  TileRenderer renderer(prepared);
  RenderTarget target;
  for (int y = part.y; y < part.y_end(); y += tile_size) {
    for (int x = part.x; x < part.x_end(); x += piece_width) {
      const Window piece = intersection(part, {x, y, piece_width, tile_size});
      Framebuffer& framebuffer = target.color;
      framebuffer.width = piece.width;
      framebuffer.height = piece.height;
      framebuffer.channels.resize(3 * static_cast<std::size_t>(framebuffer.width) *
                                  static_cast<std::size_t>(framebuffer.height));
      const Canvas canvas{target, piece.x, piece.y};
      prepared.quality.reference ? draw_reference(prepared, piece, canvas)
                                 : renderer.draw(piece, canvas);
      drawn(piece, framebuffer);
    }
  }
}

}  // namespace mien::render
