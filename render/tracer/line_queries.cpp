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

/// Samples that share a line, of one pixel or of neighbours.
constexpr int most_samples = 4;

/// Half a shadow's width, in pixels, from which on the samples of a pixel share a line; neighbours
/// do from twice that.
constexpr float soft_pixels = 4.0f;

/// The pixel that is so many on from the first of those that share a line; on the film.
std::pair<int, int> neighbour(const Picture& picture, const Pixel& pixel, int pixels, int on) {
  if (pixels == 1) return {pixel.x, pixel.y};
  const int x = (pixel.x & ~1) + (on & 1);
  const int y = pixels == 2 ? pixel.y : (pixel.y & ~1) + (on >> 1);
  return {std::min(x, picture.set.radiance.width - 1),
          std::min(y, picture.set.radiance.height - 1)};
}

}  // namespace

SharedLine shared_line(const TileLines& tile, int samples_per_pixel) {
  if (tile.half_shadow < soft_pixels) return {1, 1};
  const bool wide = tile.half_shadow >= 2.0f * soft_pixels;
  const int pixels = wide && (samples_per_pixel == 1 || samples_per_pixel == 2)
                         ? most_samples / samples_per_pixel
                         : 1;
  return {most_samples, pixels};
}

void LineQueries::ask(Pixel& pixel, int sample, int samples) {
  const SharedLine shared = shared_line(tile_, picture_.quality.samples_per_pixel);
  add({{&pixel}, 1, shared.pixels > 1 ? 0 : sample / shared.samples, samples});
}

void LineQueries::ask_all(std::vector<Pixel>& pixels) {
  const int all = picture_.quality.samples_per_pixel;
  const SharedLine shared = shared_line(tile_, all);
  if (shared.pixels == 1) {
    for (Pixel& pixel : pixels)
      for (int first = 0; first < all && tell_all(pixel); first += shared.samples)
        ask(pixel, first, std::min(shared.samples, all - first));
    return;
  }
  // The two neighbours in a row share a line, or those of two rows.
  constexpr int pairs = tile_size / 2;
  std::array<Query, static_cast<std::size_t>(tile_size * pairs)> queries;
  const auto place_of = [&](const Pixel& pixel) {
    const int row = pixel.y % tile_size / (shared.pixels == 4 ? 2 : 1);
    return static_cast<std::size_t>(row * pairs + pixel.x % tile_size / 2);
  };
  for (Pixel& pixel : pixels) {
    if (!tell_all(pixel)) continue;
    Query& query = queries[place_of(pixel)];
    query.pixels[static_cast<std::size_t>(query.count++)] = &pixel;
    query.samples = all;
  }
  for (const Query& query : queries)
    if (query.count > 0) add(query);
}

void LineQueries::add(const Query& query) {
  queries_[static_cast<std::size_t>(count_)] = query;
  if (++count_ == static_cast<int>(lanes)) answer();
}

std::uint32_t LineQueries::shadow_lights(const Query& query) const {
  std::uint32_t lights = 0;
  for (int k = 0; k < query.count; ++k)
    lights |= query.pixels[static_cast<std::size_t>(k)]->shadow_lights;
  return lights & tile_.lights;
}

// The line is that of one of the samples that share it, wherever it lies: whether that shows the
// floor or something before it is no matter.
void LineQueries::aim(const SharedLine& shared) {
  const int all = picture_.quality.samples_per_pixel;
  LaneWords seed;
  for (int i = 0; i < count_; ++i) {
    const Query& query = queries_[static_cast<std::size_t>(i)];
    const PixelSampler& sampler = query.pixels[0]->sampler;
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
    const auto [column, row] = neighbour(picture_, *query.pixels[0], shared.pixels, chosen / all);
    const PixelSampler sampler =
        PixelSampler::among_neighbours(picture_.quality.seed, column, row, all);
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
    for (int k = 0; k < query.count; ++k) {
      Pixel& pixel = *query.pixels[static_cast<std::size_t>(k)];
      pixel.known_taken -= static_cast<float>(query.samples) * taken_[lane] * pixel.floor_albedo;
    }
  }
  count_ = 0;
}

void LineQueries::take_hidden(int light) {
  const auto k = static_cast<std::size_t>(light);
  LaneWords seed;
  for (int i = 0; i < count_; ++i)
    seed[i] =
        queries_[static_cast<std::size_t>(i)].pixels[0]->sampler.seed(Dimension::FirstLight, light);
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
