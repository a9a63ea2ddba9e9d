// Clips synthesized per second: weights, blend and foot lock of one clip from a built-in set.

#include <cstdint>

#include <benchmark/benchmark.h>

#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"
#include "motion/interpolation/blend.h"
#include "motion/interpolation/cardinal_basis.h"
#include "motion/procedural/builtin_sets.h"

namespace {

using namespace mien::motion;

/// Any numbers will do for the parameters, as long as the examples differ.
Eigen::MatrixXd spread_parameters(std::size_t examples, int dimensions) {
  Eigen::MatrixXd p(static_cast<Eigen::Index>(examples), dimensions);
  std::uint64_t state = 1;
  for (Eigen::Index i = 0; i < p.rows(); ++i) {
    for (Eigen::Index d = 0; d < p.cols(); ++d) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      p(i, d) = static_cast<double>(state >> 40) / static_cast<double>(1u << 24);
    }
  }
  return p;
}

void fit(benchmark::State& state) {
  const Eigen::MatrixXd p = spread_parameters(static_cast<std::size_t>(state.range(0)), 5);
  for (auto _ : state) benchmark::DoNotOptimize(fit_cardinal_basis(p));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(fit)->Arg(10)->Arg(30)->Unit(benchmark::kMicrosecond);

void query_weights(benchmark::State& state) {
  const CardinalBasis basis = fit_cardinal_basis(spread_parameters(30, 5));
  const Eigen::RowVectorXd at = Eigen::RowVectorXd::Constant(5, 0.4);
  for (auto _ : state) benchmark::DoNotOptimize(weights(basis, at));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(query_weights)->Unit(benchmark::kMicrosecond);

void synthesize(benchmark::State& state, const char* name, bool lock) {
  const ExampleSet set = builtin_examples(name);
  const auto basis = fit_cardinal_basis(spread_parameters(set.examples.size(), 5));
  const Eigen::RowVectorXd at = Eigen::RowVectorXd::Constant(5, 0.5);
  for (auto _ : state) {
    Clip clip = blend(set, weights(basis, at)).clip;
    if (lock) clip = foot_locked(clip, foot_plants(clip));
    benchmark::DoNotOptimize(clip);
  }
  state.counters["clips/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(synthesize, blend_of_10, "walks-10", false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(synthesize, blend_of_10_foot_locked, "walks-10", true)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(synthesize, blend_of_27_foot_locked, "walks-27", true)
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
