// What a motion graph costs: to build it of minutes of motion at 30 frames a second (ten minutes
// are 18,000 frames, 162 million pairs of windows), to walk over it, and a frame of the live
// walker.

#include <array>
#include <vector>

#include <benchmark/benchmark.h>

#include "motion/motion_graph/guided_walk.h"
#include "motion/motion_graph/random_walk.h"
#include "motion/procedural/affective_walk.h"
#include "motion/steered_walk/live_walk.h"
#include "motion/walker_motions.h"

namespace {

using namespace mien::motion;

/// Takes of the walker in many moods, so many minutes in all.
std::vector<Clip> takes(double minutes) {
  const auto frames = static_cast<std::size_t>(minutes * 60.0 * 30.0);
  std::vector<Clip> clips;
  std::size_t made = 0;
  for (double valence = -0.9; made < frames; valence += 0.15) {
    for (const Clip& take :
         test::walker_motions(affective_walk(valence, 0.5 * valence), 30.0, standard_body())) {
      if (made >= frames) break;
      clips.push_back(take);
      made += take.poses.size();
    }
  }
  return clips;
}

void build(benchmark::State& state) {
  const std::vector<Clip> clips = takes(static_cast<double>(state.range(0)));
  std::size_t transitions = 0;
  for (auto _ : state) transitions = motion_graph(clips).transitions.size();
  state.counters["transitions"] = static_cast<double>(transitions);
}
BENCHMARK(build)->Arg(1)->Arg(10)->Unit(benchmark::kSecond)->Iterations(1)->UseRealTime();

void random_minute(benchmark::State& state) {
  const MotionGraph graph = motion_graph(takes(0.9));
  for (auto _ : state)
    benchmark::DoNotOptimize(motion_of(graph, test::random_walk(graph, 60.0, 1)));
}
BENCHMARK(random_minute)->Unit(benchmark::kMillisecond);

void follow_ten_metres(benchmark::State& state) {
  const MotionGraph graph = motion_graph(takes(0.9));
  const std::array<Vec3, 3> path = {Vec3(0, 0, 0), Vec3(0, 0, 5), Vec3(4, 0, 8)};
  for (auto _ : state) benchmark::DoNotOptimize(walk_along(graph, path));
}
BENCHMARK(follow_ten_metres)->Unit(benchmark::kMillisecond)->Iterations(1);

void live_frame(benchmark::State& state) {
  LiveWalk walk = make_live_walk(builtin_styles("walks-10"), standard_body());
  WalkRequest request;
  request.moods.assign(10, 1.0);
  int frame = 0;
  for (auto _ : state) {
    request.pace = frame++ % 240 < 180 ? 1.0 : 0.0;
    request.turn_deg_s = frame % 400 < 200 ? 40.0 : -40.0;
    benchmark::DoNotOptimize(advance(walk, 1.0 / 60.0, request));
  }
}
BENCHMARK(live_frame)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
