#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mien::pipeline {

/// Factor levels of the elements of an order in which successive elements must not share a level of
/// any factor. Empty levels count as different from each other.
struct FactorLevels {
  std::vector<std::string> factors;
  std::vector<std::vector<std::string>> levels;  ///< [element][factor]

  bool share_level(std::size_t a, std::size_t b) const;
};

/// The elements in a random order in which successive elements share no level; the first one also
/// shares none with the element `before`, if given. Nullopt if a limited search finds no such
/// order. Deterministic in seed and name.
std::optional<std::vector<std::size_t>> separated_order(const FactorLevels& factor_levels,
                                                        const std::vector<std::size_t>& elements,
                                                        std::optional<std::size_t> before,
                                                        std::uint64_t seed, std::string_view name);

/// The reason why separated_order found no order, for an error message: too many of the elements
/// share a level, or else the search was unsuccessful.
std::string no_order_reason(const FactorLevels& factor_levels,
                            const std::vector<std::size_t>& elements);

}  // namespace mien::pipeline
