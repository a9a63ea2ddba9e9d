#include "render/tracer/tracer.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "render/geometry/embree_scene.h"
#include "render/image/luminance.h"
#include "render/light/line_shadow.h"
#include "render/tracer/layer_pass.h"
#include "render/tracer/picture.h"
#include "render/tracer/tile.h"

namespace mien::render {

namespace {

Window window_of(const Camera& camera) {
  return camera.window.value_or(Window{0, 0, camera.width, camera.height});
}

/// Calls work for parts of a film, whole tiles each, that together hold the window. Throws Stopped
/// when a stop was requested.
template <class Work>
void for_all_parts(tbb::task_arena& arena, const std::stop_token& stop, const Film& film,
                   const Window& window, Work work) {
  const auto last = [](int first, int pixels) {
    return (first + pixels + tile_size - 1) / tile_size;
  };
  const tbb::blocked_range2d<int> all(window.y / tile_size, last(window.y, window.height), 1,
                                      window.x / tile_size, last(window.x, window.width), 8);
  arena.execute([&] {
    tbb::parallel_for(all, [&](const tbb::blocked_range2d<int>& part) {
      if (stop.stop_requested()) return;
      const auto &columns = part.cols(), &rows = part.rows();
      work(Tile{columns.begin() * tile_size, std::min(columns.end() * tile_size, film.width),
                rows.begin() * tile_size, std::min(rows.end() * tile_size, film.height)});
    });
  });
  if (stop.stop_requested()) throw Stopped{};
}

std::vector<float> opacities_of(const Scene& scene) {
  std::vector<float> opacities;
  for (const Figure& figure : scene.figures) opacities.push_back(figure.opacity);
  return opacities;
}

void check(const Quality& quality) {
  if (quality.samples_per_pixel < 1 || quality.sky_rays < 1 || quality.standing_samples < 1 ||
      !(quality.filter_width > 0.0f))
    throw std::invalid_argument("quality: samples, sky rays and filter width must be positive");
  if (!(quality.shutter >= 0.0f && quality.shutter <= 1.0f))
    throw std::invalid_argument("quality: the shutter is not open for a share of 0 to 1");
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

struct KeptSet {
  std::vector<float> key;
  StandingSets::Lent set;
  std::unique_ptr<EmbreeScene> solids;  // null without standing solids
};

}  // namespace

struct Tracer::Engine {
  explicit Engine(const TracerOptions& options)
      : device(options.instruction_set),
        arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic),
        stop(options.stop),
        sets(options.sets),
        keep_light(options.keep_light) {}

  EmbreeDevice device;
  tbb::task_arena arena;
  std::stop_token stop;
  StandingSets* sets;
  KeepLight keep_light;
  std::array<KeptSet, 2> kept;  // two, for a pair of cameras; the one used last comes first
  float filter_width = 0.0f;
  std::optional<Filter> filter;

  const Filter& filter_of(float width) {
    if (!filter || width != filter_width) filter.emplace(width);
    filter_width = width;
    return *filter;
  }
  const KeptSet& standing_set(const Scene& scene, const Camera& camera, const Quality& quality);
  StandingSet made_set(const Scene& scene, const Camera& camera, const Quality& quality,
                       const std::string& name);
  Film light_with_solids(const Scene& scene, const Camera& camera, const Quality& quality,
                         const StandingSet& open);
  Picture prepare(const Scene& scene, const Camera& camera, const Quality& quality,
                  const StandingSet& behind, const EmbreeScene* walls, Shapes shapes,
                  const Solids& solids);
  void look_at_sky(Picture& picture);
};

void Tracer::Engine::look_at_sky(Picture& picture) {
  if (picture.piecemeal()) return;
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, picture.floor_sky.corner_count(), [&](std::size_t corner) {
      picture.floor_sky.look(corner, picture.figure, picture.opacities);
    });
  });
  picture.floor_sky.settle(picture.scene.sky);
}

