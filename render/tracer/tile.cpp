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
#include "render/tracer/eye_samples.h"
#include "render/tracer/lighting.h"
#include "render/tracer/pixel.h"
#include "render/tracer/pixel_plan.h"

namespace mien::render {
namespace {

constexpr int piece_width = 16 * tile_size;

class TilePainter {
 public:
  explicit TilePainter(const Picture& picture)
      : picture_(picture),
        in_pairs_(picture.quality.lit_in_pairs && picture.closing_solids == nullptr &&
                  picture.quality.samples_per_pixel <= picture.quality.lit_as_one &&
                  2 * picture.quality.samples_per_pixel <= static_cast<int>(lanes)),
        planner_(picture),
        queries_(picture),
        lines_(picture, planner_.lines()) {}
  void draw(const Tile& part, const Canvas& canvas);

 private:
  void draw_band(const Tile& band, const Canvas& canvas);
  void draw_tile(const Tile& tile, bool open, const Canvas& canvas);
  int samples_of(const Pixel& pixel) const;
  void set_out(Sample& sample, Pixel& pixel, int index) const;
  void show_floor(Samples& samples);
  void trace(Samples& samples);
  void light_figure();
  bool stay_together(const Sample& a, const Sample& b) const;
  void take_primary(const Sample& sample, int lane, const Hits& figure, const Hits& standing);
  bool is_lit_with_last(const Sample& sample, int shape, int lane, const Hits& figure);
  Surface surface(int lane, const Hits& hits, bool of_figure, float time) const;
  void take_samples(Pixel& pixel, int first, int last);
  void push_floor(const Sample& sample, const EyeRay& ray);
  void light_floor();
  int pass_alike(const Tile& tile, int x, int y);
  void shade(const Tile& tile, int first, int end, int y, std::uint32_t lights);
  void shade_rows(const Tile& tile, const Canvas& canvas);
  void finish(const Tile& tile);
  void take_hidden_from(FloorPixel& pixel) const;
  float missing(const Color& left, int x, int y) const;
  void show_set(const Color& set, int x, int y, const Canvas& canvas) const;
  void develop(const Pixel& pixel, const Canvas& canvas) const;
  void develop(const FloorPixel& pixel, const Canvas& canvas) const;
  void expose(const FloorPixel& pixel, const Color& figure, const Color& set, const Color& taken,
              float covered, const Canvas& canvas) const;

