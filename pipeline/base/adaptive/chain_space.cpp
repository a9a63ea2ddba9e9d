#include "pipeline/base/adaptive/chain_space.h"

#include <cstddef>

#include <fmt/format.h>

#include "pipeline/base/statistics/named_random.h"

namespace mien::pipeline {

std::vector<double> random_start(const ChainSpace& space, std::uint64_t seed, int chain,
                                 int attempt) {
  std::vector<double> point;
  for (std::size_t i = 0; i < space.size(); ++i) {
    const double share =
        uniform(seed, fmt::format("start of chain {} attempt {} dimension {}", chain, attempt, i));
    point.push_back(space[i].low + share * (space[i].high - space[i].low));
  }
  return point;
}

}  // namespace mien::pipeline
