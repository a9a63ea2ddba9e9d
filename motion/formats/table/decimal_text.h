#pragma once

#include <array>
#include <charconv>
#include <string>

namespace mien::motion {

/// Appends a finite number with at most so many decimals, without zeros at the end: "1.25", "-3",
/// "0" for −0 too.
inline void append_decimal(std::string& text, double value, int most_decimals) {
  std::array<char, 400> digits{};  // a double has up to 309 digits before the point
  char* const begin = digits.data();
  char* end =
      std::to_chars(begin, begin + digits.size(), value, std::chars_format::fixed, most_decimals)
          .ptr;
  if (most_decimals > 0) {
    while (end[-1] == '0') --end;
    if (end[-1] == '.') --end;
  }
  const std::string_view written(begin, static_cast<std::size_t>(end - begin));
  text += written == "-0" ? std::string_view("0") : written;
}

/// Appends the shortest decimal that reads back as the same number.
inline void append_shortest(std::string& text, double value) {
  std::array<char, 32> digits{};
  text.append(
      digits.data(),
      std::to_chars(digits.data(), digits.data() + digits.size(), value == 0.0 ? 0.0 : value).ptr);
}

}  // namespace mien::motion
