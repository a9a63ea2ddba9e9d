#include "render/tracer/engine.h"

#include <optional>
#include <utility>

#include <tbb/parallel_pipeline.h>

#include "render/tracer/occlusion_rays.h"

namespace mien::render {

namespace {

/// floor_sky_cell of static backgrounds, metres: smaller than that of pictures, because they are
/// rendered once.
constexpr float closest_points = 0.015f;

std::vector<float> opacities_of(const Scene& scene) {
  std::vector<float> opacities;
  for (const Figure& figure : scene.figures) opacities.push_back(figure.opacity);
  return opacities;
}

}  // namespace

std::shared_ptr<const StaticBackground> BackgroundPool::wrap(StaticBackground background) {
  const auto give_back = [this](StaticBackground* used) {
    const std::unique_ptr<StaticBackground> owned(used);
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(*owned));
  };
  return {new StaticBackground(std::move(background)), give_back};
}

StaticBackground BackgroundPool::acquire() {
  const std::lock_guard lock(mutex_);
  if (free_.empty()) return {};
  StaticBackground room = std::move(free_.back());
  free_.pop_back();
  return room;
}

Engine::Engine(const TracerOptions& options)
    : device_(options.instruction_set),
      arena_(options.threads > 0 ? options.threads : tbb::task_arena::automatic),
      stop_(options.stop),
      backgrounds_(options.backgrounds),
      light_cache_(options.light_cache) {}

void Engine::sample_floor_sky(PreparedScene& prepared) {
  if (prepared.is_per_sample() || prepared.quality.reference) return;
  run_alone([&] {
    tbb::parallel_for(std::size_t{0}, prepared.floor_sky.corner_count(), [&](std::size_t corner) {
      prepared.floor_sky.sample_corner(corner, prepared.figure, prepared.opacities);
    });
  });
  prepared.floor_sky.finish(prepared.scene.sky);
}

void Engine::find_shared_occlusion(PreparedScene& prepared, const Camera& camera) {
  const Quality& quality = prepared.quality;
  const int reach = 2 * std::max(quality.figure_sharing_pixels, quality.floor_sharing_pixels);
  if (reach == 0 || quality.reference || prepared.bounds.radius < 0.0f) return;
  // Also beside the window, so that its pixels are those of the whole picture.
  const Window window = window_of(camera);
  const auto tile_at = [](int first) { return std::max(first, 0) / tile_size * tile_size; };
  const int x = tile_at(window.x - reach);
  const int first = tile_at(window.y - reach) / tile_size;
  const int last = std::min(window.y_end() + reach, camera.height) - 1;
  const int width = std::min(window.x_end() + reach, camera.width) - x;
  const Window picture{0, 0, camera.width, camera.height};
  SharedOcclusion shared(camera.height, quality.figure_sharing_pixels,
                         quality.floor_sharing_pixels);
  run_alone([&] {
    tbb::parallel_for(first, last / tile_size + 1, [&](int band) {
      if (stop_.stop_requested()) return;
      const Window tiles{x, band * tile_size, width, tile_size};
      find_occlusion_in(prepared, intersection(picture, tiles), shared);
    });
  });
  if (stop_.stop_requested()) throw Stopped{};
  prepared.shared_occlusion = std::move(shared);
}

SceneBackground Engine::background_for(const Scene& scene, const Camera& camera,
                                       const Quality& quality) {
  if (quality.reference) return bare_background(scene);
  std::vector<float> wanted = static_background_key(scene, camera, quality);
  if (wanted == cached_[0].key) return cached_[0];
  std::swap(cached_[0], cached_[1]);
  SceneBackground& background = cached_[0];
  if (wanted == background.key) return background;
  background = {};
  const std::string name = static_background_name(wanted);
  const auto make = [&] { return make_background(scene, camera, quality, name, pool_.acquire()); };
  background.image =
      backgrounds_ != nullptr ? backgrounds_->get_or_make(name, make) : pool_.wrap(make());
  if (!scene.static_solids.empty())
    background.solids = std::make_shared<const EmbreeScene>(device_, static_shapes(scene));
  background.key = std::move(wanted);
  return background;
}

// The pictures of this quality need the static solids alone.
SceneBackground Engine::bare_background(const Scene& scene) {
  SceneBackground background{{}, std::make_shared<const StaticBackground>(), nullptr};
  if (!scene.static_solids.empty())
    background.solids = std::make_shared<const EmbreeScene>(device_, static_shapes(scene));
  return background;
}

