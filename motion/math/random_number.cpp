#include "motion/math/random_number.h"

namespace mien::motion {

double random_number(std::uint64_t seed, std::string_view name, std::uint64_t index) {
  std::uint64_t bits = 14695981039346656037u ^ seed;
  for (const char letter : name) {
    bits = (bits ^ static_cast<unsigned char>(letter)) * 1099511628211u;
  }
  bits += 0x9e3779b97f4a7c15u * (index + 1);
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  bits ^= bits >> 31;
  return static_cast<double>(bits >> 11) * 0x1.0p-52 - 1.0;
}

}  // namespace mien::motion
