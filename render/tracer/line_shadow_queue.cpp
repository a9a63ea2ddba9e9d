#include "render/tracer/line_shadow_queue.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

#include "render/light/floor.h"
#include "render/tracer/primary_rays.h"

namespace mien::render {
namespace {

/// Least width of a penumbra, pixels, at which the samples of a pixel share a line; neighbours do
/// from twice that, and more of them from four times.
constexpr float soft_pixels = 4.0f;

/// Number of pixels that share a line in pictures of one sample, whose edges are much noisier
/// anyway.
int pixels_of_one_sample(float penumbra) {
  if (penumbra < 0.25f * soft_pixels) return 2;
  if (penumbra < soft_pixels) return 4;
  return penumbra < 4.0f * soft_pixels ? 8 : 16;
}

/// The pixel with index `on` in its block, clamped to the picture.
std::pair<int, int> neighbour(const PreparedScene& prepared, int x, int y, const PixelBlock& block,
                              int on) {
  return {std::min(x / block.width * block.width + on % block.width,
                   prepared.background.radiance.width - 1),
          std::min(y / block.height * block.height + on / block.width,
                   prepared.background.radiance.height - 1)};
}

}  // namespace

SharedLine shared_line(const TileLineShadows& tile, int samples_per_pixel) {
  if (samples_per_pixel == 1) {
    const int pixels = pixels_of_one_sample(tile.penumbra);
    return {pixels, pixels};
  }
  if (tile.penumbra < soft_pixels) return {1, 1};
  if (samples_per_pixel > 2 || tile.penumbra < 2.0f * soft_pixels) return {4, 1};
  const int samples = tile.penumbra < 4.0f * soft_pixels ? 4 : 8;
  return {samples, samples / samples_per_pixel};
}

PixelBlock block_of(const SharedLine& shared) {
  const int doublings = std::bit_width(static_cast<unsigned>(shared.pixels)) - 1;
  return {1 << ((doublings + 1) / 2), 1 << (doublings / 2)};
}

void FloorBlocks::clear(const PixelBlock& size) {
  size_ = size;
  across_ = tile_size / size.width;
  count_ = across_ * (tile_size / size.height);
  std::fill_n(blocks_.begin(), count_, Block{0, Color::Zero()});
}

void LineShadowQueue::enqueue(FloorPixel& pixel, int sample, int samples) {
  const SharedLine shared = shared_line(tile_, prepared_.quality.samples_per_pixel);
  if (shared.pixels > 1) {
    pixel.block_samples += samples;
    return;
  }
  add({pixel.x, pixel.y, pixel.shadow_lights & tile_.lights, sample / shared.samples, samples,
       &pixel, nullptr});
}

void LineShadowQueue::enqueue_all(FloorPixel& pixel) {
  const int all = prepared_.quality.samples_per_pixel;
  const int shared = shared_line(tile_, all).samples;
  for (int first = 0; first < all; first += shared)
    enqueue(pixel, first, std::min(shared, all - first));
}

void LineShadowQueue::enqueue_all(const Tile& tile, FloorBlocks& blocks) {
  const PixelBlock& size = blocks.size();
  for (int i = 0; i < blocks.count_; ++i) {
    auto& [lights, occluded] = blocks.blocks_[static_cast<std::size_t>(i)];
    if ((lights & tile_.lights) == 0) continue;
    add({tile.x_begin + i % blocks.across_ * size.width,
         tile.y_begin + i / blocks.across_ * size.height, lights & tile_.lights, 0, 1, nullptr,
         &occluded});
  }
}

void LineShadowQueue::add(const Query& query) {
  queries_[static_cast<std::size_t>(count_)] = query;
  if (++count_ == static_cast<int>(lanes)) resolve();
}

// The line is that of one of the samples that share it, wherever it lies: whether that shows the
// floor or something before it is no matter.
void LineShadowQueue::choose_lines(const SharedLine& shared) {
  const int all = prepared_.quality.samples_per_pixel;
  const PixelBlock block = block_of(shared);
  LaneWords seed;
  for (int i = 0; i < count_; ++i) {
    const Query& query = queries_[static_cast<std::size_t>(i)];
    const PixelSampler sampler = prepared_.sampler.for_pixel(query.x, query.y);
    index_[i] = shared.pixels > 1 ? sampler.index_of_block(shared.pixels)
                                  : sampler.index_of_group(query.group, shared.samples);
    seed[i] = sampler.seed(Dimension::LightLine);
  }
  const LanePoints choice = sample_points(index_, seed);
  across_ = choice.v;
  LaneFloats x, y;
  LaneWords place;
  for (int i = 0; i < count_; ++i) {
    const Query& query = queries_[static_cast<std::size_t>(i)];
    const int first = query.group * shared.samples;
    const int sharing = shared.pixels > 1 ? shared.samples : std::min(shared.samples, all - first);
    const int chosen = first + static_cast<int>(choice.u[i] * static_cast<float>(sharing));
    const auto [column, row] = neighbour(prepared_, query.x, query.y, block, chosen / all);
    const PixelSampler sampler = prepared_.sampler.for_pixel(column, row);
    place[i] = sampler.index(chosen % all);
    seed[i] = sampler.seed(Dimension::PixelPosition);
    x[i] = static_cast<float>(column) + 0.5f;
    y[i] = static_cast<float>(row) + 0.5f;
  }
  const LanePoints within = sample_points(place, seed);
  for (int i = 0; i < count_; ++i) {
    x[i] += prepared_.filter.offset(within.u[i]);
    y[i] += prepared_.filter.offset(within.v[i]);
  }
  LaneVectors origins, directions;
  camera_rays(prepared_.camera, x, y, origins, directions);
  for (int i = 0; i < count_; ++i) {
    const CameraRay ray{origins.at(i), directions.at(i)};
    const std::optional<float> distance = distance_to_floor(ray.origin, ray.direction);
    meets_floor_[static_cast<std::size_t>(i)] = distance.has_value();
    points_.set(i, distance ? floor_point(ray, *distance) : Vec3::Zero());
  }
}

// Each query adds once to its pixel, in the order of the queue, whatever was queued beside it: so a
// pixel's light is always summed in the same order.
void LineShadowQueue::resolve() {
  if (count_ == 0) return;
  choose_lines(shared_line(tile_, prepared_.quality.samples_per_pixel));
  occluded_.fill(Color::Zero());
  std::uint32_t shaded = 0;
  for (int i = 0; i < count_; ++i) shaded |= queries_[static_cast<std::size_t>(i)].lights;
  for (; shaded != 0; shaded &= shaded - 1) add_hidden(std::countr_zero(shaded));
  for (int i = 0; i < count_; ++i) {
    const auto lane = static_cast<std::size_t>(i);
    const Query& query = queries_[lane];
    if (!meets_floor_[lane]) continue;
    if (query.pixel != nullptr)
      subtract_light(*query.pixel, query.samples, occluded_[lane]);
    else
      *query.block = occluded_[lane];
  }
  count_ = 0;
}

void LineShadowQueue::add_hidden(int light) {
  const auto k = static_cast<std::size_t>(light);
  // Where on the first light the line lies was chosen together with the sample that has it.
  LaneFloats across = across_;
  if (light > 0) {
    LaneWords seed;
    std::fill_n(seed.lane, count_, prepared_.sampler.seed(Dimension::FirstLight, light));
    across = sample_points(index_, seed).u;
  }
  const LightLines lines = lines_across(prepared_.scene.lights[k], points_, across);
  for (std::vector<LineInterval>& hidden : hidden_) hidden.clear();
  for (const int caster : tile_.casters[k]) {
    const PreparedCone& cone = prepared_.figure.shapes().cones[static_cast<std::size_t>(caster)];
    const auto parts = hidden_part(cone, points_, lines);
    if (!parts) continue;
    for (int i = 0; i < count_; ++i)
      if (parts->first[i] < parts->last[i])
        hidden_[static_cast<std::size_t>(i)].push_back({parts->first[i], parts->last[i]});
  }
  for (int i = 0; i < count_; ++i) {
    const auto lane = static_cast<std::size_t>(i);
    if (((queries_[lane].lights >> light) & 1u) != 0)
      occluded_[lane] +=
          irradiance_of_union(lines, i, hidden_[lane]) * prepared_.scene.lights[k].radiance;
  }
}

}  // namespace mien::render
