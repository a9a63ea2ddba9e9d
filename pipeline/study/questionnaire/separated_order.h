#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mien::pipeline {

/// The factor levels of elements to be put into an order in which neighbours share no level of any
/// factor. Empty levels count as different.
struct FactorLevels {
  std::vector<std::string> factors;
  std::vector<std::vector<std::string>> levels;  ///< [element][factor]

  bool share_level(std::size_t a, std::size_t b) const;
};

/// The elements in a random order in which no neighbours share a level, nor do `before` and the
/// first. Nullopt when a limited search finds none. Deterministic in seed and name.
std::optional<std::vector<std::size_t>> separated_order(const FactorLevels& factor_levels,
                                                        const std::vector<std::size_t>& elements,
                                                        std::optional<std::size_t> before,
                                                        std::uint64_t seed, std::string_view name);

/// A sentence on why there is no such order: the level that too many of the elements have, or else
/// that the search found none.
std::string no_order_reason(const FactorLevels& factor_levels,
                            const std::vector<std::size_t>& elements);

}  // namespace mien::pipeline
