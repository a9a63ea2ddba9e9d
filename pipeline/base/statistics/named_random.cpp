#include "pipeline/base/statistics/named_random.h"

#include <cmath>

#include <xxhash.h>

#include "motion/math/random_number.h"

namespace mien::pipeline {

using motion::open_unit_number;

namespace {

constexpr double two_pi = 6.28318530717958647692;

}  // namespace

double uniform(std::uint64_t seed, std::string_view name) {
  return open_unit_number(XXH3_128bits_withSeed(name.data(), name.size(), seed).low64);
}

double normal(std::uint64_t seed, std::string_view name) {
  const XXH128_hash_t bits = XXH3_128bits_withSeed(name.data(), name.size(), seed);
  // Box and Muller 1958.
  return std::sqrt(-2.0 * std::log(open_unit_number(bits.low64))) *
         std::cos(two_pi * open_unit_number(bits.high64));
}

}  // namespace mien::pipeline
