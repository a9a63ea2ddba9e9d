#include "render/tracer/floor_lines.h"

#include <algorithm>
#include <bit>

#include "render/light/floor.h"
#include "render/math/constants.h"

namespace mien::render {
namespace {

/// Least width of a penumbra, pixels, at which the samples of a pixel share a line; neighbours do
/// from twice that, and more of them from four times.
constexpr float soft_pixels = 4.0f;

/// Largest extent of the floor that a pixel of a tile shows, metres.
float pixel_step(const FloorArea& area, const Tile& tile) {
  const int side = std::max(std::min(tile.x_end - tile.x_begin, tile.y_end - tile.y_begin), 1);
  return std::max(area.x_max - area.x_min, area.z_max - area.z_min) / static_cast<float>(side);
}

/// Least width of the penumbra, metres, that an edge at a height casts on the floor.
float penumbra_of(const AreaLight& light, float height) {
  if (height >= light.centre.y()) return infinity;
  const float width = 2.0f * std::min(light.half_u.norm(), light.half_v.norm());
  return width * height / (light.centre.y() - height);
}

}  // namespace

void FloorLines::begin_tile(const Tile& tile, std::uint32_t lights,
                            const std::optional<FloorArea>& area) {
  tile_ = tile;
  is_empty_ = true;
  if (lights == 0) return;
  float penumbra = area ? infinity : 0.0f;
  const float step = area ? pixel_step(*area, tile) : 0.0f;
  for (std::size_t i = 0; i < casters_.size(); ++i) {
    casters_[i].clear();
    if (((prepared_.line_lights >> i) & 1u) == 0) continue;
    if (area && ((lights >> i) & 1u) != 0) {
      const float height = prepared_.shadow_masks[i].add_casters(*area, casters_[i]);
      penumbra = std::min(penumbra, penumbra_of(prepared_.scene.lights[i], height) / step);
    }
    if (!area || prepared_.quality.exhaustive) casters_[i] = prepared_.casters[i];
  }
  share_lines(penumbra);
}

void FloorLines::share_lines(float penumbra) {
  const int samples = prepared_.quality.samples_per_pixel;
  block_width_ = block_height_ = 1;
  group_size_ = penumbra < soft_pixels ? 1 : 4;
  if (samples != 2 || penumbra < 2.0f * soft_pixels) return;
  block_width_ = 2;
  if (penumbra >= 4.0f * soft_pixels) block_height_ = 2;
  group_size_ = samples * block_width_ * block_height_;
}

void FloorLines::add(int x, int y, std::uint32_t lights, int first, int count) {
  if (is_empty_) {
    samples_.fill(0);
    lights_.fill(0);
    is_empty_ = any_shared_ = false;
  }
  const std::size_t pixel = number(x, y);
  if (samples_[pixel] == 0) {
    occluded_[pixel] = Color::Zero();
    is_shared_[pixel] = (lights & ~prepared_.line_lights) != 0;
    any_shared_ |= is_shared_[pixel];
  }
  samples_[pixel] += count;
  lights &= prepared_.line_lights;
  if (lights == 0) return;
  if (is_of_block()) {
    const int block_x = x - x % block_width_, block_y = y - y % block_height_;
    lights_[number(block_x, block_y)] |= lights;
    return;
  }
  for (const int last = first + count; first < last;) {
    const int group = first / group_size_;
    const int end = std::min((group + 1) * group_size_, last);
    enqueue({x, y, lights, group, end - first});
    first = end;
  }
}

void FloorLines::add_blocks() {
  for (int y = tile_.y_begin; y < tile_.y_end; y += block_height_)
    for (int x = tile_.x_begin; x < tile_.x_end; x += block_width_)
      if (const std::uint32_t lights = lights_[number(x, y)]; lights != 0) enqueue({x, y, lights});
}

// Samples of one group are never split: so a pixel's light is always summed in the same order.
void FloorLines::enqueue(const Query& query) {
  if (count_ > 0) {
    Query& last = queries_[static_cast<std::size_t>(count_ - 1)];
    if (last.x == query.x && last.y == query.y && last.group == query.group) {
      last.samples += query.samples;
      return;
    }
  }
  if (count_ == static_cast<int>(lanes)) resolve_batch();
  queries_[static_cast<std::size_t>(count_++)] = query;
}

void FloorLines::resolve() {
  if (is_of_block() && !is_empty_) add_blocks();
  if (count_ > 0) resolve_batch();
  if (is_empty_ || !any_shared_) return;
  for (int y = tile_.y_begin; y < tile_.y_end; ++y) {
    for (int x = tile_.x_begin; x < tile_.x_end; ++x) {
      const std::size_t pixel = number(x, y);
      if (samples_[pixel] == 0 || !is_shared_[pixel]) continue;
      occluded_[pixel] +=
          static_cast<float>(samples_[pixel]) *
          prepared_.shared_occlusion.at(x, y, SharedOcclusion::floor_part, Vec3::UnitY());
    }
  }
}

void FloorLines::resolve_batch() {
  choose_lines();
  hidden_light_.fill(Color::Zero());
  std::uint32_t lights = 0;
  for (int i = 0; i < count_; ++i) lights |= queries_[static_cast<std::size_t>(i)].lights;
  for (; lights != 0; lights &= lights - 1) add_hidden(std::countr_zero(lights));
  for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i)
    if (meets_floor_[i]) put(queries_[i], hidden_light_[i]);
  count_ = 0;
}

