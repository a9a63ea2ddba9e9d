#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mien::pipeline {

/// The levels of things in factors: things in a row must be alike in none of them. An empty level
/// is like no other.
struct Likeness {
  std::vector<std::string> factors;
  std::vector<std::vector<std::string>> levels;  ///< thing by thing, as many as factors

  bool are_alike(std::size_t a, std::size_t b) const;
};

/// These things in a random order in which no two in a row are alike, nor the first and `before`.
/// Empty when a search finds none. The same for the same seed and name.
std::optional<std::vector<std::size_t>> order_apart(const Likeness& likeness,
                                                    const std::vector<std::size_t>& things,
                                                    std::optional<std::size_t> before,
                                                    std::uint64_t seed, std::string_view name);

/// Why there is no such order, in a plain sentence: the level that too many of the things have, or,
/// where that is not it, that none was found.
std::string why_none(const Likeness& likeness, const std::vector<std::size_t>& things);

}  // namespace mien::pipeline
