#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <string>

namespace mien::motion {

/// A number for a message, with at most six significant digits and no zeros at the end: "25",
/// "0.04", "119.88". Independent of the locale.
inline std::string plain_number(double value) {
  std::array<char, 32> digits;
  const std::to_chars_result result = std::to_chars(digits.data(), digits.data() + digits.size(),
                                                    value, std::chars_format::general, 6);
  return {digits.data(), static_cast<std::size_t>(result.ptr - digits.data())};
}

}  // namespace mien::motion
