#include "render/tracer/tile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include "render/image/luminance.h"
#include "render/light/floor.h"
#include "render/math/constants.h"
#include "render/tracer/lighting.h"
#include "render/tracer/pixel.h"
#include "render/tracer/pixel_plan.h"
#include "render/tracer/primary_rays.h"
#include "render/tracer/reference.h"

namespace mien::render {
namespace {

constexpr int piece_width = 16 * tile_size;

class TilePainter {
 public:
  explicit TilePainter(const PreparedScene& prepared)
      : prepared_(prepared),
        in_pairs_(prepared.quality.shades_pixel_pairs && prepared.closing_solids == nullptr &&
                  prepared.quality.samples_per_pixel <= prepared.quality.samples_shaded_together &&
                  2 * prepared.quality.samples_per_pixel <= static_cast<int>(lanes)),
        planner_(prepared),
        shadow_rays_(prepared),
        line_shadows_(prepared, planner_.lines()) {}
  void draw(const Tile& part, const Canvas& canvas);

 private:
  void draw_band(const Tile& band, const Canvas& canvas);
  void draw_tile(const Tile& tile, bool open, const Canvas& canvas);
  int samples_of(const Pixel& pixel) const;
  void init(Sample& sample, Pixel& pixel, int index) const;
  void shade_floor(Samples& samples);
  void trace(Samples& samples);
  void shade_figure();
  bool stay_together(const Sample& a, const Sample& b) const;
  void add_hit(const Sample& sample, int lane, const Hits& figure, const Hits& static_hits);
  bool is_lit_with_last(const Sample& sample, int shape, int lane, const Hits& figure);
  Surface surface(int lane, const Hits& hits, bool of_figure, float time) const;
  void add_samples(Pixel& pixel, int first, int last);
  void push_floor(const Sample& sample, const CameraRay& ray);
  void shadow_floor_points();
  int skip_uniform(const Tile& tile, int x, int y);
  void shade(const Tile& tile, int first, int end, int y, std::uint32_t lights);
  void shade_rows(const Tile& tile, const Canvas& canvas);
  void finish(const Tile& tile);
  void subtract_block(FloorPixel& pixel) const;
  float shadow_alpha(const Color& left, int x, int y) const;
  void write_background(const Color& background, int x, int y, const Canvas& canvas) const;
  void resolve(const Pixel& pixel, const Canvas& canvas) const;
  void resolve(const FloorPixel& pixel, const Canvas& canvas) const;
  void write_pixel(const FloorPixel& pixel, const Color& figure, const Color& background,
                   const Color& occluded, float covered, const Canvas& canvas) const;

