// Megabytes of BVH text read and written per second, of a motion made in memory.

#include <cmath>
#include <string>

#include <benchmark/benchmark.h>

#include "motion/formats/bvh/bvh.h"

namespace {

using namespace mien::motion;

/// As large as a long take of a usual rig: 25 joints, 3,000 frames, about 2.5 MB of text.
Recording long_take() {
  constexpr int joints = 25;
  constexpr int frames = 3000;
  Recording recording;
  recording.name = "take";
  recording.frames_per_second = 120.0;
  for (int j = 0; j < joints; ++j) {
    // Five limbs of five joints.
    const int parent = j == 0 ? -1 : (j % 5 == 0 ? 0 : j - 1);
    recording.skeleton.joints.push_back(
        {"joint_" + std::to_string(j), parent, Vec3(0.1 * j, 15.5, -0.25), std::nullopt});
  }
  for (int f = 0; f < frames; ++f) {
    Pose pose;
    pose.root_position = Vec3(0.01 * f, 95.0 + std::sin(0.1 * f), 1.2 * f);
    for (int j = 0; j < joints; ++j) {
      const Vec3 axis = Vec3(1.0, 0.3 * j, 0.7).normalized();
      pose.rotations.push_back(Quat(Eigen::AngleAxisd(std::sin(0.05 * f + j), axis)));
    }
    recording.poses.push_back(std::move(pose));
  }
  return recording;
}

void count_bytes(benchmark::State& state, const std::string& text) {
  state.SetBytesProcessed(state.iterations() * static_cast<int64_t>(text.size()));
  state.counters["MB"] = static_cast<double>(text.size()) / 1e6;
}

void read_bvh_text(benchmark::State& state) {
  const std::string text = to_bvh(long_take());
  for (auto _ : state) benchmark::DoNotOptimize(parse_bvh(text, "take.bvh"));
  count_bytes(state, text);
}
BENCHMARK(read_bvh_text)->Unit(benchmark::kMillisecond);

void write_bvh_text(benchmark::State& state) {
  const Recording recording = long_take();
  std::string text;
  for (auto _ : state) benchmark::DoNotOptimize(text = to_bvh(recording));
  count_bytes(state, text);
}
BENCHMARK(write_bvh_text)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
