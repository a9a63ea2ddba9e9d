// What a slider costs: fitting a method to 30 examples anew because a pair was added, the weights
// of a query, and one clip made from 30 examples. The aim is refit and clip within 5 ms together.

#include <cstdint>
#include <string>

#include <benchmark/benchmark.h>

#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"
#include "motion/interpolation/interpolation.h"
#include "motion/procedural/builtin_sets.h"

namespace {

using namespace mien::motion;
using Method = InterpolationMethod;

constexpr Eigen::Index examples = 30;

/// Thirty walks: the built-in 27 and three of them again.
const ExampleSet& thirty_walks() {
  static const ExampleSet set = [] {
    ExampleSet walks = builtin_examples("walks-27");
    for (std::size_t i = 0; walks.examples.size() < examples; ++i) {
      walks.examples.push_back(walks.examples[9 * i]);
    }
    return walks;
  }();
  return set;
}

/// Any numbers will do for the parameters, as long as the examples differ.
Eigen::MatrixXd spread_parameters(Eigen::Index dimensions) {
  Eigen::MatrixXd p(examples, dimensions);
  std::uint64_t state = 1;
  for (double& value : p.reshaped()) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    value = static_cast<double>(state >> 40) / static_cast<double>(1u << 24);
  }
  return p;
}

void refit(benchmark::State& state, Method method) {
  const Eigen::MatrixXd p = spread_parameters(6);  // four primaries and two pairs
  for (auto _ : state) {
    benchmark::DoNotOptimize(fit_interpolator(thirty_walks(), p, {.method = method}));
  }
}

void query(benchmark::State& state, Method method) {
  const Interpolator fitted =
      fit_interpolator(thirty_walks(), spread_parameters(6), {.method = method});
  const Eigen::RowVectorXd request = Eigen::RowVectorXd::Constant(6, 0.45);
  for (auto _ : state) benchmark::DoNotOptimize(weights_at(fitted, request));
}

/// From a moved slider to a clip with locked feet.
void refit_and_clip(benchmark::State& state, Method method) {
  const Eigen::MatrixXd p = spread_parameters(6);
  const Eigen::RowVectorXd request = Eigen::RowVectorXd::Constant(6, 0.45);
  for (auto _ : state) {
    const Interpolator fitted = fit_interpolator(thirty_walks(), p, {.method = method});
    const Clip clip = motion_at(fitted, thirty_walks(), request).clip;
    benchmark::DoNotOptimize(foot_locked(clip, foot_plants(clip)));
  }
}

constexpr Method methods[] = {Method::cardinal,   Method::nearest, Method::inverse_distance,
                              Method::grid,       Method::kriging, Method::pca,
                              Method::incremental};

}  // namespace

int main(int argc, char** argv) {
  benchmark::DoNotOptimize(thirty_walks());  // made before any clock runs
  for (const Method method : methods) {
    const auto add = [&](const char* what, void (*measure)(benchmark::State&, Method)) {
      benchmark::RegisterBenchmark((std::string(what) + "/" + std::string(name_of(method))).c_str(),
                                   measure, method);
    };
    add("refit", refit);
    add("query", query);
    add("refit_and_clip", refit_and_clip);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
