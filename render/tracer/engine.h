#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "render/geometry/embree_scene.h"
#include "render/math/filter.h"
#include "render/tracer/prepared_scene.h"
#include "render/tracer/static_background_cache.h"
#include "render/tracer/tile.h"
#include "render/tracer/tracer.h"

namespace mien::render {

/// The background of a scene: its rendered image, and its static solids for shadow rays and depth.
struct SceneBackground {
  std::vector<float> key;  ///< static_background_key; empty in reference quality
  StaticBackgroundCache::Handle image;
  std::shared_ptr<const EmbreeScene> solids;  ///< the static solids; null if there are none
};

/// Recycles the memory of backgrounds that are no longer in use. Without it, backgrounds that are
/// seen only once would be allocated anew for every picture.
class BackgroundPool {
 public:
  /// Shares a background whose memory returns to the pool, from any thread. The result must not
  /// outlive the pool.
  std::shared_ptr<const StaticBackground> wrap(StaticBackground background);

  /// A returned background, for its memory, or an empty one.
  StaticBackground acquire();

 private:
  std::mutex mutex_;
  std::vector<StaticBackground> free_;
};

/// The implementation of a tracer: its threads, Embree, and the caches that persist between
/// pictures.
class Engine {
 public:
  explicit Engine(const TracerOptions& options);

  /// The background for a camera: one of the two used last, or a new one. In reference quality its
  /// image is empty.
  SceneBackground background_for(const Scene& scene, const Camera& camera, const Quality& quality);

  /// Builds the acceleration structures and culling masks of a picture. The background and its
  /// solids, if any, must outlive the result.
  PreparedScene prepare(const Scene& scene, const Camera& camera, const Quality& quality,
                        const StaticBackground& background, const EmbreeScene* static_solids,
                        Shapes shapes, const Solids& solids);

  /// Samples the figures' occlusion of the sky, as seen from the floor.
  void sample_floor_sky(PreparedScene& prepared);

  /// Finds what pixels share of the figure's occlusion, for the window of the camera.
  void find_shared_occlusion(PreparedScene& prepared, const Camera& camera);

  /// Calls `work` for parts of the picture, each of whole tiles, that together cover the window. A
  /// thread that has to wait for the others works on other frames meanwhile. Throws Stopped when a
  /// stop was requested.
  template <class Work>
  void for_all_parts(int width, int height, const Window& window, const Work& work) {
    arena_.execute([&] { loop_over_parts(width, height, window, work); });
    if (stop_.stop_requested()) throw Stopped{};
  }

  /// See Tracer::for_frames.
  void for_frames(const FrameCallbacks& work, int in_flight);

  const EmbreeDevice& device() const { return device_; }
  tbb::task_arena& arena() { return arena_; }

 private:
  /// A background whose image is empty: only the scene's static solids.
  SceneBackground bare_background(const Scene& scene);

  /// Renders a background, reusing the memory of `room`, which may be empty.
  StaticBackground make_background(const Scene& scene, const Camera& camera, const Quality& quality,
                                   const std::string& name, StaticBackground room);

  /// Runs a loop with the tracer's threads. A thread that waits for the others does no other work,
  /// because preparations would otherwise wait for whole frames. The loop runs in the arena's
  /// context, not in the frame's: if a frame fails, all loops in the frame's context end early,
  /// which would leave a background half rendered.
  template <class Loop>
  void run_alone(const Loop& loop) {
    arena_.execute([&] { tbb::this_task_arena::isolate(loop); });
  }

  template <class Work>
  void loop_over_parts(int width, int height, const Window& window, const Work& work) {
    const auto tiles = [](int pixels) { return (pixels + tile_size - 1) / tile_size; };
    const tbb::blocked_range2d<int> all(window.y / tile_size, tiles(window.y_end()), 1,
                                        window.x / tile_size, tiles(window.x_end()), 8);
    tbb::parallel_for(all, [&](const tbb::blocked_range2d<int>& part) {
      if (stop_.stop_requested()) return;
      const auto &columns = part.cols(), &rows = part.rows();
      const Window area{columns.begin() * tile_size, rows.begin() * tile_size,
                        static_cast<int>(columns.size()) * tile_size,
                        static_cast<int>(rows.size()) * tile_size};
      work(intersection(area, {0, 0, width, height}));
    });
  }

  Framebuffer render_static_solids(const Scene& scene, const Camera& camera, const Quality& quality,
                                   const StaticBackground& open);

  EmbreeDevice device_;
  tbb::task_arena arena_;
  std::stop_token stop_;
  StaticBackgroundCache* backgrounds_;
  LightCache light_cache_;
  BackgroundPool pool_;                    // for backgrounds that are not shared with other tracers
  std::array<SceneBackground, 2> cached_;  // for a pair of cameras; last used first
  std::map<float, Filter> filters_;        // by width
};

}  // namespace mien::render