  const Picture& picture_;
  const bool in_pairs_;  // neighbours are lit as one
  PixelPlanner planner_;
  std::vector<std::uint8_t> open_;  // one a tile of the band
  std::vector<Pixel> pixels_;       // those that are traced; they stay where they are
  std::vector<FloorPixel> floors_;  // those of which lines tell all; likewise
  bool in_blocks_ = false;          // pixels of the tile share lines
  FloorBlocks blocks_;              // then: what these find
  std::array<std::uint32_t, tile_size> shaded_rows_;  // and bit i: pixel i of a row is floor that
                                                      // is shown, and lacks no more than that
  Samples floor_;                                     // samples that show no solid, not yet aimed
  Samples traced_;                                    // samples that may, not yet aimed
  RayPacket primaries_;
  SurfaceSamples figure_surfaces_;
  int last_shape_ = -1;  // of them
  SurfaceSamples set_surfaces_;
  FloorSamples floor_points_;
  LightQueries queries_;
  LineQueries lines_;
};

void TilePainter::draw(const Tile& part, const Canvas& canvas) {
  for (int y = part.y_begin; y < part.y_end; y += tile_size)
    draw_band({part.x_begin, part.x_end, y, std::min(y + tile_size, part.y_end)}, canvas);
}

// The set is shown first, row by row, which memory likes. Tiles stay open where that left pixels
// out.
void TilePainter::draw_band(const Tile& band, const Canvas& canvas) {
  // Where every sample is drawn by itself, so is the set.
  const bool shown = picture_.quality.background == Background::shown && !picture_.piecemeal() &&
                     !picture_.quality.exhaustive;
  const int tiles = (band.x_end - band.x_begin + tile_size - 1) / tile_size;
  open_.assign(static_cast<std::size_t>(tiles), shown ? 0 : 1);
  if (shown) planner_.show_set(band, canvas, open_);
  for (int k = 0; k < tiles; ++k) {
    const int x = band.x_begin + k * tile_size;
    const Tile tile{x, std::min(x + tile_size, band.x_end), band.y_begin, band.y_end};
    const bool open = open_[static_cast<std::size_t>(k)] != 0;
    planner_.turn_to(tile);
    if (open || !planner_.is_alone()) draw_tile(tile, open, canvas);
  }
}

void TilePainter::draw_tile(const Tile& tile, bool open, const Canvas& canvas) {
  const bool alone = planner_.is_alone();
  const SharedLine shared = shared_line(planner_.lines(), picture_.quality.samples_per_pixel);
  in_blocks_ = shared.pixels > 1;
  if (in_blocks_) blocks_.clear(block_of(shared));
  shaded_rows_.fill(0);
  pixels_.clear();
  pixels_.reserve(tile_size * tile_size);
  floors_.clear();
  floors_.reserve(tile_size * tile_size);
  for (int y = tile.y_begin; y < tile.y_end; ++y) {
    for (int x = tile.x_begin; x < tile.x_end; ++x) {
      if (!open) {
        x = pass_alike(tile, x, y);
        if (x == tile.x_end) break;
      }
      const PixelPlan plan = alone ? PixelPlan{} : planner_.plan(x, y);
      if (plan.kind == PixelKind::untouched && !open) continue;
      const bool by_lines = (plan.shadow_lights & ~planner_.lines().lights) == 0;
      if (plan.kind == PixelKind::floor && by_lines && in_blocks_ && !open) {
        shade(tile, x, x + 1, y, plan.shadow_lights);
        continue;
      }
      const SetLight set =
          open ? planner_.set_at(x, y) : SetLight{Eigen::Map<const Color>(canvas.film(x, y)), true};
      if (plan.kind == PixelKind::untouched && set.complete) {
        show_set(set.radiance, x, y, canvas);
        continue;
      }
      if (plan.kind == PixelKind::floor && set.complete && by_lines) {
        FloorPixel& pixel = floors_.emplace_back();
        planner_.set_out(pixel, x, y, plan, set.radiance);
        lines_.ask_all(pixel);
        continue;
      }
      Pixel& pixel = pixels_.emplace_back();
      planner_.set_out(pixel, x, y, plan, set);
      const int needed = samples_of(pixel);
      if (needed == 0) {
        show_set(set.radiance, x, y, canvas);
        pixels_.pop_back();
        continue;
      }
      for (int first = 0; first < needed; first += static_cast<int>(lanes))
        take_samples(pixel, first, std::min(first + static_cast<int>(lanes), needed));
    }
  }
  finish(tile);
  for (const Pixel& pixel : pixels_) develop(pixel, canvas);
  for (const FloorPixel& pixel : floors_) develop(pixel, canvas);
  if (in_blocks_) shade_rows(tile, canvas);
}

// Over pixels of which is soon told what they show; where the next one begins.
int TilePainter::pass_alike(const Tile& tile, int x, int y) {
  while (x < tile.x_end) {
    const auto alike = planner_.alike_from(x, y);
    if (!alike) return x;
    if (alike->lights != 0) {
      if (!in_blocks_ || (alike->lights & ~planner_.lines().lights) != 0) return x;
      shade(tile, x, alike->end, y, alike->lights);
    }
    x = alike->end;
  }
  return x;
}

// Floor that is shown already, and lacks what the lines of its blocks find.
void TilePainter::shade(const Tile& tile, int first, int end, int y, std::uint32_t lights) {
  shaded_rows_[static_cast<std::size_t>(y - tile.y_begin)] |= ((1u << (end - first)) - 1u)
                                                              << (first - tile.x_begin);
  const int width = blocks_.size().width;
  for (int x = first; x < end; x = x / width * width + width) blocks_.add(x, y, lights);
}

// The same bits as `develop` gives.
void TilePainter::shade_rows(const Tile& tile, const Canvas& canvas) {
  const auto samples = static_cast<float>(picture_.quality.samples_per_pixel);
  const float share = 1.0f / samples, all = share * samples;
  const int width = blocks_.size().width;
  for (int y = tile.y_begin; y < tile.y_end; ++y) {
    std::uint32_t row = shaded_rows_[static_cast<std::size_t>(y - tile.y_begin)];
    while (row != 0) {
      const int first = tile.x_begin + std::countr_zero(row);
      const Color& hidden = blocks_.taken(first, y);
      for (int x = first; x < first / width * width + width; ++x) {
        const std::uint32_t bit = 1u << (x - tile.x_begin);
        if ((row & bit) == 0) continue;
        row &= ~bit;
        const Color taken = Color::Zero() - (samples * hidden) * picture_.set.floor_albedo(x, y);
        Eigen::Map<Color> light(canvas.film(x, y));
        light = all * light + (Color::Zero() + share * taken);
      }
    }
  }
}

int TilePainter::samples_of(const Pixel& pixel) const {
  return pixel.kind == PixelKind::untouched ? pixel.floor_sky_rays
                                            : picture_.quality.samples_per_pixel;
}

void TilePainter::set_out(Sample& sample, Pixel& pixel, int index) const {
  sample.pixel = &pixel;
  sample.index = index;
  if (picture_.closing_solids != nullptr || picture_.closing_camera)
    sample.time = picture_.quality.shutter * pixel.sampler.point(Dimension::Time, index).u;
  if (!picture_.figure.shapes().all_present)
    sample.present = present_figures(pixel.sampler, picture_.opacities, index);
}

void TilePainter::show_floor(Samples& samples) {
  LaneVectors origins, directions;
  aim(picture_, samples, origins, directions);
  for (int i = 0; i < samples.count; ++i) push_floor(samples[i], {origins.at(i), directions.at(i)});
  samples.count = 0;
  light_floor();
}

// Samples of a pixel that are aimed and lit together stay together, whatever else is drawn: so its
// light is always added up in the same order.
void TilePainter::take_samples(Pixel& pixel, int first, int last) {
  const bool open = pixel.kind == PixelKind::untouched || pixel.kind == PixelKind::floor;
  Samples& waiting = open ? floor_ : traced_;
  // So do those of a pair.
  const int needed = in_pairs_ && !open && pixel.x % 2 == 0 ? 2 * (last - first) : last - first;
  if (waiting.count + needed > static_cast<int>(lanes)) open ? show_floor(floor_) : trace(traced_);
  for (int i = first; i < last; ++i) set_out(waiting.next(), pixel, i);
}

void TilePainter::push_floor(const Sample& sample, const EyeRay& ray) {
  if (!sample.pixel->shows_floor) return;
  const std::optional<float> distance = distance_to_floor(ray.origin, ray.direction);
  if (distance) floor_points_.push(sample, floor_point(ray, *distance));
}

void TilePainter::light_floor() {
  darken_floor(picture_, floor_points_, queries_, lines_);
  floor_points_.samples.count = 0;
}

void TilePainter::trace(Samples& samples) {
  if (samples.count == 0) return;
  LaneVectors origins, directions;
  aim(picture_, samples, origins, directions);
  primaries_.count = 0;
  for (int i = 0; i < samples.count; ++i) {
    const Vec3 origin = origins.at(i), direction = directions.at(i);
    const std::optional<float> floor =
        picture_.scene.has_ground ? distance_to_floor(origin, direction) : std::nullopt;
    primaries_.push(origin, direction, floor.value_or(infinity), samples[i].time,
                    samples[i].present);
  }
  const Hits figure = picture_.figure.intersect(primaries_);
  Hits standing;
  std::fill_n(standing.shape, packet_size, -1);
  if (picture_.walls) standing = picture_.walls->intersect(primaries_);
  for (int first = 0, last = 0; first < samples.count; first = last) {
    while (last < samples.count && stay_together(samples[first], samples[last])) ++last;
    if (figure_surfaces_.samples.count + last - first > static_cast<int>(lanes)) light_figure();
    for (int i = first; i < last; ++i) take_primary(samples[i], i, figure, standing);
  }
  samples.count = 0;
  light_surfaces(picture_, set_surfaces_, false, queries_);
  set_surfaces_.samples.count = 0;
  light_floor();
}

void TilePainter::light_figure() {
  light_surfaces(picture_, figure_surfaces_, true, queries_);
  figure_surfaces_.samples.count = 0;
}

// Of one pixel, or of a pair.
bool TilePainter::stay_together(const Sample& a, const Sample& b) const {
  const int x = in_pairs_ ? a.pixel->x ^ 1 : a.pixel->x;
  return a.pixel->y == b.pixel->y && (a.pixel->x == b.pixel->x || x == b.pixel->x);
}

void TilePainter::take_primary(const Sample& sample, int lane, const Hits& figure,
                               const Hits& standing) {
  Pixel& pixel = *sample.pixel;
  const bool wall = standing.shape[lane] >= 0;
  if (figure.shape[lane] >= 0 && (!wall || figure.distance[lane] <= standing.distance[lane])) {
    ++pixel.covered;
    if (is_lit_with_last(sample, figure.shape[lane], lane, figure)) return;
    last_shape_ = figure.shape[lane];
    return figure_surfaces_.push(sample, surface(lane, figure, true, sample.time));
  }
  const EyeRay ray{primaries_.origin(lane), primaries_.direction(lane)};
  if (pixel.kind == PixelKind::piecemeal) {
    if (wall) return set_surfaces_.push(sample, surface(lane, standing, false, 0.0f));
    return show_open_set(picture_, sample, camera_of(picture_, sample), ray, queries_);
  }
  ++pixel.set_samples;
  if (wall) return darken_wall(picture_, sample, surface(lane, standing, false, 0.0f), queries_);
  push_floor(sample, ray);
}

// Then the last one's light counts for this sample too. Of a pair any sample may be the one that is
// lit, all by the same chance: else light would move to the left.
bool TilePainter::is_lit_with_last(const Sample& sample, int shape, int lane, const Hits& figure) {
  const int together = picture_.quality.lit_as_one;
  if (together == 1 || figure_surfaces_.samples.count == 0 || shape != last_shape_ ||
      picture_.closing_solids != nullptr)
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
  if (pixel.sampler.dice(sample.index) * (last.weight + last.partner_weight) < 1.0f)
    figure_surfaces_.surfaces[number] = surface(lane, figure, true, sample.time);
  return true;
}

Surface TilePainter::surface(int lane, const Hits& hits, bool of_figure, float time) const {
  const Vec3 direction = primaries_.direction(lane);
  const Vec3 point = primaries_.origin(lane) + hits.distance[lane] * direction;
  if (of_figure)
    return surface_at(picture_.scene, picture_.solids, picture_.closing_solids,
                      picture_.figure.shapes(), hits.shape[lane], point, direction, time);
  return surface_at(picture_.scene, picture_.scene.standing, nullptr, picture_.walls->shapes(),
                    hits.shape[lane], point, direction, time);
}

// All that waits for a full packet. Which pixels lack what a line finds that neighbours share is
// known when all is traced.
void TilePainter::finish(const Tile& tile) {
  show_floor(floor_);
  trace(traced_);
  light_figure();
  queries_.trace();
  if (in_blocks_) {
    for (const Pixel& pixel : pixels_)
      if (pixel.block_samples > 0) blocks_.add(pixel.x, pixel.y, pixel.shadow_lights);
    for (const FloorPixel& pixel : floors_) blocks_.add(pixel.x, pixel.y, pixel.shadow_lights);
    lines_.ask_all(tile, blocks_);
  }
  lines_.answer();
  if (!in_blocks_) return;
  for (Pixel& pixel : pixels_)
    if (pixel.block_samples > 0) take_hidden_from(pixel);
  for (FloorPixel& pixel : floors_) take_hidden_from(pixel);
}

void TilePainter::take_hidden_from(FloorPixel& pixel) const {
  take_light(pixel, pixel.block_samples, blocks_.taken(pixel.x, pixel.y));
}

// A pixel without figure or shadow.
void TilePainter::show_set(const Color& set, int x, int y, const Canvas& canvas) const {
  if (picture_.quality.background == Background::shown)
    std::copy_n(set.data(), 3, canvas.film(x, y));
  else if (picture_.quality.background == Background::shadow)
    canvas.alpha(x, y) = missing(set, x, y);
}

// How much of the set's light a pixel lacks.
float TilePainter::missing(const Color& left, int x, int y) const {
  const float whole = relative_luminance(Eigen::Map<const Color>(picture_.set.radiance.at(x, y)));
  return whole > 0.0f ? std::clamp(1.0f - relative_luminance(left) / whole, 0.0f, 1.0f) : 0.0f;
}

void TilePainter::develop(const Pixel& pixel, const Canvas& canvas) const {
  const float share = 1.0f / static_cast<float>(picture_.quality.samples_per_pixel);
  const Color set = (share * static_cast<float>(pixel.set_samples)) * pixel.radiance +
                    share * (pixel.known_set + pixel.set);
  expose(pixel, share * (pixel.known_figure + pixel.figure), set,
         share * (pixel.known_taken + pixel.taken), share * static_cast<float>(pixel.covered),
         canvas);
}

// The same bits as if it were a pixel whose samples all show the set.
void TilePainter::develop(const FloorPixel& pixel, const Canvas& canvas) const {
  const auto samples = static_cast<float>(picture_.quality.samples_per_pixel);
  const float share = 1.0f / samples;
  expose(pixel, Color::Zero(), (share * samples) * pixel.radiance, share * pixel.known_taken, 0.0f,
         canvas);
}

void TilePainter::expose(const FloorPixel& pixel, const Color& figure, const Color& set,
                         const Color& taken, float covered, const Canvas& canvas) const {
  if (picture_.quality.background == Background::shown) {
    const Color color = set + (figure + taken);
    std::copy_n(color.data(), 3, canvas.film(pixel.x, pixel.y));
    return;
  }
  std::copy_n(figure.data(), 3, canvas.film(pixel.x, pixel.y));
  canvas.alpha(pixel.x, pixel.y) = picture_.quality.background == Background::transparent
                                       ? covered
                                       : std::max(covered, missing(set + taken, pixel.x, pixel.y));
}

}  // namespace

void draw(const Picture& picture, const Tile& part, const Canvas& canvas) {
  TilePainter(picture).draw(part, canvas);
}

void draw_pieces(const Picture& picture, const Tile& part,
                 const std::function<void(const Tile& piece, const Film& film)>& drawn) {
  TilePainter painter(picture);
  Exposure exposure;
  for (int y = part.y_begin; y < part.y_end; y += tile_size) {
    for (int x = part.x_begin; x < part.x_end; x += piece_width) {
      const Tile piece{x, std::min(x + piece_width, part.x_end), y,
                       std::min(y + tile_size, part.y_end)};
      Film& film = exposure.film;
      film.width = piece.x_end - piece.x_begin;
      film.height = piece.y_end - piece.y_begin;
      film.channels.resize(3 * static_cast<std::size_t>(film.width) *
                           static_cast<std::size_t>(film.height));
      painter.draw(piece, {exposure, piece.x_begin, piece.y_begin});
      drawn(piece, film);
    }
  }
}

}  // namespace mien::render
