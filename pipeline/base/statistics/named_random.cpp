#include "pipeline/base/statistics/named_random.h"

#include <cmath>

#include <xxhash.h>

#include "motion/math/random_number.h"

namespace mien::pipeline {

using motion::open_unit_number;

namespace {

constexpr double two_pi = 6.28318530717958647692;

/// A standard normal number from two random ones (Box and Muller 1958).
double normal_of(std::uint64_t radius, std::uint64_t angle) {
  return std::sqrt(-2.0 * std::log(open_unit_number(radius))) *
         std::cos(two_pi * open_unit_number(angle));
}

}  // namespace

double uniform(std::uint64_t seed, std::string_view name) {
  return open_unit_number(XXH3_128bits_withSeed(name.data(), name.size(), seed).low64);
}

double normal(std::uint64_t seed, std::string_view name) {
  const XXH128_hash_t bits = XXH3_128bits_withSeed(name.data(), name.size(), seed);
  return normal_of(bits.low64, bits.high64);
}

double normal_number(std::uint64_t stream, std::uint64_t n) {
  return normal_of(motion::random_bits(stream, 2 * n), motion::random_bits(stream, 2 * n + 1));
}

}  // namespace mien::pipeline
