#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

namespace mien::motion {

// The words and numbers of which the values of FBX files consist.

/// The little-endian number at `bytes`.
template <class Number>
Number bytes_as(const char* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

/// Like a cast, but defined for any number: 0 for those beyond the range of int64.
std::int64_t as_integer(double number);

/// White space and commas, which separate the values of text files.
bool is_fbx_separator(char c);

/// Removes white space, commas and comments from the start of a text.
void skip_fbx_separators(std::string_view& text);

/// The word at the start of a text, up to white space, a comma, a quotation mark or a comment; at
/// least one character.
std::string_view fbx_word(std::string_view text);

/// Reads a decimal number; those too small for a double are zero. Returns where it ends, null if
/// there is none.
const char* parse_fbx_decimal(const char* start, const char* end, double& number);

}  // namespace mien::motion
