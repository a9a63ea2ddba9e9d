// What a change of one slider costs where 27 examples are blended by 10 parameters: the motion that
// is shown, and the distance from a target, which follows.

#include <benchmark/benchmark.h>

#include "motion/live/live_core.h"
#include "motion/live/live_message.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/study/live/live_bundle_writer.h"

namespace {

using namespace mien;
using motion::InterfaceKind;

const motion::LiveBundle& bundle() {
  static const motion::LiveBundle made = [] {
    const pipeline::Manifest manifest =
        pipeline::parse_manifest(
            "mien: 1\nstudy: live\nexamples: {set: builtin:walks-27, ratings: builtin}\n"
            "stimuli:\n  - {id: t1, weights: {happy-normal: 0.5, sad-slow: 0.5}}\n",
            "/nowhere/live.yaml", [](const std::string&) { return std::nullopt; })
            .manifest;
    pipeline::Motions motions(manifest);
    pipeline::LiveChoice choice = pipeline::live_choice(manifest);
    choice.targets = {"t1"};
    return pipeline::live_bundle(manifest, motions, choice);
  }();
  return made;
}

/// Of a kind: ten sliders, or all weights.
motion::LiveSetting sliders_of(InterfaceKind kind) {
  motion::LiveSetting setting{kind, {}, {}};
  if (kind == InterfaceKind::weights) {
    for (const auto& example : bundle().examples.examples) setting.sliders.push_back(example.name);
  } else {
    const auto& table = kind == InterfaceKind::features ? bundle().features : bundle().adjectives;
    setting.sliders.assign(table.names.begin(), table.names.begin() + 10);
  }
  setting.values.assign(setting.sliders.size(), 0.5);
  return setting;
}

void move_one(motion::LiveSetting& setting, std::size_t change) {
  setting.values[change % setting.values.size()] = static_cast<double>(change * 7 % 20) / 20.0;
}

void motion_of_change(benchmark::State& state) {
  motion::LiveCore core(bundle());
  motion::LiveSetting setting = sliders_of(static_cast<InterfaceKind>(state.range(0)));
  std::size_t change = 0;
  for (auto _ : state) {
    move_one(setting, change++);
    benchmark::DoNotOptimize(motion::to_message(core.make(setting)));
  }
}
BENCHMARK(motion_of_change)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

void distance_of_change(benchmark::State& state) {
  motion::LiveCore core(bundle());
  motion::LiveSetting setting = sliders_of(static_cast<InterfaceKind>(state.range(0)));
  std::size_t change = 0;
  for (auto _ : state) {
    move_one(setting, change++);
    benchmark::DoNotOptimize(core.distance("t1", setting));
  }
}
BENCHMARK(distance_of_change)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
