// What a frame costs beside tracing, at 1280 × 720: development to sRGB, encoding of each kind at
// both efforts, the sketch for the check, the check, and a PNG. CPU time of all threads; draft
// films should stay below 15 ms for development and encoding together.

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <stdlib.h>

#include "render/image/image_io.h"
#include "render/image/luminance.h"
#include "render/image/tone.h"
#include "render/video/video_check.h"

namespace {

using namespace mien::render;

constexpr int width = 1280;
constexpr int height = 720;
constexpr int frame_count = 30;

/// A lit ground under a sky, with a few balls that swing, and a little noise as tracing leaves it.
Framebuffer film_of(int number) {
  Framebuffer film(width, height);
  std::uint32_t noise = 12345;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      float light = 0.45f + 0.2f * static_cast<float>(y) / height;
      for (int ball = 0; ball < 12; ++ball) {
        const double across = x - width * 0.4 - 3.0 * number - 60.0 * std::sin(ball + 0.2 * number);
        const double down = y - height * (0.2 + 0.05 * ball);
        const double square = (across * across + down * down) / 900.0;
        if (square < 1.0) light = static_cast<float>(0.6 * std::sqrt(1.0 - square));
      }
      noise = noise * 1664525u + 1013904223u;
      light += 0.002f * static_cast<float>(noise >> 24) / 255.0f;
      for (int c = 0; c < 3; ++c) film.at(x, y)[c] = light * (1.0f - 0.1f * static_cast<float>(c));
    }
  }
  return film;
}

const std::vector<Image8>& frames() {
  static const std::vector<Image8> all = [] {
    std::vector<Image8> made;
    for (int i = 0; i < frame_count; ++i) made.push_back(to_srgb8(film_of(i)));
    return made;
  }();
  return all;
}

std::filesystem::path scratch(std::string_view ending) {
  static const std::string folder = [] {
    std::string name = (std::filesystem::temp_directory_path() / "mien-encode-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    return name;
  }();
  return std::filesystem::path(folder) / ("film" + std::string(ending));
}

void per_frame(benchmark::State& state, int count) {
  state.counters["a frame"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * count,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void develop(benchmark::State& state) {
  const Framebuffer film = film_of(0);
  for (auto _ : state) benchmark::DoNotOptimize(to_srgb8(film));
  per_frame(state, 1);
}

void write_film(const std::filesystem::path& path, const VideoFormat& format) {
  VideoWriter video(path, format);
  for (const Image8& frame : frames()) video.write(frame);
  video.finish();
}

VideoFormat format_of(VideoKind kind, VideoEffort effort) {
  return {.width = width, .height = height, .kind = kind, .effort = effort};
}

void encode(benchmark::State& state, VideoKind kind, VideoEffort effort) {
  const std::filesystem::path path = scratch(traits_of(kind).ending);
  for (auto _ : state) write_film(path, format_of(kind, effort));
  per_frame(state, frame_count);
  state.counters["kB per frame"] =
      1e-3 * static_cast<double>(std::filesystem::file_size(path)) / frame_count;
}

void sketch(benchmark::State& state) {
  const FrameSketcher sketcher(width, height);
  for (auto _ : state) benchmark::DoNotOptimize(sketcher.sketch(frames()[0]));
  per_frame(state, 1);
}

void luminance(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(luminance_of(frames()[0]));
  per_frame(state, 1);
}

void check(benchmark::State& state, VideoKind kind) {
  const std::filesystem::path path = scratch(traits_of(kind).ending);
  const VideoFormat format = format_of(kind, VideoEffort::fast);
  write_film(path, format);
  VideoSketch film(width, height);
  for (const Image8& frame : frames()) film.add(frame);
  for (auto _ : state) benchmark::DoNotOptimize(check_video(path, format, film));
  per_frame(state, frame_count);
}

void write_frame(benchmark::State& state) {
  const std::filesystem::path path = scratch(".png");
  for (auto _ : state) write_png(path, frames()[0]);
  per_frame(state, 1);
}

benchmark::internal::Benchmark* measured(benchmark::internal::Benchmark* one) {
  return one->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::DoNotOptimize(frames());
  measured(benchmark::RegisterBenchmark("develop", develop));
  measured(benchmark::RegisterBenchmark("sketch", sketch));
  measured(benchmark::RegisterBenchmark("luminance", luminance));
  measured(benchmark::RegisterBenchmark("png", write_frame));
  for (const VideoTraits& traits : video_kinds()) {
    const std::string name(traits.name);
    measured(benchmark::RegisterBenchmark(("encode/" + name + "/fast").c_str(), encode, traits.kind,
                                          VideoEffort::fast))
        ->Iterations(1);
    measured(benchmark::RegisterBenchmark(("encode/" + name + "/thorough").c_str(), encode,
                                          traits.kind, VideoEffort::thorough))
        ->Iterations(1);
    measured(benchmark::RegisterBenchmark(("check/" + name).c_str(), check, traits.kind))
        ->Iterations(1);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  std::filesystem::remove_all(scratch("").parent_path());
}
