// What `mien regress` takes to compare the key frames of stimuli that have all changed, once they
// are drawn: so many stimuli, four frames of 640 × 360 each, in which a figure moved. Wall time:
// `--benchmark_filter=compare_stimuli`.

#include <thread>

#include <benchmark/benchmark.h>

#include "pipeline/regression/comparison/frame_comparison.h"
#include "pipeline/regression/comparison/noise_test.h"
#include "pipeline/tasks/parallel.h"

namespace {

using namespace mien;

constexpr int width = 640;
constexpr int height = 360;
constexpr int frames_of_a_stimulus = 4;

/// A striped figure, an eighth of the width and three quarters of the height, before a slope.
render::Image8 picture(int left) {
  render::Image8 image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool is_figure =
          x >= left && x < left + width / 8 && y >= height / 8 && y < height * 7 / 8;
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] = static_cast<std::uint8_t>(
            is_figure ? 40 + (x - left + 3 * y) / 7 % 2 * 120 + c * 10 : 150 + y / 8);
    }
  }
  return image;
}

pipeline::BlockStatistics blocks(float light) {
  pipeline::BlockStatistics result{
      .columns = (width + 7) / 8, .rows = (height + 7) / 8, .patterns = pipeline::noise_patterns};
  const std::size_t count = static_cast<std::size_t>(result.columns * result.rows) * 3;
  result.mean.assign(count, light);
  result.variance.assign(count, 1e-5f);
  return result;
}

void compare_stimuli(benchmark::State& state) {
  const render::Image8 before = picture(200), now = picture(212);
  const pipeline::BlockStatistics then = blocks(0.4f), today = blocks(0.41f);
  const auto frames = static_cast<std::size_t>(state.range(0)) * frames_of_a_stimulus;
  const auto threads = static_cast<int>(std::thread::hardware_concurrency());
  for (auto _ : state) {
    pipeline::for_each_of(frames, threads, {}, [&](std::size_t) {
      benchmark::DoNotOptimize(pipeline::compare_pictures(0, before, now, 1));
      benchmark::DoNotOptimize(pipeline::noise_test(then, today, frames));
    });
  }
  state.counters["stimuli"] = benchmark::Counter(
      static_cast<double>(state.iterations() * state.range(0)), benchmark::Counter::kIsRate);
}

BENCHMARK(compare_stimuli)
    ->Arg(10)
    ->Arg(100)
    ->Arg(1000)
    ->UseRealTime()
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

}  // namespace

BENCHMARK_MAIN();
