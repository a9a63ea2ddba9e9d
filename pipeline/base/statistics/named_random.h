#pragma once

#include <cstdint>
#include <string_view>

namespace mien::pipeline {

/// A number in (0, 1) that depends on the seed and the name alone, whatever else was drawn before.
double uniform(std::uint64_t seed, std::string_view name);

/// Likewise, of the normal distribution with mean 0 and standard deviation 1.
double normal(std::uint64_t seed, std::string_view name);

}  // namespace mien::pipeline
