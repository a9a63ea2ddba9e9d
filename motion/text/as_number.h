#pragma once

#include <charconv>
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

}  // namespace mien::motion