void FloorLines::put(const Query& query, const Color& occluded) {
  if (!is_of_block()) {
    occluded_[number(query.x, query.y)] += static_cast<float>(query.samples) * occluded;
    return;
  }
  const int x_end = std::min(query.x + block_width_, tile_.x_end);
  const int y_end = std::min(query.y + block_height_, tile_.y_end);
  for (int y = query.y; y < y_end; ++y)
    for (int x = query.x; x < x_end; ++x)
      occluded_[number(x, y)] = static_cast<float>(samples_[number(x, y)]) * occluded;
}

void FloorLines::choose_lines() {
  const int all = prepared_.quality.samples_per_pixel;
  const Framebuffer& picture = prepared_.background.radiance;
  LaneWords seed;
  for (int i = 0; i < count_; ++i) {
    const Query& query = queries_[static_cast<std::size_t>(i)];
    const PixelSampler sampler = prepared_.sampler.for_pixel(query.x, query.y);
    index_[i] = is_of_block() ? sampler.index_of_block(block_width_ * block_height_)
                              : sampler.index_of_group(query.group, group_size_);
    seed[i] = sampler.seed(Dimension::LightLine);
  }
  const LanePoints choice = sample_points(index_, seed);
  across_ = choice.v;
  LaneFloats x, y;
  LaneWords place;
  for (int i = 0; i < count_; ++i) {
    const Query& query = queries_[static_cast<std::size_t>(i)];
    const int first = query.group * group_size_;
    const int sharing = is_of_block() ? group_size_ : std::min(group_size_, all - first);
    const int chosen = first + static_cast<int>(choice.u[i] * static_cast<float>(sharing));
    // Pixels of a block that reach beyond the picture are replaced by its last ones.
    const int on = is_of_block() ? chosen / all : 0;
    const int column = std::min(query.x + on % block_width_, picture.width - 1);
    const int row = std::min(query.y + on / block_width_, picture.height - 1);
    const PixelSampler sampler = prepared_.sampler.for_pixel(column, row);
    place[i] = sampler.index(chosen - on * all);
    seed[i] = sampler.seed(Dimension::PixelPosition);
    x[i] = static_cast<float>(column) + 0.5f;
    y[i] = static_cast<float>(row) + 0.5f;
  }
  const LanePoints within = sample_points(place, seed);
  for (int i = 0; i < count_; ++i) {
    x[i] += prepared_.filter.offset(within.u[i]);
    y[i] += prepared_.filter.offset(within.v[i]);
  }
  const LaneRays rays = camera_rays(prepared_.camera, x, y);
  for (int i = 0; i < count_; ++i) {
    const Vec3 origin = rays.origin.at(i), direction = rays.direction.at(i);
    const std::optional<float> distance = distance_to_floor(origin, direction);
    meets_floor_[static_cast<std::size_t>(i)] = distance.has_value();
    Vec3 point = distance ? Vec3(origin + *distance * direction) : Vec3(Vec3::Zero());
    point.y() = 0.0f;
    points_.set(i, point);
  }
}

void FloorLines::add_hidden(int light) {
  const auto k = static_cast<std::size_t>(light);
  // The position of the line on the first light was chosen together with the sample.
  LaneFloats across = across_;
  if (light > 0) {
    LaneWords seed;
    std::fill_n(seed.lane, count_, prepared_.sampler.seed(Dimension::FirstLight, light));
    across = sample_points(index_, seed).u;
  }
  const LightLines lines = lines_across(prepared_.scene.lights[k], points_, across);
  for (std::vector<LineInterval>& hidden : hidden_) hidden.clear();
  for (const int caster : casters_[k]) {
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
      hidden_light_[lane] +=
          irradiance_of_union(lines, i, hidden_[lane]) * prepared_.scene.lights[k].radiance;
  }
}

}  // namespace mien::render
