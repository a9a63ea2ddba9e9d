#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mien::pipeline {

/// The factor levels of things to be put into an order in which neighbours share no level of any
/// factor. Empty levels count as different.
struct Likeness {
  std::vector<std::string> factors;
  std::vector<std::vector<std::string>> levels;  ///< [thing][factor]

  bool are_alike(std::size_t a, std::size_t b) const;
};

/// The things in a random order in which no neighbours share a level, nor do `before` and the
/// first. Nullopt when a limited search finds none. Deterministic in seed and name.
std::optional<std::vector<std::size_t>> order_apart(const Likeness& likeness,
                                                    const std::vector<std::size_t>& things,
                                                    std::optional<std::size_t> before,
                                                    std::uint64_t seed, std::string_view name);

/// A sentence on why there is no such order: the level that too many of the things have, or else
/// that the search found none.
std::string why_none(const Likeness& likeness, const std::vector<std::size_t>& things);

}  // namespace mien::pipeline
