#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace mien::render {

// Powers of floats by additions, multiplications and divisions alone, in a fixed order. Unlike
// those of a C library they are bit-identical on every machine, and loops over them vectorise.

/// The cube root of x ≥ 0, within 2 units in the last place; 0 for x below 10⁻³⁷.
inline float cube_root(float x) {
  // A third of the exponent is a guess within 4 %; each of Halley's steps cubes the error.
  const auto third =
      static_cast<std::int32_t>(static_cast<float>(std::bit_cast<std::int32_t>(x)) * (1.0f / 3.0f));
  float root = std::bit_cast<float>(third + 0x2a5137a0);
  for (int step = 0; step < 2; ++step) {
    const float cube = root * root * root;
    root *= (cube + 2.0f * x) / (2.0f * cube + x);
  }
  return x < 1e-37f ? 0.0f : root;
}

/// The binary logarithm of x ≥ 2⁻¹²⁶, with an error of at most 3·10⁻⁷ plus 2 units in the last
/// place.
inline float binary_logarithm(float x) {
  // x = 2^exponent · m with m in [√½, √2).
  const auto bits = std::bit_cast<std::int32_t>(x);
  const std::int32_t exponent = (bits - 0x3f3504f3) >> 23;
  const float m = std::bit_cast<float>(bits - (exponent << 23));
  // ln m = 2 artanh((m − 1) / (m + 1))
  const float s = (m - 1.0f) / (m + 1.0f);
  const float square = s * s;
  const float tail =
      square *
      (1.0f / 3.0f + square * (1.0f / 5.0f + square * (1.0f / 7.0f + square * (1.0f / 9.0f))));
  return static_cast<float>(exponent) + 2.88539008f * (s + s * tail);
}

/// 2^x for −126 ≤ x ≤ 127, with a relative error of at most 3·10⁻⁷.
inline float power_of_two(float x) {
  constexpr float to_whole = 12582912.0f;  // 1.5 · 2²³: sums with it have no fraction
  const float shifted = x + to_whole;
  const float whole = shifted - to_whole;
  const float f = (x - whole) * 0.693147181f;
  const float series =
      1.0f + f * (1.0f + f * (0.5f + f * (1.0f / 6.0f +
                                          f * (1.0f / 24.0f +
                                               f * (1.0f / 120.0f +
                                                    f * (1.0f / 720.0f + f * (1.0f / 5040.0f)))))));
  const auto exponent = static_cast<std::int32_t>(whole);
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(series) + (exponent << 23));
}

/// base^exponent for 0 ≤ base ≤ 10⁹ and 0 ≤ exponent ≤ 1, with a relative error of at most 3·10⁻⁶.
/// The result is 1 for the exponent 0, also of the base 0. Otherwise it is 0 for bases below
/// 1.2·10⁻³⁸ and in place of results below 2⁻¹²⁵.
inline float power(float base, float exponent) {
  const float safe = base < 1.2e-38f ? 1.2e-38f : base;
  const float logarithm = exponent * binary_logarithm(safe);
  const float clamped = logarithm < -125.0f ? -125.0f : logarithm;
  const float result = power_of_two(clamped);
  const bool nothing = (base < 1.2e-38f) | (logarithm < -125.0f);
  return nothing ? (exponent == 0.0f ? 1.0f : 0.0f) : result;
}

}  // namespace mien::render
