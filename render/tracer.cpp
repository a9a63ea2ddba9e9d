#include "render/tracer.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "render/embree_scene.h"
#include "render/picture.h"
#include "render/tile.h"

namespace mien::render {

struct Tracer::Engine {
  explicit Engine(const TracerOptions& options)
      : device(options.instruction_set),
        arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic) {}

  EmbreeDevice device;
  tbb::task_arena arena;
};

Tracer::Tracer(const TracerOptions& options) : engine_(std::make_unique<Engine>(options)) {}
Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

Film Tracer::trace(const Scene& scene, const Camera& camera, const Quality& quality) {
  const Picture picture = prepare(engine_->device, scene, camera, quality);
  Film film(camera.width, camera.height);
  const auto tiles = [](int pixels) { return (pixels + tile_size - 1) / tile_size; };
  const tbb::blocked_range2d<int> all(0, tiles(film.height), 1, 0, tiles(film.width), 4);
  engine_->arena.execute([&] {
    tbb::parallel_for(all, [&](const tbb::blocked_range2d<int>& part) {
      for (int row = part.rows().begin(); row < part.rows().end(); ++row)
        for (int column = part.cols().begin(); column < part.cols().end(); ++column)
          draw(picture, tile_at(film, column, row), film);
    });
  });
  return film;
}

std::string Tracer::description() const { return engine_->device.description(); }

int Tracer::threads() const { return engine_->arena.max_concurrency(); }

}  // namespace mien::render