const KeptSet& Tracer::Engine::standing_set(const Scene& scene, const Camera& camera,
                                            const Quality& quality) {
  std::vector<float> wanted = standing_key(scene, camera, quality);
  if (wanted == kept[0].key) return kept[0];
  std::swap(kept[0], kept[1]);
  auto& [key, set, solids] = kept[0];
  if (wanted == key) return kept[0];
  key.clear();
  set.reset();
  solids.reset();
  const std::string name = standing_name(wanted);
  const auto make = [&] { return made_set(scene, camera, quality, name); };
  set = sets != nullptr ? sets->lend(name, make) : std::make_shared<const StandingSet>(make());
  if (!scene.standing.empty())
    solids = std::make_unique<EmbreeScene>(device, standing_shapes(scene));
  key = std::move(wanted);
  return kept[0];
}

StandingSet Tracer::Engine::made_set(const Scene& scene, const Camera& camera,
                                     const Quality& quality, const std::string& name) {
  StandingSet set = empty_set(camera.width, camera.height);
  const CameraFrame frame = frame_of(camera);
  arena.execute([&] {
    tbb::parallel_for(0, camera.height, [&](int y) { expose_open_row(scene, frame, y, set); });
  });
  if (scene.standing.empty()) return set;
  Camera sharp = camera;
  sharp.aperture_radius = 0.0f;
  const FilmMask mask(sharp, standing_shapes(scene), 0.5f * quality.filter_width);
  const auto draw = [&] { return light_with_solids(scene, sharp, quality, set); };
  Film light = keep_light ? keep_light(name, draw) : draw();
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x)
      set.solid[set.place_of(x, y)] = mask.may_meet(x, y) ? 1 : 0;
  set.radiance = std::move(light);
  return set;
}

// What stands is drawn like a figure in the open set, once.
Film Tracer::Engine::light_with_solids(const Scene& scene, const Camera& camera,
                                       const Quality& quality, const StandingSet& open) {
  Quality thorough = quality;
  thorough.samples_per_pixel = quality.standing_samples;
  thorough.background = Background::shown;
  Exposure exposure{Film(camera.width, camera.height), {}};
  Picture picture =
      prepare(scene, camera, thorough, open, nullptr, standing_shapes(scene), scene.standing);
  look_at_sky(picture);
  for_all_parts(arena, stop, exposure.film, {0, 0, camera.width, camera.height},
                [&](const Tile& part) { draw(picture, part, exposure); });
  return std::move(exposure.film);
}

Picture Tracer::Engine::prepare(const Scene& scene, const Camera& camera, const Quality& quality,
                                const StandingSet& behind, const EmbreeScene* walls, Shapes shapes,
                                const Solids& solids) {
  const Shapes nothing;
  const Shapes& above_floor = scene.has_ground ? shapes : nothing;
  const std::uint32_t line_lights = lights_for_lines(scene.lights, shapes, walls != nullptr);
  std::vector<ShadowMask> shadow_masks;
  for (const AreaLight& light : scene.lights) shadow_masks.emplace_back(light, above_floor);
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
          .camera = frame_of(camera),
          .closing_camera = std::nullopt,
          .filter = filter_of(quality.filter_width),
          .figure = EmbreeScene(device, std::move(shapes)),
          .set = behind,
          .walls = walls,
          .bounds = bounds,
          .film_mask = std::move(film_mask),
          .shadow_masks = std::move(shadow_masks),
          .line_lights = line_lights,
          .floor_sky = std::move(floor_sky),
          .opacities = opacities_of(scene)};
}

Tracer::Tracer(const TracerOptions& options) : engine_(std::make_unique<Engine>(options)) {}
Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

Film Tracer::trace(const Scene& scene, const Camera& camera, const Quality& quality, Film used) {
  Quality shown = quality;
  shown.background = Background::shown;
  return expose_on(std::move(used), scene, camera, shown, nullptr, nullptr).film;
}

Exposure Tracer::expose(const Scene& scene, const Camera& camera, const Quality& quality,
                        const Scene* closing, const Camera* closing_camera) {
  return expose_on({}, scene, camera, quality, closing, closing_camera);
}

