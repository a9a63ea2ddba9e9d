// What the analysis of a rating study costs: clustering alone, and everything but the figures.

#include <cstdint>
#include <string>

#include <benchmark/benchmark.h>

#include "pipeline/study/analysis/analysis.h"
#include "pipeline/study/analysis/analysis_report.h"

namespace {

using namespace mien::pipeline;

double next_share(std::uint64_t& state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return static_cast<double>(state >> 40) / static_cast<double>(1u << 24);
}

void cluster(benchmark::State& state) {
  const Eigen::Index size = state.range(0);
  Eigen::MatrixXd rows(size, size);
  std::uint64_t random = 1;
  for (Eigen::Index i = 0; i < size * size; ++i) rows(i / size, i % size) = next_share(random);
  for (auto _ : state) benchmark::DoNotOptimize(ward(rows));
}
BENCHMARK(cluster)->Arg(41)->Arg(100)->Arg(500)->Unit(benchmark::kMillisecond);

/// 14 raters, 27 examples, the 41 adjective pairs.
void analyse_answers(benchmark::State& state) {
  const ScaleSet scales = builtin_scales();
  std::vector<RatedExample> examples;
  StudyAnswers study;
  std::uint64_t random = 1;
  for (int i = 0; i < 27; ++i) {
    examples.push_back({"walk-" + std::to_string(i), ""});
    for (const Scale& scale : scales.scales) {
      const double middle = 4.0 * next_share(random) - 2.0;
      for (int r = 0; r < 14; ++r) {
        StudyAnswer answer;
        answer.participant = "p" + std::to_string(r);
        answer.stimulus = examples.back().name;
        answer.scale = scale.id;
        answer.value = 0.75 * middle + next_share(random) - 0.5;
        study.answers.push_back(answer);
      }
    }
  }
  for (auto _ : state) {
    const Analysis analysis = analyse(study, scales, examples, {});
    benchmark::DoNotOptimize(linkage_table(analysis).csv);
  }
}
BENCHMARK(analyse_answers)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
