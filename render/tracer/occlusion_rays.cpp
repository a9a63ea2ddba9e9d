#include "render/tracer/occlusion_rays.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/light/light.h"
#include "render/math/constants.h"
#include "render/tracer/camera_rays.h"
#include "render/tracer/pixel_plan.h"
#include "render/tracer/samples.h"
#include "render/tracer/shadow_rays.h"

namespace mien::render {
namespace {

/// The part of a sample that shows neither the figure nor a floor that it may shadow.
constexpr int nothing = -2;

/// Casts the rays of eight samples at a time.
class OcclusionFinder {
 public:
  OcclusionFinder(const PreparedScene& prepared, SharedOcclusion& shared)
      : prepared_(prepared),
        shared_(shared),
        everywhere_(prepared.is_per_sample() || prepared.quality.exhaustive),
        // Pixels that render their own background cast rays for their floor.
        of_floor_(prepared.quality.floor_sharing_pixels > 0 && !prepared.is_per_sample() &&
                  prepared.scene.has_ground && !prepared.scene.lights.empty()),
        of_figure_(prepared.quality.figure_sharing_pixels > 0),
        lights_of_figure_(of_figure_ && prepared.quality.figure_shares_lights),
        planner_(prepared),
        rays_(prepared) {}

  /// Finds what there is in a row of tiles, and hands it over.
  void find_in(const Window& band);

 private:
  /// A sample, the start of its rays, and what they find.
  struct Point {
    Pixel pixel;
    Sample sample;
    std::uint32_t index = 0;  // of its random numbers
    Vec3 origin = Vec3::Zero();
    SharedOcclusion::Found found;
  };

  bool may_show_figure(const Window& tile, int y) const {
    return of_figure_ &&
           (everywhere_ || prepared_.pixel_mask.may_intersect_row(tile.x, tile.x_end(), y));
  }
  void find(const Window& tile);
  void add_pixel(int x, int y, std::uint32_t lights, bool may_show_figure);
  void cast();
  void place();
  void find_sky();
  void find_light(int light);
  LanePoints random_points(Dimension dimension, int which = 0) const;

