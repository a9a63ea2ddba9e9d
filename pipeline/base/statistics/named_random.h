#pragma once

#include <cstdint>
#include <string_view>

namespace mien::pipeline {

/// A uniform random number in (0, 1) that depends on the seed and the name only, not on earlier
/// draws.
double uniform(std::uint64_t seed, std::string_view name);

/// A random number of the standard normal distribution that depends on the seed and the name only.
double normal(std::uint64_t seed, std::string_view name);

/// The n-th number, from 0, of a stream of independent numbers of the standard normal distribution.
double normal_number(std::uint64_t stream, std::uint64_t n);

}  // namespace mien::pipeline
