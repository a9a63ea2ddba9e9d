#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace mien::motion {

/// The number that a text is from its first character to its last, without blanks or a plus sign
/// before it; nothing for another text, and for a number that `Number` cannot hold. Of floating
/// point it takes "inf" and "nan" too.
template <class Number>
std::optional<Number> as_number(std::string_view text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

/// As `as_number`, but nothing for infinities and NaN.
inline std::optional<double> as_finite_number(std::string_view text) {
  const std::optional<double> number = as_number<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

/// A finite number as people write it: it may have a plus, too.
inline std::optional<double> as_written_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  return as_finite_number(text);
}

}  // namespace mien::motion