  const PreparedScene& prepared_;
  SharedOcclusion& shared_;
  const bool everywhere_;        // any pixel may show the figure
  const bool of_floor_;          // shadows on the floor are shared
  const bool of_figure_;         // occlusion of the sky on figures is shared
  const bool lights_of_figure_;  // that of the area lights, too
  PixelPlanner planner_;
  std::array<Point, lanes> points_;
  std::size_t count_ = 0;
  bool may_hit_ = false;  // any of the samples may show a solid
  ShadowRays rays_;
  std::array<std::vector<SharedOcclusion::Found>, tile_size> figure_rows_;
  std::array<std::vector<SharedOcclusion::Found>, tile_size> floor_rows_;
};

void OcclusionFinder::find_in(const Window& band) {
  bool any = of_floor_;
  for (int y = band.y; y < band.y_end() && !any; ++y) any = may_show_figure(band, y);
  if (!any) return;
  for (int x = band.x; x < band.x_end(); x += tile_size)
    find(intersection(band, {x, band.y, tile_size, band.height}));
  cast();
  for (int y = band.y; y < band.y_end(); ++y) {
    shared_.set_figure_row(y, figure_rows_[static_cast<std::size_t>(y % tile_size)]);
    shared_.set_floor_row(y, floor_rows_[static_cast<std::size_t>(y % tile_size)]);
  }
}

void OcclusionFinder::find(const Window& tile) {
  if (of_floor_) planner_.begin_tile(tile);
  const bool shadowed = of_floor_ && planner_.may_show_shadow();
  for (int y = tile.y; y < tile.y_end(); ++y) {
    if (!shadowed && !may_show_figure(tile, y)) continue;
    const PixelPlan* plans = shadowed ? planner_.plan_row(y).data() : nullptr;
    for (int x = tile.x; x < tile.x_end(); ++x) {
      const std::uint32_t lights = shadowed ? plans[x - tile.x].shadow_lights : 0;
      const bool figure = everywhere_ || prepared_.pixel_mask.may_intersect(x, y);
      if (lights != 0 || (of_figure_ && figure)) add_pixel(x, y, lights, figure);
    }
  }
}

void OcclusionFinder::add_pixel(int x, int y, std::uint32_t lights, bool may_show_figure) {
  // Every n-th sample of the sequence that all pixels share: pixels with fewer samples take turns.
  const Quality& quality = prepared_.quality;
  const auto every = static_cast<std::uint32_t>(lights != 0 ? quality.floor_samples_per_ray
                                                            : quality.figure_samples_per_ray);
  const PixelSampler sampler = prepared_.sampler.for_pixel(x, y);
  const std::uint32_t first = (every - sampler.index(0) % every) % every;
  for (std::uint32_t i = first; i < static_cast<std::uint32_t>(prepared_.quality.samples_per_pixel);
       i += every) {
    Point& point = points_[count_];
    point.pixel.x = x;
    point.pixel.y = y;
    point.pixel.sampler = sampler;
    point.pixel.shadow_lights = lights;
    point.sample = sample_at(prepared_, point.pixel, static_cast<int>(i));
    point.index = sampler.index(static_cast<int>(i)) / every;
    point.found = {x, nothing, Vec3::UnitY(), Color::Zero(), Color::Zero()};
    may_hit_ |= may_show_figure || prepared_.static_solids != nullptr;
    if (++count_ == lanes) cast();
  }
}

void OcclusionFinder::cast() {
  if (count_ == 0) return;
  place();
  if (of_figure_) find_sky();
  for (int k = 0; k < static_cast<int>(prepared_.scene.lights.size()); ++k) find_light(k);
  rays_.finish();
  for (std::size_t i = 0; i < count_; ++i) {
    const SharedOcclusion::Found& found = points_[i].found;
    auto& rows = found.part == SharedOcclusion::floor_part ? floor_rows_ : figure_rows_;
    if (found.part != nothing)
      rows[static_cast<std::size_t>(points_[i].pixel.y % tile_size)].push_back(found);
  }
  count_ = 0;
  may_hit_ = false;
}

// Finds the surfaces that the samples show.
void OcclusionFinder::place() {
  std::array<Sample, lanes> samples;
  for (std::size_t i = 0; i < count_; ++i) samples[i] = points_[i].sample;
  const RayPacket rays = camera_rays(prepared_, {samples.data(), count_});
  std::array<FirstHit, packet_size> hits;
  if (may_hit_) hits = first_hits(prepared_, rays);
  for (std::size_t i = 0; i < count_; ++i) {
    const int ray = static_cast<int>(i);
    Point& point = points_[i];
    if (hits[i].exists() && hits[i].of_figure) {
      const Surface surface = surface_at(prepared_, rays, ray, hits[i]);
      point.origin = surface.origin;
      point.found.part = surface.part;
      point.found.normal = surface.normal;
    } else if (!hits[i].exists() && point.pixel.shadow_lights != 0) {
      const std::optional<Vec3> floor = floor_point(rays, ray);
      if (!floor) continue;
      point.origin = *floor;
      point.found.part = SharedOcclusion::floor_part;
    }
  }
}

void OcclusionFinder::find_sky() {
  const Sky& sky = prepared_.scene.sky;
  const auto shows_figure = [](const Point& point) { return point.found.part >= 0; };
  if (std::none_of(points_.begin(), points_.begin() + count_, shows_figure)) return;
  LaneVectors normals;
  for (std::size_t i = 0; i < count_; ++i)
    normals.set(static_cast<int>(i), points_[i].found.normal);
  const LaneVectors towards = cosine_directions(normals, random_points(Dimension::FigureSky));
  for (std::size_t i = 0; i < count_; ++i) {
    Point& point = points_[i];
    if (!shows_figure(point)) continue;
    const Vec3 direction = towards.at(static_cast<int>(i));
    point.found.light += unoccluded_sky_light(sky, point.found.normal);
    rays_.push(point.sample, point.origin, direction,
               distance_to_end(prepared_.scene, point.origin, direction),
               sky_radiance(sky, direction), ShadowRays::Condition::occluded, point.found.occluded);
  }
}

void OcclusionFinder::find_light(int number) {
  const auto is_lit = [&](const Point& point) {
    if (point.found.part != SharedOcclusion::floor_part)
      return point.found.part != nothing && lights_of_figure_;
    return ((point.pixel.shadow_lights >> number) & 1u) != 0;
  };
  if (std::none_of(points_.begin(), points_.begin() + count_, is_lit)) return;
  const AreaLight& light = prepared_.scene.lights[static_cast<std::size_t>(number)];
  LaneVectors origins;
  for (std::size_t i = 0; i < count_; ++i) origins.set(static_cast<int>(i), points_[i].origin);
  const LaneLights chosen = sample(light, origins, random_points(Dimension::FirstLight, number));
  for (std::size_t i = 0; i < count_; ++i) {
    Point& point = points_[i];
    const int lane = static_cast<int>(i);
    const Vec3 towards = chosen.towards.at(lane);
    const float irradiance = point.found.normal.dot(towards) * chosen.share[lane];
    if (!is_lit(point) || irradiance <= 0.0f) continue;
    const Color radiance = irradiance / pi * light.radiance;
    const bool of_floor = point.found.part == SharedOcclusion::floor_part;
    if (!of_floor)
      point.found.light += radiance;
    else if (!prepared_.quality.exhaustive &&
             !may_intersect(prepared_.bounds, point.origin, towards))
      continue;
    rays_.push(point.sample, point.origin, towards, chosen.distance[lane], radiance,
               of_floor ? ShadowRays::Condition::shadowed : ShadowRays::Condition::occluded,
               point.found.occluded);
  }
}

LanePoints OcclusionFinder::random_points(Dimension dimension, int which) const {
  LaneWords index, seed;
  for (std::size_t i = 0; i < count_; ++i) {
    index.lane[i] = points_[i].index;
    seed.lane[i] = points_[i].pixel.sampler.seed(dimension, which);
  }
  return sample_points(index, seed);
}

}  // namespace

void find_occlusion_in(const PreparedScene& prepared, const Window& band, SharedOcclusion& shared) {
  OcclusionFinder(prepared, shared).find_in(band);
}

}  // namespace mien::render
