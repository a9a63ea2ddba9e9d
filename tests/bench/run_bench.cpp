// How much of a run's wall time is neither tracing nor encoding.
//
//   run_bench [MANIFEST]     manifests/quickstart.yaml without one
//
// Makes everything anew, in a temporary folder, with one task and with one a processor at a time.
// Tells the most memory that the process had so far, too.

#include <chrono>
#include <filesystem>
#include <thread>

#include <benchmark/benchmark.h>
#include <stdlib.h>
#include <sys/resource.h>

#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/run/run.h"

namespace {

using namespace mien::pipeline;

std::filesystem::path fresh_folder() {
  std::string name = (std::filesystem::temp_directory_path() / "mien-run-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  return name;
}

void run_everything(benchmark::State& state, const std::filesystem::path& manifest) {
  const int jobs = static_cast<int>(state.range(0));
  double total = 0.0;
  double drawn = 0.0;
  for (auto _ : state) {
    const std::filesystem::path folder = fresh_folder();
    Stopwatch drawing;
    const auto start = std::chrono::steady_clock::now();
    Production production(load_manifest(manifest, process_environment()),
                          {.quality = {}, .only = {}, .jobs = jobs, .drawing = &drawing});
    const RunResult result = run(production, folder, jobs, {}, {});
    total += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    drawn += drawing.seconds();
    std::filesystem::remove_all(folder);
    if (!result.is_complete()) state.SkipWithError("the run failed");
  }
  state.counters["drawing_s"] = drawn / static_cast<double>(state.iterations());
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  state.counters["peak_MB"] = static_cast<double>(used.ru_maxrss) * 1024e-6;
  state.counters["other_%"] = 100.0 * (total - drawn) / total;
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const std::filesystem::path manifest =
      argc > 1 ? argv[1] : MIEN_SOURCE_DIR "/manifests/quickstart.yaml";
  const auto processors = static_cast<int>(std::thread::hardware_concurrency());
  benchmark::RegisterBenchmark("run", run_everything, manifest)
      ->DenseRange(1, processors, std::max(1, processors - 1))
      ->Iterations(1)
      ->UseRealTime()
      ->Unit(benchmark::kSecond);
  benchmark::RunSpecifiedBenchmarks();
}
