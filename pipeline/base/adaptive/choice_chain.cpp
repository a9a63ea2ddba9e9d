#include "pipeline/base/adaptive/choice_chain.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "pipeline/base/statistics/named_random.h"

namespace mien::pipeline {

double reflected(double value, const DimensionRange& range) {
  const double width = range.high - range.low;
  double place = std::fmod(value - range.low, 2.0 * width);
  if (place < 0.0) place += 2.0 * width;
  return range.low + (place > width ? 2.0 * width - place : place);
}

std::vector<double> proposal_deviates(const ChoiceSettings& settings, int chain, int step) {
  std::vector<double> deviates;
  for (std::size_t i = 0; i < settings.space.size(); ++i)
    deviates.push_back(
        normal(settings.seed, fmt::format("chain {} step {} dimension {}", chain, step, i)));
  return deviates;
}

bool shows_proposal_first(const ChoiceSettings& settings, int chain, int step) {
  return uniform(settings.seed, fmt::format("chain {} step {} side", chain, step)) < 0.5;
}

ChoiceTrial choice_trial(const ChoiceSettings& settings, int chain, int step,
                         std::vector<double> current) {
  ChoiceTrial trial{{}, {}, shows_proposal_first(settings, chain, step)};
  const std::vector<double> deviates = proposal_deviates(settings, chain, step);
  for (std::size_t i = 0; i < current.size(); ++i) {
    const DimensionRange& range = settings.space[i];
    const double by = settings.deviation * (range.high - range.low) * deviates[i];
    trial.proposal.push_back(reflected(current[i] + by, range));
  }
  trial.current = std::move(current);
  return trial;
}

ChoiceChain choice_chain(const ChoiceSettings& settings, int chain,
                         const std::vector<double>& start, const std::vector<bool>& chose_first) {
  ChoiceChain result{{}, choice_trial(settings, chain, 0, start)};
  for (const bool is_first : chose_first) {
    const ChoiceTrial& trial = result.next;
    result.path.push_back(is_first == trial.is_proposal_first ? trial.proposal : trial.current);
    result.next =
        choice_trial(settings, chain, static_cast<int>(result.path.size()), result.path.back());
  }
  return result;
}

double luce_probability(double utility_a, double utility_b) {
  return 1.0 / (1.0 + std::exp(utility_b - utility_a));
}

}  // namespace mien::pipeline
