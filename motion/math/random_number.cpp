#include "motion/math/random_number.h"

#include <algorithm>

namespace mien::motion {

std::uint64_t random_bits(std::uint64_t seed, std::uint64_t n) {
  std::uint64_t bits = seed + (n + 1) * 0x9e3779b97f4a7c15u;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

double centred_number(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1.0p-52 - 1.0;
}

double open_unit_number(std::uint64_t bits) {
  // 2⁵³ − ½ is no double and would round to 1.
  return std::min((static_cast<double>(bits >> 11) + 0.5) * 0x1.0p-53, 1.0 - 0x1.0p-53);
}

double random_number(std::uint64_t seed, std::string_view name, std::uint64_t index) {
  std::uint64_t start = 14695981039346656037u ^ seed;
  for (const char letter : name) {
    start = (start ^ static_cast<unsigned char>(letter)) * 1099511628211u;
  }
  return centred_number(random_bits(start, index));
}

}  // namespace mien::motion
