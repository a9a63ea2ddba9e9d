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
#include "render/tracer/picture.h"
#include "render/tracer/standing_sets.h"
#include "render/tracer/tile.h"
#include "render/tracer/tracer.h"

namespace mien::render {

/// The set behind a picture's figures.
struct SetBehind {
  StandingSets::Lent set;
  std::shared_ptr<const EmbreeScene> solids;  ///< the standing ones; null without
};

/// Memory of sets that no picture shows any more: sets that are seen once would else take new
/// memory for every picture.
class SetRooms {
 public:
  /// A set whose memory comes back here, from whatever thread. Does not outlive the rooms.
  std::shared_ptr<const StandingSet> lend(StandingSet set);

  /// That of a set that came back, or an empty one.
  StandingSet take();

 private:
  std::mutex mutex_;
  std::vector<StandingSet> free_;
};

/// What a tracer works with: its threads, Embree, and what it knows from picture to picture.
class Engine {
 public:
  explicit Engine(const TracerOptions& options);

  /// Made, unless it was behind one of the last two cameras.
  SetBehind set_behind(const Scene& scene, const Camera& camera, const Quality& quality);

  /// What the solids can touch of what is behind them; the set and its solids, if any, outlive it.
  Picture prepare(const Scene& scene, const Camera& camera, const Quality& quality,
                  const StandingSet& set, const EmbreeScene* walls, Shapes shapes,
                  const Solids& solids);

  /// Finds what the picture's figures hide of the sky from the floor.
  void look_at_sky(Picture& picture);

  /// Calls work for parts of a film, whole tiles each, that together hold the window. Who waits for
  /// others to end helps with other frames. Throws Stopped when a stop was requested.
  template <class Work>
  void for_all_parts(int width, int height, const Window& window, const Work& work) {
    arena_.execute([&] { loop_over_parts(width, height, window, work); });
    if (stop_.stop_requested()) throw Stopped{};
  }

  /// As Tracer::for_frames.
  void for_frames(const FrameWork& work, int in_flight);

  const EmbreeDevice& device() const { return device_; }
  tbb::task_arena& arena() { return arena_; }

 private:
  struct KeptSet {
    std::vector<float> key;
    SetBehind behind;
  };

  /// `room`: a set that is no longer wanted, whose memory serves again, or an empty one.
  StandingSet made_set(const Scene& scene, const Camera& camera, const Quality& quality,
                       const std::string& name, StandingSet room);

  /// Runs a loop with the tracer's threads; who waits for others to end helps with nothing else:
  /// what is made ready would else wait for whole frames. In the arena's own context: where a frame
  /// fails, the loops of its context end early, and a set would be lent that is half made.
  template <class Loop>
  void run_alone(const Loop& loop) {
    arena_.execute([&] { tbb::this_task_arena::isolate(loop); });
  }

  template <class Work>
  void loop_over_parts(int width, int height, const Window& window, const Work& work) {
    const auto last = [](int first, int pixels) {
      return (first + pixels + tile_size - 1) / tile_size;
    };
    const tbb::blocked_range2d<int> all(window.y / tile_size, last(window.y, window.height), 1,
                                        window.x / tile_size, last(window.x, window.width), 8);
    tbb::parallel_for(all, [&](const tbb::blocked_range2d<int>& part) {
      if (stop_.stop_requested()) return;
      const auto &columns = part.cols(), &rows = part.rows();
      work(Tile{columns.begin() * tile_size, std::min(columns.end() * tile_size, width),
                rows.begin() * tile_size, std::min(rows.end() * tile_size, height)});
    });
  }

  Film light_with_solids(const Scene& scene, const Camera& camera, const Quality& quality,
                         const StandingSet& open);

  EmbreeDevice device_;
  tbb::task_arena arena_;
  std::stop_token stop_;
  StandingSets* sets_;
  KeepLight keep_light_;
  SetRooms rooms_;                   // of sets that no other tracer may have
  std::array<KeptSet, 2> kept_;      // two, for a pair of cameras; the one used last comes first
  std::map<float, Filter> filters_;  // by width
};

}  // namespace mien::render
