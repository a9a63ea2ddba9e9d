#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace mien::motion {

// Numbers of a C3D file. The processor that wrote it decides the order of their bytes
// (c3d.org, "C3D User Guide": "Integers and Bytes", "Floating-point").

inline constexpr std::size_t block_bytes = 512;

/// As the parameter section states it in its fourth byte.
enum class C3dProcessor { intel = 84, dec = 85, mips = 86 };

inline std::uint32_t byte_at(const char* at) { return static_cast<unsigned char>(*at); }

/// 16 bits at a position, unsigned.
template <C3dProcessor processor>
std::uint16_t c3d_word(const char* at) {
  const bool big = processor == C3dProcessor::mips;
  return static_cast<std::uint16_t>(byte_at(at + (big ? 0 : 1)) << 8 | byte_at(at + (big ? 1 : 0)));
}

/// A float at a position: IEEE little-endian (Intel), IEEE big-endian (MIPS), or the F format of
/// DEC, which stores its upper half first and whose exponents are larger by 2; DEC's reserved
/// operand becomes NaN.
template <C3dProcessor processor>
float c3d_real(const char* at) {
  const std::uint32_t first = c3d_word<processor>(at);
  const std::uint32_t second = c3d_word<processor>(at + 2);
  if constexpr (processor == C3dProcessor::intel) return std::bit_cast<float>(second << 16 | first);
  std::uint32_t bits = first << 16 | second;
  if constexpr (processor == C3dProcessor::dec) {
    const std::uint32_t exponent = bits >> 23 & 0xff;
    if (exponent == 0 && first >> 15 != 0) return std::numeric_limits<float>::quiet_NaN();
    bits = exponent > 2 ? bits - (std::uint32_t{2} << 23) : 0;
  }
  return std::bit_cast<float>(bits);
}

inline std::uint16_t c3d_word(const char* at, C3dProcessor processor) {
  return processor == C3dProcessor::mips ? c3d_word<C3dProcessor::mips>(at)
                                         : c3d_word<C3dProcessor::intel>(at);
}

inline float c3d_real(const char* at, C3dProcessor processor) {
  if (processor == C3dProcessor::mips) return c3d_real<C3dProcessor::mips>(at);
  if (processor == C3dProcessor::dec) return c3d_real<C3dProcessor::dec>(at);
  return c3d_real<C3dProcessor::intel>(at);
}

}  // namespace mien::motion
