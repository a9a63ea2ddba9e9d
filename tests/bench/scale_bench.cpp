// What a study of many stimuli costs beside drawing: reading and planning it, looking up what is
// there, tables, report. Films, clips and sheets are not drawn: small files of the right kind stand
// for them in the store.
//
//   scale_bench [--benchmark_filter=/10000]
//
// Counters are seconds, but for `peak_MB`, the most memory that the process held. TMPDIR says where
// the study lies.

#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <stdlib.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/film/film_record.h"
#include "pipeline/production/run/run.h"

namespace {

using namespace mien::pipeline;
namespace fs = std::filesystem;

/// Pairs of stimuli that differ all in what they ask for, and a comparison of each pair.
std::string manifest_of(int stimuli, bool equalized) {
  std::string text =
      "mien: 1\nstudy: many\nseed: 7\nexamples: {set: builtin:walks-10, ratings: builtin}\n"
      "output: {size: [32, 18], cycles: 1, quality: draft, video: [mp4], frames: none}\n";
  if (equalized) text += "equalize: [duration]\n";
  text += "stimuli:\n";
  for (int i = 0; i < stimuli; ++i) {
    const double quick = 0.35 + 0.4 * (i * 7919L % 9973) / 9973.0;
    const double active = 0.35 + 0.4 * (i * 104729L % 9949) / 9949.0;
    text += fmt::format("  - {{factors: {{block: b{}}}, ", i / 200);
    if (i % 2 == 0) {
      text += fmt::format("id: target-{}, role: target, adjectives: {{quickness: {:.6f}, ", i / 2,
                          quick);
      text += fmt::format("activeness: {:.6f}}}}}\n", active);
    } else {
      text += fmt::format("id: guess-{}, adjectives: {{quickness: {:.6f}}}, ", i / 2, active);
      text += "look: {figure: mannequin}}\n";
    }
  }
  text += "sheets:\n";
  for (int i = 0; i < stimuli / 2; ++i)
    text += fmt::format(
        "  - compare: {{target: target-{0}, created: guess-{0}, reference: normal}}\n", i);
  return text;
}

/// Puts a small file in the place of each product.
void put_stand_ins(TaskRun& run) {
  for (std::size_t i = 0; i < run.keys.size(); ++i) {
    const std::string& path = run.task.products[i].path;
    FilmRecord film;
    film.film_frames = 32;
    const std::string text =
        path.ends_with(".json") ? film_record_text(film) : "in place of " + path;
    run.store.put(
        path, run.keys[i], [&](const fs::path& file) { write_file(file, text); },
        [](const fs::path&) {});
  }
}

TaskGraph without_drawing(const TaskGraph& graph) {
  TaskGraph simulated = graph;
  for (Task& task : simulated.tasks) {
    if (task.kind == "film" || task.kind == "sheet") task.make = put_stand_ins;
  }
  return simulated;
}

class Watch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

template <class Work>
double seconds_of(const Work& work) {
  const Watch watch;
  work();
  return watch.seconds();
}

void forget_peak_memory() { std::ofstream("/proc/self/clear_refs") << "5"; }

double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024.0;
  }
  return 0.0;
}

/// Seconds that tasks of each kind took together.
std::map<std::string, double> simulated_run(const Production& production, const fs::path& folder) {
  std::map<std::string, Watch> begun;
  std::map<std::string, double> seconds;
  const RunObserver observer = {
      .started = [&](const Task& task) { begun[task.id] = {}; },
      .progressed = {},
      .ended = [&](const Task& task,
                   const TaskOutcome&) { seconds[task.kind] += begun[task.id].seconds(); }};
  Store store(folder);
  run(without_drawing(production.graph()), store, 1, {}, observer);
  return seconds;
}

void many_stimuli(benchmark::State& state) {
  std::string name = (fs::temp_directory_path() / "mien-scale-XXXXXX").string();
  const fs::path folder = mkdtemp(name.data());
  const fs::path file = folder / "many.yaml";
  write_file(file, manifest_of(static_cast<int>(state.range(0)), state.range(1) != 0));
  for (auto _ : state) {
    forget_peak_memory();
    Manifest manifest;
    state.counters["read"] =
        seconds_of([&] { manifest = load_manifest(file, process_environment()); });
    std::unique_ptr<Production> production;
    state.counters["plan"] = seconds_of([&] {
      production = std::make_unique<Production>(std::move(manifest), ProductionOptions{});
      benchmark::DoNotOptimize(quick_plan(production->graph(), folder / "out"));
    });
    state.counters["plan_peak_MB"] = peak_megabytes();
    for (const auto& [kind, seconds] : simulated_run(*production, folder / "out")) {
      if (kind == "motion" || kind == "tables" || kind == "design" || kind == "report")
        state.counters[kind] = seconds;
    }
    state.counters["glance"] = seconds_of(
        [&] { benchmark::DoNotOptimize(quick_plan(production->graph(), folder / "out")); });
    state.counters["look_up"] =
        seconds_of([&] { benchmark::DoNotOptimize(plan(production->graph(), folder / "out")); });
    state.counters["peak_MB"] = peak_megabytes();
  }
  fs::remove_all(folder);
}
BENCHMARK(many_stimuli)
    ->ArgsProduct({{10, 100, 1000, 10000}, {0, 1}})
    ->ArgNames({"", "equalized"})
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);

}  // namespace

BENCHMARK_MAIN();