// Where the background is shown every pixel of the window is drawn, so what was there before is
// of no account.
Exposure Tracer::expose_on(Film used, const Scene& scene, const Camera& camera,
                           const Quality& quality, const Scene* closing,
                           const Camera* closing_camera) {
  validate(scene);
  check(quality);
  if (closing != nullptr) validate(*closing);
  const KeptSet& behind = engine_->standing_set(scene, camera, quality);
  Picture picture = engine_->prepare(
      scene, camera, quality, *behind.set, behind.solids.get(),
      closing != nullptr ? shapes_between(scene, *closing) : figure_shapes(scene), scene.solids);
  if (closing != nullptr) picture.closing_solids = &closing->solids;
  if (closing_camera != nullptr) picture.closing_camera = frame_of(*closing_camera);
  engine_->look_at_sky(picture);
  const bool fits = used.width == camera.width && used.height == camera.height;
  Exposure exposure{
      fits && !used.channels.empty() ? std::move(used) : Film(camera.width, camera.height), {}};
  if (quality.background != Background::shown)
    exposure.alpha.resize(exposure.film.channels.size() / 3);
  for_all_parts(engine_->arena, engine_->stop, exposure.film, window_of(camera),
                [&](const Tile& part) { draw(picture, part, exposure); });
  if (!camera.window) return exposure;
  exposure.film = cut_out(exposure.film, *camera.window);
  if (!exposure.alpha.empty())
    exposure.alpha = cut_out(exposure.alpha, camera.width, *camera.window);
  return exposure;
}

Layers Tracer::layers(const Scene& scene, const Camera& camera, const Quality& quality,
                      const Scene* next, const Camera* next_camera) {
  validate(scene);
  check(quality);
  if (next != nullptr) validate(*next);
  Camera sharp = camera;
  sharp.aperture_radius = 0.0f;
  Layers layers = empty_layers(scene, camera.width, camera.height);
  const KeptSet& behind = engine_->standing_set(scene, sharp, quality);
  Picture picture = engine_->prepare(scene, sharp, quality, *behind.set, behind.solids.get(),
                                     figure_shapes(scene), scene.solids);
  const Shapes later = next != nullptr ? figure_shapes(*next) : Shapes{};
  if (next != nullptr) {
    shapes_between(scene, *next);  // throws when they do not match
    picture.next_shapes = &later;
  }
  const NextPicture following{next, next_camera != nullptr ? *next_camera : sharp};
  const bool moves = next != nullptr || next_camera != nullptr;
  for_all_parts(
      engine_->arena, engine_->stop, layers.albedo, window_of(sharp),
      [&](const Tile& part) { draw_layers(picture, moves ? &following : nullptr, part, layers); });
  if (sharp.window) layers = cut_out(std::move(layers), *sharp.window);
  layers.beauty = trace(scene, sharp, quality);
  add_variance(scene, sharp, quality, layers);
  return layers;
}

void Tracer::add_variance(const Scene& scene, const Camera& camera, Quality quality,
                          Layers& layers) {
  constexpr int pictures = 8;
  std::vector<double> sum(layers.variance.size()), squares(layers.variance.size());
  const std::uint64_t seed = quality.seed;
  for (int k = 0; k < pictures; ++k) {
    quality.seed = seed ^ (0x9e3779b97f4a7c15u * static_cast<std::uint64_t>(k + 1));
    const Film film = trace(scene, camera, quality);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const Color pixel = Eigen::Map<const Color>(film.channels.data() + 3 * i);
      const auto light = static_cast<double>(relative_luminance(pixel));
      sum[i] += light;
      squares[i] += light * light;
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const double mean = sum[i] / pictures;
    const double spread = squares[i] / pictures - mean * mean;
    // Below what rounding leaves of such a difference there is no noise.
    layers.variance[i] = spread > 1e-12 * mean * mean
                             ? static_cast<float>(spread * pictures / (pictures - 1))
                             : 0.0f;
  }
}

std::string Tracer::description() const { return engine_->device.description(); }

int Tracer::threads() const { return engine_->arena.max_concurrency(); }

}  // namespace mien::render
