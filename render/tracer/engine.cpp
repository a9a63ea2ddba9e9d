#include "render/tracer/engine.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <tbb/parallel_pipeline.h>

#include "render/light/line_shadow.h"

namespace mien::render {

namespace {

/// Of what is worked out once, metres: closer points than of pictures (floor_sky_cell).
constexpr float closest_points = 0.015f;

std::vector<float> opacities_of(const Scene& scene) {
  std::vector<float> opacities;
  for (const Figure& figure : scene.figures) opacities.push_back(figure.opacity);
  return opacities;
}

/// Bit i: lines tell what the shapes hide of light i from the floor (line_shadow.h).
std::uint32_t lights_for_lines(const std::vector<AreaLight>& lights, const Shapes& shapes,
                               bool set_has_solids) {
  if (set_has_solids || !shapes.triangles.empty() || shapes.move() || !shapes.all_present) return 0;
  std::uint32_t found = 0;
  for (std::size_t k = 0; k < lights.size(); ++k)
    if (has_line_shadows(lights[k], shapes.cones)) found |= 1u << k;
  return found;
}

std::vector<std::vector<int>> casters_of(const std::vector<AreaLight>& lights,
                                         const std::vector<RoundCone>& cones) {
  std::vector<std::vector<int>> casters(lights.size());
  for (std::size_t k = 0; k < lights.size(); ++k)
    for (std::size_t cone = 0; cone < cones.size(); ++cone)
      if (!is_behind(lights[k], cones[cone])) casters[k].push_back(static_cast<int>(cone));
  return casters;
}

}  // namespace

std::shared_ptr<const StandingSet> SetRooms::lend(StandingSet set) {
  const auto give_back = [this](StandingSet* used) {
    const std::unique_ptr<StandingSet> owned(used);
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(*owned));
  };
  return {new StandingSet(std::move(set)), give_back};
}

StandingSet SetRooms::take() {
  const std::lock_guard lock(mutex_);
  if (free_.empty()) return {};
  StandingSet room = std::move(free_.back());
  free_.pop_back();
  return room;
}

Engine::Engine(const TracerOptions& options)
    : device_(options.instruction_set),
      arena_(options.threads > 0 ? options.threads : tbb::task_arena::automatic),
      stop_(options.stop),
      sets_(options.sets),
      keep_light_(options.keep_light) {}

void Engine::look_at_sky(Picture& picture) {
  if (picture.piecemeal()) return;
  run_alone([&] {
    tbb::parallel_for(std::size_t{0}, picture.floor_sky.corner_count(), [&](std::size_t corner) {
      picture.floor_sky.look(corner, picture.figure, picture.opacities);
    });
  });
  picture.floor_sky.settle(picture.scene.sky);
}

SetBehind Engine::set_behind(const Scene& scene, const Camera& camera, const Quality& quality) {
  std::vector<float> wanted = standing_key(scene, camera, quality);
  if (wanted == kept_[0].key) return kept_[0].behind;
  std::swap(kept_[0], kept_[1]);
  auto& [key, behind] = kept_[0];
  if (wanted == key) return behind;
  key.clear();
  behind = {};
  const std::string name = standing_name(wanted);
  const auto make = [&] { return made_set(scene, camera, quality, name, rooms_.take()); };
  behind.set = sets_ != nullptr ? sets_->lend(name, make) : rooms_.lend(make());
  if (!scene.standing.empty())
    behind.solids = std::make_shared<const EmbreeScene>(device_, standing_shapes(scene));
  key = std::move(wanted);
  return behind;
}

void Engine::for_frames(const FrameWork& work, int in_flight) {
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

StandingSet Engine::made_set(const Scene& scene, const Camera& camera, const Quality& quality,
                             const std::string& name, StandingSet room) {
  const CameraFrame frame = frame_of(camera);
  StandingSet set = room_for(camera.width, camera.height, frame, std::move(room));
  const OpenSet open(scene, frame);
  run_alone(
      [&] { tbb::parallel_for(0, camera.height, [&](int y) { expose_open_row(open, y, set); }); });
  if (scene.standing.empty()) return set;
  Camera sharp = camera;
  sharp.aperture_radius = 0.0f;
  const FilmMask mask(sharp, standing_shapes(scene), 0.5f * quality.filter_width);
  const auto draw = [&] { return light_with_solids(scene, sharp, quality, set); };
  Film light = keep_light_ ? keep_light_(name, draw) : draw();
  set.solid.resize(set.floor.size());
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x)
      set.solid[set.place_of(x, y)] = mask.may_meet(x, y) ? 1 : 0;
  set.radiance = std::move(light);
  return set;
}

// What stands is drawn like a figure in the open set, once.
Film Engine::light_with_solids(const Scene& scene, const Camera& camera, const Quality& quality,
                               const StandingSet& open) {
  Quality thorough = quality;
  thorough.samples_per_pixel = quality.standing_samples;
  thorough.lit_in_pairs = thorough.floor_sky_smooth = false;
  thorough.floor_sky_cell = std::min(quality.floor_sky_cell, closest_points);
  thorough.background = Background::shown;
  Exposure exposure{Film(camera.width, camera.height), {}};
  Picture picture =
      prepare(scene, camera, thorough, open, nullptr, standing_shapes(scene), scene.standing);
  look_at_sky(picture);
  run_alone([&] {
    loop_over_parts(camera.width, camera.height, {0, 0, camera.width, camera.height},
                    [&](const Tile& part) { draw(picture, part, {exposure}); });
  });
  if (stop_.stop_requested()) throw Stopped{};
  return std::move(exposure.film);
}

Picture Engine::prepare(const Scene& scene, const Camera& camera, const Quality& quality,
                        const StandingSet& set, const EmbreeScene* walls, Shapes shapes,
                        const Solids& solids) {
  const Shapes nothing;
  const Shapes& above_floor = scene.has_ground ? shapes : nothing;
  const std::uint32_t line_lights = lights_for_lines(scene.lights, shapes, walls != nullptr);
  std::vector<ShadowMask> shadow_masks;
  for (const AreaLight& light : scene.lights) shadow_masks.emplace_back(light, above_floor);
  std::vector<std::vector<int>> casters = casters_of(scene.lights, shapes.cones);
  const BoundingSphere bounds = bounding_sphere(shapes);
  FilmMask film_mask(camera, shapes, 0.5f * quality.filter_width);
  // Behind standing solids the sky changes too fast for interpolation.
  Quality floor_quality = quality;
  if (walls != nullptr) floor_quality.floor_sky_tolerance = 0.0f;
  FloorSky floor_sky(above_floor, bounds, floor_quality,
                     view_of(frame_of(camera), camera.width, camera.height, 1.0f));
  return {.scene = scene,
          .solids = solids,
          .closing_solids = nullptr,
          .quality = quality,
          .sampler = PixelSampler::among_neighbours(quality.seed, 0, 0, quality.samples_per_pixel),
          .camera = frame_of(camera),
          .closing_camera = std::nullopt,
          .filter = filters_.try_emplace(quality.filter_width, quality.filter_width).first->second,
          .figure = EmbreeScene(device_, std::move(shapes)),
          .set = set,
          .walls = walls,
          .bounds = bounds,
          .film_mask = std::move(film_mask),
          .shadow_masks = std::move(shadow_masks),
          .line_lights = line_lights,
          .casters = std::move(casters),
          .floor_sky = std::move(floor_sky),
          .opacities = opacities_of(scene)};
}

}  // namespace mien::render