void Engine::for_frames(const FrameCallbacks& work, int in_flight) {
  std::size_t next = 0;
  const auto begin = [&](tbb::flow_control& control) {
    // Embree's threads, too, are not to draw another frame while this one begins (run_alone).
    const bool more = tbb::this_task_arena::isolate([&] { return work.begin(next); });
    if (!more) control.stop();
    return more ? next++ : next;
  };
  const auto draw_frame = [&](std::size_t frame) {
    work.draw(frame);
    return frame;
  };
  const auto stages =
      tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, begin) &
      tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, draw_frame) &
      tbb::make_filter<std::size_t, void>(tbb::filter_mode::serial_in_order, work.end);
  arena_.execute([&] { tbb::parallel_pipeline(static_cast<std::size_t>(in_flight), stages); });
}

StaticBackground Engine::make_background(const Scene& scene, const Camera& camera,
                                         const Quality& quality, const std::string& name,
                                         StaticBackground room) {
  const CameraFrame frame = frame_of(camera);
  StaticBackground background =
      blank_background(camera.width, camera.height, frame, std::move(room));
  const UnshadowedBackground open(scene, frame);
  run_alone([&] {
    tbb::parallel_for(0, camera.height, [&](int y) { render_unshadowed_row(open, y, background); });
  });
  if (scene.static_solids.empty()) return background;
  Camera sharp = camera;
  sharp.aperture_radius = 0.0f;
  const PixelMask mask(sharp, static_shapes(scene), 0.5f * quality.filter_width);
  const auto draw = [&] { return render_static_solids(scene, sharp, quality, background); };
  Framebuffer light = light_cache_ ? light_cache_(name, draw) : draw();
  background.solid.resize(background.floor.size());
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x)
      background.solid[background.place_of(x, y)] = mask.may_intersect(x, y) ? 1 : 0;
  background.radiance = std::move(light);
  return background;
}

// Static solids are rendered like a figure on the unshadowed background, once.
Framebuffer Engine::render_static_solids(const Scene& scene, const Camera& camera,
                                         const Quality& quality, const StaticBackground& open) {
  Quality thorough = quality;
  thorough.samples_per_pixel = quality.static_samples;
  thorough.samples_shaded_together = 1;
  thorough.floor_sky_smooth = false;
  thorough.figure_sharing_pixels = thorough.floor_sharing_pixels = 0;
  thorough.floor_sky_cell = std::min(quality.floor_sky_cell, closest_points);
  thorough.background = Background::shown;
  RenderTarget target{Framebuffer(camera.width, camera.height), {}};
  PreparedScene prepared =
      prepare(scene, camera, thorough, open, nullptr, static_shapes(scene), scene.static_solids);
  sample_floor_sky(prepared);
  run_alone([&] {
    loop_over_parts(camera.width, camera.height, {0, 0, camera.width, camera.height},
                    [&](const Window& part) { draw(prepared, part, {target}); });
  });
  if (stop_.stop_requested()) throw Stopped{};
  return std::move(target.color);
}

PreparedScene Engine::prepare(const Scene& scene, const Camera& camera, const Quality& quality,
                              const StaticBackground& background, const EmbreeScene* static_solids,
                              Shapes shapes, const Solids& solids) {
  const Shapes nothing;
  const Shapes& above_floor = scene.has_ground ? shapes : nothing;
  std::vector<ShadowMask> shadow_masks;
  for (const AreaLight& light : scene.lights) shadow_masks.emplace_back(light, above_floor);
  const BoundingSphere bounds = bounding_sphere(shapes);
  PixelMask pixel_mask(camera, shapes, 0.5f * quality.filter_width);
  // Behind static solids the sky changes too fast for interpolation.
  Quality floor_quality = quality;
  if (static_solids != nullptr) floor_quality.floor_sky_tolerance = 0.0f;
  FloorSky floor_sky(above_floor, bounds, floor_quality,
                     view_of(frame_of(camera), camera.width, camera.height, 1.0f));
  return {.scene = scene,
          .solids = solids,
          .closing_solids = nullptr,
          .quality = quality,
          .sampler = PixelSampler::for_picture(quality.seed, 0, 0, quality.samples_per_pixel),
          .camera = frame_of(camera),
          .closing_camera = std::nullopt,
          .filter = filters_.try_emplace(quality.filter_width, quality.filter_width).first->second,
          .figure = EmbreeScene(device_, std::move(shapes)),
          .background = background,
          .static_solids = static_solids,
          .bounds = bounds,
          .pixel_mask = std::move(pixel_mask),
          .shadow_masks = std::move(shadow_masks),
          .floor_sky = std::move(floor_sky),
          .shared_occlusion = {},
          .opacities = opacities_of(scene)};
}

}  // namespace mien::render
