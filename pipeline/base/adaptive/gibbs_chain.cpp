#include "pipeline/base/adaptive/gibbs_chain.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "pipeline/base/statistics/named_random.h"

namespace mien::pipeline {

std::size_t gibbs_dimension(const GibbsSettings& settings, int chain, int step) {
  const std::size_t dimensions = settings.dimensions;
  const std::size_t sweep = static_cast<std::size_t>(step) / dimensions;
  std::vector<std::size_t> order(dimensions);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = 0; i + 1 < dimensions; ++i) {
    const auto rest = static_cast<double>(dimensions - i);
    const double drawn =
        uniform(settings.seed, fmt::format("chain {} sweep {} place {}", chain, sweep, i));
    std::swap(order[i],
              order[i + std::min(static_cast<std::size_t>(drawn * rest), dimensions - i - 1)]);
  }
  return order[static_cast<std::size_t>(step) % dimensions];
}

GibbsSlider gibbs_slider(const GibbsSettings& settings, int chain, int step, int person) {
  const std::string name = fmt::format("chain {} step {} person {}", chain, step, person);
  return {uniform(settings.seed, name + " start"), uniform(settings.seed, name + " side") < 0.5};
}

double aggregated(std::vector<double> answers, SliderAggregate aggregate) {
  const std::size_t n = answers.size();
  if (aggregate == SliderAggregate::mean)
    return std::accumulate(answers.begin(), answers.end(), 0.0) / static_cast<double>(n);
  std::ranges::sort(answers);
  return 0.5 * (answers[(n - 1) / 2] + answers[n / 2]);
}

GibbsChain gibbs_chain(const GibbsSettings& settings, int chain, std::vector<double> start,
                       const std::vector<double>& answers) {
  GibbsChain result{{}, std::move(start), 0};
  std::vector<double> of_step;
  for (const double answer : answers) {
    of_step.push_back(answer);
    if (std::ssize(of_step) < settings.people_per_step) continue;
    const int step = static_cast<int>(result.path.size());
    result.point[gibbs_dimension(settings, chain, step)] = aggregated(of_step, settings.aggregate);
    result.path.push_back(result.point);
    of_step.clear();
  }
  result.person = static_cast<int>(of_step.size());
  return result;
}

}  // namespace mien::pipeline
