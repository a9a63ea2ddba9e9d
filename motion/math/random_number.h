#pragma once

#include <cstdint>
#include <string_view>

namespace mien::motion {

/// The n-th output (from 0) of SplitMix64 seeded with `seed` (Steele, Lea and Flood 2014), computed
/// directly without its predecessors.
std::uint64_t random_bits(std::uint64_t seed, std::uint64_t n);

/// The top 53 bits as a number in [−1, 1).
double centred_number(std::uint64_t bits);

/// The top 53 bits as a number in the open interval (0, 1), whose logarithm is finite.
double open_unit_number(std::uint64_t bits);

/// A random number in [−1, 1), a pure function of seed, name and index: the output `index` of
/// SplitMix64 seeded with the FNV-1a hash of the name, whose offset basis is combined with `seed`
/// by exclusive or.
double random_number(std::uint64_t seed, std::string_view name, std::uint64_t index);

}  // namespace mien::motion
