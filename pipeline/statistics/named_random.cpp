#include "pipeline/statistics/named_random.h"

#include <cmath>

#include <xxhash.h>

namespace mien::pipeline {

namespace {

constexpr double two_pi = 6.28318530717958647692;

double to_unit(std::uint64_t bits) { return (static_cast<double>(bits >> 11) + 0.5) * 0x1.0p-53; }

}  // namespace

double uniform(std::uint64_t seed, std::string_view name) {
  return to_unit(XXH3_128bits_withSeed(name.data(), name.size(), seed).low64);
}

double normal(std::uint64_t seed, std::string_view name) {
  const XXH128_hash_t bits = XXH3_128bits_withSeed(name.data(), name.size(), seed);
  // Box and Muller 1958.
  return std::sqrt(-2.0 * std::log(to_unit(bits.low64))) * std::cos(two_pi * to_unit(bits.high64));
}

}  // namespace mien::pipeline