  const PreparedScene& prepared_;
  const bool in_pairs_;  // neighbours are shaded together
  PixelPlanner planner_;
  std::vector<std::uint8_t> open_;  // one a tile of the band
  std::vector<Pixel> pixels_;       // those that are traced; must not move
  std::vector<FloorPixel> floors_;  // those that need line shadows only; must not move
  bool in_blocks_ = false;          // pixels of the tile share lines
  FloorBlocks blocks_;              // if in_blocks_: their results
  std::array<std::uint32_t, tile_size> shaded_rows_;  // and bit i: pixel i of a row is floor that
                                                      // is shown, and lacks no more than that
  Samples floor_;                                     // samples that show no solid, not yet traced
  Samples traced_;                                    // samples that may show one, not yet traced
  RayPacket primaries_;
  SurfaceSamples figure_surfaces_;
  int last_shape_ = -1;  // of them
  SurfaceSamples set_surfaces_;
  FloorSamples floor_points_;
  ShadowRayQueue shadow_rays_;
  LineShadowQueue line_shadows_;
};

void TilePainter::draw(const Tile& part, const Canvas& canvas) {
  for (int y = part.y_begin; y < part.y_end; y += tile_size)
    draw_band({part.x_begin, part.x_end, y, std::min(y + tile_size, part.y_end)}, canvas);
}

// The background is written first, row by row, for cache locality. Tiles stay open if that left
// pixels out.
void TilePainter::draw_band(const Tile& band, const Canvas& canvas) {
  // If every sample is rendered by itself, so is the background.
  const bool shown = prepared_.quality.background == Background::shown &&
                     !prepared_.is_per_sample() && !prepared_.quality.exhaustive;
  const int tiles = (band.x_end - band.x_begin + tile_size - 1) / tile_size;
  open_.assign(static_cast<std::size_t>(tiles), shown ? 0 : 1);
  if (shown) planner_.write_background(band, canvas, open_);
  for (int k = 0; k < tiles; ++k) {
    const int x = band.x_begin + k * tile_size;
    const Tile tile{x, std::min(x + tile_size, band.x_end), band.y_begin, band.y_end};
    const bool open = open_[static_cast<std::size_t>(k)] != 0;
    planner_.begin_tile(tile);
    if (open || !planner_.shows_background_only()) draw_tile(tile, open, canvas);
  }
}

void TilePainter::draw_tile(const Tile& tile, bool open, const Canvas& canvas) {
  const bool alone = planner_.shows_background_only();
  const SharedLine shared = shared_line(planner_.lines(), prepared_.quality.samples_per_pixel);
  in_blocks_ = shared.pixels > 1;
  if (in_blocks_) blocks_.clear(block_of(shared));
  shaded_rows_.fill(0);
  shadow_rays_.shared_sky().begin_tile(tile);
  pixels_.clear();
  pixels_.reserve(tile_size * tile_size);
  floors_.clear();
  floors_.reserve(tile_size * tile_size);
  for (int y = tile.y_begin; y < tile.y_end; ++y) {
    for (int x = tile.x_begin; x < tile.x_end; ++x) {
      if (!open) {
        x = skip_uniform(tile, x, y);
        if (x == tile.x_end) break;
      }
      const PixelPlan plan = alone ? PixelPlan{} : planner_.plan(x, y);
      if (plan.kind == PixelKind::background && !open) continue;
      const bool by_lines = (plan.shadow_lights & ~planner_.lines().lights) == 0;
      if (plan.kind == PixelKind::shadowed_floor && by_lines && in_blocks_ && !open) {
        shade(tile, x, x + 1, y, plan.shadow_lights);
        continue;
      }
      const BackgroundLight background =
          open ? planner_.background_at(x, y)
               : BackgroundLight{Eigen::Map<const Color>(canvas.color(x, y)), true};
      if (plan.kind == PixelKind::background && background.complete) {
        write_background(background.radiance, x, y, canvas);
        continue;
      }
      if (plan.kind == PixelKind::shadowed_floor && background.complete && by_lines) {
        FloorPixel& pixel = floors_.emplace_back();
        planner_.init(pixel, x, y, plan, background.radiance);
        line_shadows_.enqueue_all(pixel);
        continue;
      }
      Pixel& pixel = pixels_.emplace_back();
      planner_.init(pixel, x, y, plan, background);
      const int needed = samples_of(pixel);
      if (needed == 0) {
        write_background(background.radiance, x, y, canvas);
        pixels_.pop_back();
        continue;
      }
      for (int first = 0; first < needed; first += static_cast<int>(lanes))
        add_samples(pixel, first, std::min(first + static_cast<int>(lanes), needed));
    }
  }
  finish(tile);
  for (const Pixel& pixel : pixels_) resolve(pixel, canvas);
  for (const FloorPixel& pixel : floors_) resolve(pixel, canvas);
  if (in_blocks_) shade_rows(tile, canvas);
}

// Skips runs of pixels that need no samples of their own; returns the next pixel that does.
int TilePainter::skip_uniform(const Tile& tile, int x, int y) {
  while (x < tile.x_end) {
    const auto run = planner_.uniform_run_from(x, y);
    if (!run) return x;
    if (run->lights != 0) {
      if (!in_blocks_ || (run->lights & ~planner_.lines().lights) != 0) return x;
      shade(tile, x, run->end, y, run->lights);
    }
    x = run->end;
  }
  return x;
}

// Requests block lines for floor pixels that are already written.
void TilePainter::shade(const Tile& tile, int first, int end, int y, std::uint32_t lights) {
  shaded_rows_[static_cast<std::size_t>(y - tile.y_begin)] |= ((1u << (end - first)) - 1u)
                                                              << (first - tile.x_begin);
  const int width = blocks_.size().width;
  for (int x = first; x < end; x = x / width * width + width) blocks_.add(x, y, lights);
}

// Adds the blocks' shadows to pixels that were already written; gives the same bits as `resolve`.
void TilePainter::shade_rows(const Tile& tile, const Canvas& canvas) {
  const auto samples = static_cast<float>(prepared_.quality.samples_per_pixel);
  const float share = 1.0f / samples, all = share * samples;
  const int width = blocks_.size().width;
  for (int y = tile.y_begin; y < tile.y_end; ++y) {
    std::uint32_t row = shaded_rows_[static_cast<std::size_t>(y - tile.y_begin)];
    while (row != 0) {
      const int first = tile.x_begin + std::countr_zero(row);
      const Color& hidden = blocks_.occluded(first, y);
      for (int x = first; x < first / width * width + width; ++x) {
        const std::uint32_t bit = 1u << (x - tile.x_begin);
        if ((row & bit) == 0) continue;
        row &= ~bit;
        const Color occluded =
            Color::Zero() - (samples * hidden) * prepared_.background.floor_albedo(x, y);
        Eigen::Map<Color> light(canvas.color(x, y));
        light = all * light + (Color::Zero() + share * occluded);
      }
    }
  }
}

int TilePainter::samples_of(const Pixel& pixel) const {
  return pixel.kind == PixelKind::background ? pixel.floor_sky_rays
                                             : prepared_.quality.samples_per_pixel;
}

void TilePainter::init(Sample& sample, Pixel& pixel, int index) const {
  sample.pixel = &pixel;
  sample.index = index;
  if (prepared_.closing_solids != nullptr || prepared_.closing_camera)
    sample.time = prepared_.quality.shutter * pixel.sampler.point(Dimension::Time, index).u;
  if (!prepared_.figure.shapes().all_present)
    sample.present = present_figures(pixel.sampler, prepared_.opacities, index);
}

void TilePainter::shade_floor(Samples& samples) {
  LaneVectors origins, directions;
  primary_rays(prepared_, samples, origins, directions);
  for (int i = 0; i < samples.count; ++i) push_floor(samples[i], {origins.at(i), directions.at(i)});
  samples.count = 0;
  shadow_floor_points();
}

// Samples of a pixel that are traced and shaded together stay together, whatever else is rendered:
// so its light is always summed in the same order.
void TilePainter::add_samples(Pixel& pixel, int first, int last) {
  const bool open = pixel.kind == PixelKind::background || pixel.kind == PixelKind::shadowed_floor;
  Samples& waiting = open ? floor_ : traced_;
  // Samples of a pair stay together too.
  const int needed = in_pairs_ && !open && pixel.x % 2 == 0 ? 2 * (last - first) : last - first;
  if (waiting.count + needed > static_cast<int>(lanes)) open ? shade_floor(floor_) : trace(traced_);
  for (int i = first; i < last; ++i) init(waiting.next(), pixel, i);
}

void TilePainter::push_floor(const Sample& sample, const CameraRay& ray) {
  if (!sample.pixel->shows_floor) return;
  const std::optional<float> distance = distance_to_floor(ray.origin, ray.direction);
  if (distance) floor_points_.push(sample, floor_point(ray, *distance));
}

void TilePainter::shadow_floor_points() {
  shadow_floor(prepared_, floor_points_, shadow_rays_, line_shadows_);
  floor_points_.samples.count = 0;
}

void TilePainter::trace(Samples& samples) {
  if (samples.count == 0) return;
  LaneVectors origins, directions;
  primary_rays(prepared_, samples, origins, directions);
  primaries_.count = 0;
  for (int i = 0; i < samples.count; ++i) {
    const Vec3 origin = origins.at(i), direction = directions.at(i);
    const std::optional<float> floor =
        prepared_.scene.has_ground ? distance_to_floor(origin, direction) : std::nullopt;
    primaries_.push(origin, direction, floor.value_or(infinity), samples[i].time,
                    samples[i].present);
  }
  const Hits figure = prepared_.figure.intersect(primaries_);
  Hits static_hits;
  std::fill_n(static_hits.shape, packet_size, -1);
  if (prepared_.static_solids) static_hits = prepared_.static_solids->intersect(primaries_);
  for (int first = 0, last = 0; first < samples.count; first = last) {
    while (last < samples.count && stay_together(samples[first], samples[last])) ++last;
    if (figure_surfaces_.samples.count + last - first > static_cast<int>(lanes)) shade_figure();
    for (int i = first; i < last; ++i) add_hit(samples[i], i, figure, static_hits);
  }
  samples.count = 0;
  shade_surfaces(prepared_, set_surfaces_, false, shadow_rays_);
  set_surfaces_.samples.count = 0;
  shadow_floor_points();
}

void TilePainter::shade_figure() {
  shade_surfaces(prepared_, figure_surfaces_, true, shadow_rays_);
  figure_surfaces_.samples.count = 0;
}

// Whether two samples are of one pixel, or of a pair.
bool TilePainter::stay_together(const Sample& a, const Sample& b) const {
  const int x = in_pairs_ ? a.pixel->x ^ 1 : a.pixel->x;
  return a.pixel->y == b.pixel->y && (a.pixel->x == b.pixel->x || x == b.pixel->x);
}

void TilePainter::add_hit(const Sample& sample, int lane, const Hits& figure,
                          const Hits& static_hits) {
  Pixel& pixel = *sample.pixel;
  const bool is_static = static_hits.shape[lane] >= 0;
  if (figure.shape[lane] >= 0 &&
      (!is_static || figure.distance[lane] <= static_hits.distance[lane])) {
    ++pixel.covered;
    if (is_lit_with_last(sample, figure.shape[lane], lane, figure)) return;
    last_shape_ = figure.shape[lane];
    return figure_surfaces_.push(sample, surface(lane, figure, true, sample.time));
  }
  const CameraRay ray{primaries_.origin(lane), primaries_.direction(lane)};
  if (pixel.kind == PixelKind::per_sample) {
    if (is_static) return set_surfaces_.push(sample, surface(lane, static_hits, false, 0.0f));
    return add_unshadowed_background(prepared_, sample, camera_of(prepared_, sample), ray,
                                     shadow_rays_);
  }
  ++pixel.background_samples;
  if (is_static)
    return shadow_static_solid(prepared_, sample, surface(lane, static_hits, false, 0.0f),
                               shadow_rays_);
  push_floor(sample, ray);
}

// Whether this sample shares the shading of the last one. Of a pair any sample may be the shaded
// one, with equal probability: otherwise light would shift to the left.
bool TilePainter::is_lit_with_last(const Sample& sample, int shape, int lane, const Hits& figure) {
  const int together = prepared_.quality.samples_shaded_together;
  if (together == 1 || figure_surfaces_.samples.count == 0 || shape != last_shape_ ||
      prepared_.closing_solids != nullptr)
    return false;
  const auto number = static_cast<std::size_t>(figure_surfaces_.samples.count - 1);
  Sample& last = figure_surfaces_.samples.lane[number];
  if (last.pixel == sample.pixel) {
    if (last.index / together != sample.index / together) return false;
    last.weight += 1.0f;
    return true;
  }
  const Pixel &pixel = *sample.pixel, &before = *last.pixel;
  if (!in_pairs_ || pixel.y != before.y || pixel.x != before.x + 1 || pixel.x % 2 == 0)
    return false;
  last.partner = sample.pixel;
  last.partner_weight += 1.0f;
  if (pixel.sampler.fast_random(sample.index) * (last.weight + last.partner_weight) < 1.0f)
    figure_surfaces_.surfaces[number] = surface(lane, figure, true, sample.time);
  return true;
}

Surface TilePainter::surface(int lane, const Hits& hits, bool of_figure, float time) const {
  const Vec3 direction = primaries_.direction(lane);
  const Vec3 point = primaries_.origin(lane) + hits.distance[lane] * direction;
  if (of_figure)
    return surface_at(prepared_.scene, prepared_.solids, prepared_.closing_solids,
                      prepared_.figure.shapes(), hits.shape[lane], point, direction, time);
  return surface_at(prepared_.scene, prepared_.scene.static_solids, nullptr,
                    prepared_.static_solids->shapes(), hits.shape[lane], point, direction, time);
}

// Processes everything that is still queued. Which blocks need a line is known only after all
// tracing.
void TilePainter::finish(const Tile& tile) {
  shade_floor(floor_);
  trace(traced_);
  shade_figure();
  shadow_rays_.trace();
  shadow_rays_.shared_sky().subtract();
  if (in_blocks_) {
    for (const Pixel& pixel : pixels_)
      if (pixel.block_samples > 0) blocks_.add(pixel.x, pixel.y, pixel.shadow_lights);
    for (const FloorPixel& pixel : floors_) blocks_.add(pixel.x, pixel.y, pixel.shadow_lights);
    line_shadows_.enqueue_all(tile, blocks_);
  }
  line_shadows_.resolve();
  if (!in_blocks_) return;
  for (Pixel& pixel : pixels_)
    if (pixel.block_samples > 0) subtract_block(pixel);
  for (FloorPixel& pixel : floors_) subtract_block(pixel);
}

void TilePainter::subtract_block(FloorPixel& pixel) const {
  subtract_light(pixel, pixel.block_samples, blocks_.occluded(pixel.x, pixel.y));
}

// Writes a pixel without figure or shadow.
void TilePainter::write_background(const Color& background, int x, int y,
                                   const Canvas& canvas) const {
  if (prepared_.quality.background == Background::shown)
    std::copy_n(background.data(), 3, canvas.color(x, y));
  else if (prepared_.quality.background == Background::shadow)
    canvas.alpha(x, y) = shadow_alpha(background, x, y);
}

// Alpha of a shadow: the share of the background's luminance that is missing.
float TilePainter::shadow_alpha(const Color& left, int x, int y) const {
  const float whole =
      relative_luminance(Eigen::Map<const Color>(prepared_.background.radiance.at(x, y)));
  return whole > 0.0f ? std::clamp(1.0f - relative_luminance(left) / whole, 0.0f, 1.0f) : 0.0f;
}

void TilePainter::resolve(const Pixel& pixel, const Canvas& canvas) const {
  const float share = 1.0f / static_cast<float>(prepared_.quality.samples_per_pixel);
  const Color background = (share * static_cast<float>(pixel.background_samples)) * pixel.radiance +
                           share * (pixel.known_background + pixel.background);
  write_pixel(pixel, share * (pixel.known_figure + pixel.figure), background,
              share * (pixel.known_occluded + pixel.occluded),
              share * static_cast<float>(pixel.covered), canvas);
}

// Gives the same bits as for a pixel whose samples all show the background.
void TilePainter::resolve(const FloorPixel& pixel, const Canvas& canvas) const {
  const auto samples = static_cast<float>(prepared_.quality.samples_per_pixel);
  const float share = 1.0f / samples;
  write_pixel(pixel, Color::Zero(), (share * samples) * pixel.radiance,
              share * pixel.known_occluded, 0.0f, canvas);
}

void TilePainter::write_pixel(const FloorPixel& pixel, const Color& figure, const Color& background,
                              const Color& occluded, float covered, const Canvas& canvas) const {
  if (prepared_.quality.background == Background::shown) {
    const Color color = background + (figure + occluded);
    std::copy_n(color.data(), 3, canvas.color(pixel.x, pixel.y));
    return;
  }
  std::copy_n(figure.data(), 3, canvas.color(pixel.x, pixel.y));
  canvas.alpha(pixel.x, pixel.y) =
      prepared_.quality.background == Background::transparent
          ? covered
          : std::max(covered, shadow_alpha(background + occluded, pixel.x, pixel.y));
}

}  // namespace

void draw(const PreparedScene& prepared, const Tile& part, const Canvas& canvas) {
  if (prepared.quality.reference) return draw_reference(prepared, part, canvas);
  TilePainter(prepared).draw(part, canvas);
}

void draw_pieces(
    const PreparedScene& prepared, const Tile& part,
    const std::function<void(const Tile& piece, const Framebuffer& framebuffer)>& drawn) {
  TilePainter painter(prepared);
  RenderTarget target;
  for (int y = part.y_begin; y < part.y_end; y += tile_size) {
    for (int x = part.x_begin; x < part.x_end; x += piece_width) {
      const Tile piece{x, std::min(x + piece_width, part.x_end), y,
                       std::min(y + tile_size, part.y_end)};
      Framebuffer& framebuffer = target.color;
      framebuffer.width = piece.x_end - piece.x_begin;
      framebuffer.height = piece.y_end - piece.y_begin;
      framebuffer.channels.resize(3 * static_cast<std::size_t>(framebuffer.width) *
                                  static_cast<std::size_t>(framebuffer.height));
      const Canvas canvas{target, piece.x_begin, piece.y_begin};
      prepared.quality.reference ? draw_reference(prepared, piece, canvas)
                                 : painter.draw(piece, canvas);
      drawn(piece, framebuffer);
    }
  }
}

}  // namespace mien::render
