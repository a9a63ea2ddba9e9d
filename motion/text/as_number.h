#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace mien::motion {

/// Parses the whole text as a number; it must not begin with blanks or a plus sign. Returns nothing
/// for any other text and for a number that `Number` cannot represent. Floating-point types also
/// accept "inf" and "nan".
template <class Number>
std::optional<Number> as_number(std::string_view text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

/// Like `as_number`, but returns nothing for infinities and NaN.
inline std::optional<double> as_finite_number(std::string_view text) {
  const std::optional<double> number = as_number<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

/// Like `as_finite_number`, but also accepts a leading plus sign, as in numbers written by people.
inline std::optional<double> as_written_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  return as_finite_number(text);
}

}  // namespace mien::motion
