#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace mien::pipeline {

/// 0 … count − 1 in an order that depends on seed and name alone; every order is equally likely.
std::vector<std::size_t> random_order(std::size_t count, std::uint64_t seed, std::string_view name);

/// A number 0 … count − 1 of seed, name and index alone; count must not be 0.
std::size_t random_choice(std::size_t count, std::uint64_t seed, std::string_view name,
                          std::uint64_t index = 0);

/// The seed of somebody's own: of the study's and a name.
std::uint64_t seed_of(std::uint64_t seed, std::string_view name);

}  // namespace mien::pipeline
