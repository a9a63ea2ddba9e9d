// What it costs to compare two pictures of 1920 × 1080, in pixels a second of CPU time: ꟻLIP on one
// thread and on all, SSIM, and channel by channel here and in OpenImageIO.

#include <random>

#include <benchmark/benchmark.h>

#include "render/compare/perceptual_error.h"
#include "render/compare/picture_difference.h"
#include "render/compare/structural_similarity.h"

namespace {

using namespace mien::render;

/// Slopes, boxes and a little noise.
Image8 picture(unsigned seed) {
  Image8 image(1920, 1080);
  std::mt19937 random(seed);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] = static_cast<std::uint8_t>(60 + x / 20 + (x / 64 + y / 48) % 2 * 30 +
                                                      static_cast<int>(random() % 8));
  return image;
}

template <class Measure>
void measure(benchmark::State& state, const Measure& of) {
  const Image8 a = picture(1), b = picture(2);
  for (auto _ : state) benchmark::DoNotOptimize(of(a, b));
  state.counters["pixels"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * a.width * a.height, benchmark::Counter::kIsRate);
}

void flip_on_one(benchmark::State& state) {
  measure(state, [](const Image8& a, const Image8& b) { return perceptual_error(a, b, {}, 1); });
}
void flip_on_all(benchmark::State& state) {
  measure(state, [](const Image8& a, const Image8& b) { return perceptual_error(a, b); });
}
void similarity(benchmark::State& state) {
  measure(state, [](const Image8& a, const Image8& b) { return structural_similarity(a, b); });
}
void difference(benchmark::State& state) {
  measure(state, [](const Image8& a, const Image8& b) { return picture_difference(a, b); });
}
void library(benchmark::State& state) {
  measure(state, [](const Image8& a, const Image8& b) { return library_difference(a, b); });
}

BENCHMARK(flip_on_one)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(flip_on_all)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(similarity)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(difference)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(library)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
