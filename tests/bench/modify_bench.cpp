// What modifications cost. Time per item is that of one second of motion at 100 frames a second;
// `nine_grid_with_repair` makes all nine motions of the grid of a take of 10 s and lets the feet of
// each stand again.

#include <cmath>

#include <benchmark/benchmark.h>

#include "motion/gait/contact.h"
#include "motion/modify/foot_repair.h"
#include "motion/modify/modification.h"
#include "motion/modify/nine_grid.h"
#include "motion/modify/path_length.h"
#include "motion/procedural/walker.h"

namespace {

using namespace mien::motion;

/// A walk of the parametric walker, open, of that many seconds.
Clip take(double seconds) {
  const Clip loop = walk({}, 100.0, standard_body()).clip;
  Clip clip = repeated(loop, static_cast<int>(std::ceil(seconds / loop.duration_seconds())));
  clip.poses.resize(static_cast<std::size_t>(100.0 * seconds) + 1);
  return clip;
}

void per_second(benchmark::State& state, const Clip& clip) {
  state.counters["per second of motion"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * clip.duration_seconds(),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void change(benchmark::State& state, const Modification& modification) {
  const Clip clip = take(10.0);
  for (auto _ : state) benchmark::DoNotOptimize(modify(clip, modification));
  per_second(state, clip);
}

template <typename Set>
Modification with(Set set) {
  Modification modification;
  set(modification);
  return modification;
}

BENCHMARK_CAPTURE(change, paths, with([](Modification& m) { m.paths = 1.4; }))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(change, paths_of_quaternions, with([](Modification& m) {
                    m.paths = 1.4;
                    m.signal = RotationSignal::quaternions;
                  }))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(change, constant_speed, with([](Modification& m) { m.acceleration = -0.5; }))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(change, acceleration, with([](Modification& m) { m.acceleration = 0.5; }))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(change, posture, with([](Modification& m) {
                    m.posture = {{PostureUnit::head_flexion, 25.0}};
                  }))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(change, tempo, with([](Modification& m) { m.tempo = 1.2; }))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(change, variation, with([](Modification& m) { m.variation = 0.5; }))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(change, all_without_repair, with([](Modification& m) {
                    m.paths = 1.4;
                    m.acceleration = 0.3;
                    m.posture = {{PostureUnit::head_flexion, 25.0}};
                    m.repair = FootRepair::none;
                  }))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(change, all, with([](Modification& m) {
                    m.paths = 1.4;
                    m.acceleration = 0.3;
                    m.posture = {{PostureUnit::head_flexion, 25.0}};
                  }))
    ->Unit(benchmark::kMillisecond);

void nine_grid_with_repair(benchmark::State& state) {
  const Clip clip = take(10.0);
  for (auto _ : state) {
    const std::vector<FootPlant> plants = foot_plants(clip);
    const Clip still = with_still_feet(clip, plants);
    for (int i = 0; i < 9; ++i) {
      Modification place;
      place.paths = i / 3;
      place.acceleration = i % 3 - 1;
      benchmark::DoNotOptimize(
          with_plants_carried_over(grid_motion(clip, plants, place), still, plants));
    }
  }
  per_second(state, clip);
}
BENCHMARK(nine_grid_with_repair)->Unit(benchmark::kMillisecond);

void paths_of_a_long_take(benchmark::State& state) {
  const Clip clip = take(1000.0);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        with_path_gains(clip, longest_path_gains(), RotationSignal::direction_vectors));
  }
  per_second(state, clip);
}
BENCHMARK(paths_of_a_long_take)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
