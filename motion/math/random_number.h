#pragma once

#include <cstdint>
#include <string_view>

namespace mien::motion {

/// In [−1, 1], of seed, name and index alone, whatever else was drawn: FNV-1a, then the mixer of
/// SplitMix64 (Steele et al. 2014).
double random_number(std::uint64_t seed, std::string_view name, std::uint64_t index);

}  // namespace mien::motion
