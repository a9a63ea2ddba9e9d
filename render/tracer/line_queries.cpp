#include "render/tracer/line_queries.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

#include "render/light/floor.h"
#include "render/tracer/eye_samples.h"
#include "render/tracer/tile.h"

namespace mien::render {
namespace {

/// Half a shadow's width, in pixels, from which on the samples of a pixel share a line; neighbours
/// do from twice that, and more of them from four times.
constexpr float soft_pixels = 4.0f;

/// The pixel that is so many on from the first of those that share a line; on the film.
std::pair<int, int> neighbour(const Picture& picture, const FloorPixel& pixel,
                              const PixelBlock& block, int on) {
  return {std::min(pixel.x / block.width * block.width + on % block.width,
                   picture.set.radiance.width - 1),
          std::min(pixel.y / block.height * block.height + on / block.width,
                   picture.set.radiance.height - 1)};
}

}  // namespace

SharedLine shared_line(const TileLines& tile, int samples_per_pixel) {
  if (tile.half_shadow < soft_pixels) return {1, 1};
  if (samples_per_pixel > 2 || tile.half_shadow < 2.0f * soft_pixels) return {4, 1};
  const bool widest = tile.half_shadow >= 4.0f * soft_pixels;
  const int samples = !widest ? 4 : samples_per_pixel == 1 ? 16 : 8;
  return {samples, samples / samples_per_pixel};
}

PixelBlock block_of(const SharedLine& shared) {
  const int doublings = std::bit_width(static_cast<unsigned>(shared.pixels)) - 1;
  return {1 << ((doublings + 1) / 2), 1 << (doublings / 2)};
}

void LineQueries::ask(FloorPixel& pixel, int sample, int samples) {
  const SharedLine shared = shared_line(tile_, picture_.quality.samples_per_pixel);
  add({&pixel, shared.pixels > 1 ? 0 : sample / shared.samples, samples});
}

void LineQueries::ask_all(std::vector<FloorPixel>& pixels) {
  const int all = picture_.quality.samples_per_pixel;
  const SharedLine shared = shared_line(tile_, all);
  if (shared.pixels > 1) return ask_with_neighbours(pixels, shared);
  for (FloorPixel& pixel : pixels)
    for (int first = 0; first < all; first += shared.samples)
      ask(pixel, first, std::min(shared.samples, all - first));
}

void LineQueries::ask_with_neighbours(std::vector<FloorPixel>& pixels, const SharedLine& shared) {
  const PixelBlock block = block_of(shared);
  const int blocks_across = tile_size / block.width;
  std::array<FloorPixel*, static_cast<std::size_t>(tile_size * tile_size / 2)> firsts;
  std::fill_n(firsts.begin(), blocks_across * (tile_size / block.height), nullptr);
  for (FloorPixel& pixel : pixels) {
    const int row = pixel.y % tile_size / block.height;
    const int column = pixel.x % tile_size / block.width;
    FloorPixel*& first = firsts[static_cast<std::size_t>(row * blocks_across + column)];
    pixel.next = std::exchange(first, &pixel);
  }
  for (int i = 0; i < blocks_across * (tile_size / block.height); ++i)
    if (FloorPixel* first = firsts[static_cast<std::size_t>(i)])
      add({first, 0, picture_.quality.samples_per_pixel});
}

void LineQueries::add(const Query& query) {
  queries_[static_cast<std::size_t>(count_)] = query;
  if (++count_ == static_cast<int>(lanes)) answer();
}

std::uint32_t LineQueries::shadow_lights(const Query& query) const {
  std::uint32_t lights = 0;
  for (const FloorPixel* pixel = query.pixel; pixel != nullptr; pixel = pixel->next)
    lights |= pixel->shadow_lights;
  return lights & tile_.lights;
}

// The line is that of one of the samples that share it, wherever it lies: whether that shows the
// floor or something before it is no matter.
void LineQueries::aim(const SharedLine& shared) {
  const int all = picture_.quality.samples_per_pixel;
  const PixelBlock block = block_of(shared);
  LaneWords seed;
  for (int i = 0; i < count_; ++i) {
    const Query& query = queries_[static_cast<std::size_t>(i)];
    const FloorPixel& pixel = *query.pixel;
    const PixelSampler sampler = picture_.sampler.of_neighbour(pixel.x, pixel.y);
    index_[i] = shared.pixels > 1 ? sampler.index_of_neighbours(shared.pixels)
                                  : sampler.index_of_group(query.group, shared.samples);
    seed[i] = sampler.seed(Dimension::LightLine);
  }
  const LanePoints choice = sample_points(index_, seed);
  LaneFloats x, y;
  LaneWords place;
  for (int i = 0; i < count_; ++i) {
    const Query& query = queries_[static_cast<std::size_t>(i)];
    const int first = query.group * shared.samples;
    const int sharing = shared.pixels > 1 ? shared.samples : std::min(shared.samples, all - first);
    const int chosen = first + static_cast<int>(choice.u[i] * static_cast<float>(sharing));
    const auto [column, row] = neighbour(picture_, *query.pixel, block, chosen / all);
    const PixelSampler sampler = picture_.sampler.of_neighbour(column, row);
    place[i] = sampler.index(chosen % all);
    seed[i] = sampler.seed(Dimension::FilmPosition);
    x[i] = static_cast<float>(column) + 0.5f;
    y[i] = static_cast<float>(row) + 0.5f;
  }
  const LanePoints within = sample_points(place, seed);
  for (int i = 0; i < count_; ++i) {
    x[i] += picture_.filter.offset(within.u[i]);
    y[i] += picture_.filter.offset(within.v[i]);
  }
  LaneVectors origins, directions;
  eye_rays(picture_.camera, x, y, origins, directions);
  for (int i = 0; i < count_; ++i) {
    const EyeRay ray{origins.at(i), directions.at(i)};
    const std::optional<float> distance = distance_to_floor(ray.origin, ray.direction);
    meets_floor_[static_cast<std::size_t>(i)] = distance.has_value();
    points_.set(i, distance ? floor_point(ray, *distance) : Vec3::Zero());
  }
}

// Each query adds once to its pixels, in the order of asking, whatever waited beside it: so a
// pixel's light is always added up in the same order.
void LineQueries::answer() {
  if (count_ == 0) return;
  aim(shared_line(tile_, picture_.quality.samples_per_pixel));
  taken_.fill(Color::Zero());
  std::uint32_t shaded = 0;
  for (int i = 0; i < count_; ++i) shaded |= shadow_lights(queries_[static_cast<std::size_t>(i)]);
  for (; shaded != 0; shaded &= shaded - 1) take_hidden(std::countr_zero(shaded));
  for (int i = 0; i < count_; ++i) {
    const auto lane = static_cast<std::size_t>(i);
    const Query& query = queries_[lane];
    if (!meets_floor_[lane]) continue;
    const Color taken = static_cast<float>(query.samples) * taken_[lane];
    for (FloorPixel* pixel = query.pixel; pixel != nullptr; pixel = pixel->next)
      pixel->known_taken -= taken * pixel->floor_albedo;
  }
  count_ = 0;
}

void LineQueries::take_hidden(int light) {
  const auto k = static_cast<std::size_t>(light);
  LaneWords seed;
  std::fill_n(seed.lane, count_, picture_.sampler.seed(Dimension::FirstLight, light));
  const LightLines lines =
      lines_across(picture_.scene.lights[k], points_, sample_points(index_, seed).u);
  for (std::vector<LinePart>& hidden : hidden_) hidden.clear();
  for (const int caster : tile_.casters[k]) {
    const RoundCone& cone = picture_.figure.shapes().cones[static_cast<std::size_t>(caster)];
    const LineParts parts = hidden_by(cone, points_, lines);
    for (int i = 0; i < count_; ++i)
      if (parts.first[i] < parts.last[i])
        hidden_[static_cast<std::size_t>(i)].push_back({parts.first[i], parts.last[i]});
  }
  for (int i = 0; i < count_; ++i) {
    const auto lane = static_cast<std::size_t>(i);
    if (((shadow_lights(queries_[lane]) >> light) & 1u) != 0)
      taken_[lane] += light_of_all(lines, i, hidden_[lane]) * picture_.scene.lights[k].radiance;
  }
}

}  // namespace mien::render
